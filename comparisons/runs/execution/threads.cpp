#include <algorithm>
#include <exception>
#include <mutex>
#include <optional>
#include <thread>

#include "comparisons/runs/execution/executor.hpp"

namespace rockstack {
namespace {

class Threads : public Executor {
 public:
  explicit Threads(std::size_t count)
      : Executor(std::to_string(count) + (count == 1 ? " thread" : " threads"), count, true) {}

  void run(const std::vector<std::size_t>& tasks, const Work& work) override {
    std::mutex mutex;
    std::exception_ptr failure;
    auto left = tasks.begin();
    const auto next = [&]() -> std::optional<std::size_t> {
      while (left != tasks.end() && work.needless(*left)) ++left;
      if (failure || left == tasks.end() || work.stopped()) return std::nullopt;
      return *left++;
    };
    const auto make_tasks = [&] {
      std::unique_lock lock(mutex);  // but while a task is computed
      try {
        while (const auto task = next()) {
          lock.unlock();
          const std::string text = work.compute(*task);
          lock.lock();
          work.deliver(*task, text);
        }
      } catch (...) {
        if (!lock) lock.lock();
        if (!failure) failure = std::current_exception();
      }
    };
    {
      std::vector<std::jthread> threads;
      for (std::size_t i = 0; i < count(); ++i) threads.emplace_back(make_tasks);
    }
    if (failure) std::rethrow_exception(failure);
  }
};

}  // namespace

std::size_t all_cores() {
  return std::max(1U, std::thread::hardware_concurrency());
}

std::unique_ptr<Executor> make_threads(std::size_t count) {
  return std::make_unique<Threads>(count);
}

}  // namespace rockstack
