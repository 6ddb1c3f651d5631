#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace rockstack {

/// Work in tasks that can be worked on in any order.
struct Work {
  std::function<std::string(std::size_t task)> compute;  ///< from any thread
  /// From one thread at a time.
  std::function<void(std::size_t task, const std::string&)> deliver = [](std::size_t, const std::string&) {};
  /// True: no further task is begun, those begun are finished.
  std::function<bool()> stopped = [] { return false; };
  /// True for a task that need not be made after all, by what was delivered so far.
  std::function<bool(std::size_t task)> needless = [](std::size_t) { return false; };
};

/// Executes some work task by task: in threads of this process, or in processes on several machines of which
/// one leads and the others only compute.
class Executor {
 public:
  Executor(std::string description, std::size_t count, bool leads)
      : description_(std::move(description)), count_(count), leads_(leads) {}
  virtual ~Executor() = default;
  Executor(const Executor&) = delete;
  Executor& operator=(const Executor&) = delete;

  /// How many compute at a time, for reports: "2 threads".
  const std::string& description() const { return description_; }
  std::size_t count() const { return count_; }

  /// True where this process gives out the tasks and keeps what is delivered.
  bool leads() const { return leads_; }

  /// Leader only: has every task computed, and passes each result to deliver(). @throws what compute and
  /// deliver throw.
  virtual void run(const std::vector<std::size_t>& tasks, const Work& work) = 0;

  /// Others only: computes tasks until the leader has no more.
  virtual void serve(const std::function<std::string(std::size_t task)>& /*compute*/) {}

 private:
  std::string description_;
  std::size_t count_;
  bool leads_;
};

/// How many threads the machine runs at once, ≥ 1.
std::size_t all_cores();

/// Threads of this process. Precondition: count ≥ 1.
std::unique_ptr<Executor> make_threads(std::size_t count);

/// Processes that mpirun has started together (in a library of its own, rockstack_ranks): the first leads,
/// each of the others computes a task at a time. Nothing where this process was started alone. To be called
/// once in a process.
/// @throws std::runtime_error where MPI cannot start.
std::unique_ptr<Executor> find_ranks();

}  // namespace rockstack
