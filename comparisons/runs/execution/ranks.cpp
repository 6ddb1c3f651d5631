#include "comparisons/runs/execution/executor.hpp"

#include <mpi.h>

#include <chrono>
#include <cstdint>
#include <exception>
#include <stdexcept>
#include <thread>

namespace rockstack {
namespace {

// A rank says "ready", "finished" with the lines of a task, or "failed" with the reason; the leader answers
// each with the number of a task, or with none. So a rank always waits for an answer, and the leader for
// nobody.
enum Tag { ready = 1, finished, failed, answer };

constexpr int leader = 0;
constexpr std::uint64_t none = ~std::uint64_t{0};

struct Message {
  int rank = 0;
  int tag = 0;
  std::string text;
};

/// The next message from any rank. Sleeps between looks: MPI's own waiting would keep a core busy.
Message receive() {
  MPI_Status status;
  for (int there = 0; there == 0;) {
    MPI_Iprobe(MPI_ANY_SOURCE, MPI_ANY_TAG, MPI_COMM_WORLD, &there, &status);
    if (there == 0) std::this_thread::sleep_for(std::chrono::microseconds(200));
  }
  int length = 0;
  MPI_Get_count(&status, MPI_CHAR, &length);
  Message message{status.MPI_SOURCE, status.MPI_TAG, std::string(static_cast<std::size_t>(length), '\0')};
  MPI_Recv(message.text.data(), length, MPI_CHAR, message.rank, message.tag, MPI_COMM_WORLD,
           MPI_STATUS_IGNORE);
  return message;
}

void send(const std::string& text, int rank, int tag) {
  MPI_Send(text.data(), static_cast<int>(text.size()), MPI_CHAR, rank, tag, MPI_COMM_WORLD);
}

class Ranks : public Executor {
 public:
  Ranks(int rank, std::size_t others)
      : Executor(std::to_string(others) + " MPI ranks and one that leads", others, rank == leader),
        busy_(others) {}

  /// The leader lets all others go, whatever has happened to itself.
  ~Ranks() override {
    while (leads() && busy_ > 0) dismiss(receive().rank);
    MPI_Finalize();
  }

  void run(const std::vector<std::size_t>& tasks, const Work& work) override {
    std::vector<std::uint64_t> given(count() + 1, none);
    std::size_t next = 0;
    while (busy_ > 0) {
      const Message message = receive();
      std::uint64_t& task = given[static_cast<std::size_t>(message.rank)];
      if (message.tag == failed) {
        dismiss(message.rank);
        throw std::runtime_error("rank " + std::to_string(message.rank) + ": " + message.text);
      }
      if (message.tag == finished) work.deliver(static_cast<std::size_t>(task), message.text);
      while (next < tasks.size() && work.needless(tasks[next])) ++next;
      if (next == tasks.size() || work.stopped()) {
        dismiss(message.rank);
      } else {
        task = tasks[next++];
        MPI_Send(&task, 1, MPI_UINT64_T, message.rank, answer, MPI_COMM_WORLD);
      }
    }
  }

  void serve(const std::function<std::string(std::size_t task)>& compute) override {
    send("", leader, ready);
    for (std::uint64_t task = next_task(); task != none; task = next_task()) {
      try {
        send(compute(static_cast<std::size_t>(task)), leader, finished);
      } catch (const std::exception& error) {
        send(error.what(), leader, failed);
      }
    }
  }

 private:
  void dismiss(int rank) {
    --busy_;
    MPI_Send(&none, 1, MPI_UINT64_T, rank, answer, MPI_COMM_WORLD);
  }

  static std::uint64_t next_task() {
    std::uint64_t task = none;
    MPI_Recv(&task, 1, MPI_UINT64_T, leader, answer, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
    return task;
  }

  std::size_t busy_;  ///< of the leader: how many others have not been let go
};

}  // namespace

std::unique_ptr<Executor> find_ranks() {
  if (MPI_Init(nullptr, nullptr) != MPI_SUCCESS) throw std::runtime_error("MPI cannot start");
  int rank = 0, size = 1;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm_size(MPI_COMM_WORLD, &size);
  if (size > 1) return std::make_unique<Ranks>(rank, static_cast<std::size_t>(size - 1));
  MPI_Finalize();
  return nullptr;
}

}  // namespace rockstack
