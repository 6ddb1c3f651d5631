#include <algorithm>
#include <exception>
#include <mutex>
#include <thread>

#include "comparisons/runs/execution/executor.hpp"

namespace rockstack {
namespace {

/// The tasks not yet begun, and the first failure.
class Queue {
 public:
  Queue(const std::vector<std::size_t>& tasks, const Work& work) : tasks_(tasks), work_(work) {}

  /// What each thread does.
  void work() {
    try {
      for (std::size_t task = 0; next(task);) {
        const std::string text = work_.compute(task);
        const std::lock_guard lock(mutex_);
        work_.deliver(task, text);
      }
    } catch (...) {
      const std::lock_guard lock(mutex_);
      if (!failure_) failure_ = std::current_exception();
    }
  }

  void rethrow() const {
    if (failure_) std::rethrow_exception(failure_);
  }

 private:
  bool next(std::size_t& task) {
    const std::lock_guard lock(mutex_);
    while (next_ < tasks_.size() && work_.needless(tasks_[next_])) ++next_;
    if (failure_ || next_ == tasks_.size() || work_.stopped()) return false;
    task = tasks_[next_++];
    return true;
  }

  const std::vector<std::size_t>& tasks_;
  const Work& work_;
  std::mutex mutex_;
  std::size_t next_ = 0;
  std::exception_ptr failure_;
};

class Threads : public Executor {
 public:
  explicit Threads(std::size_t count) : count_(count) {}

  std::string description() const override {
    return std::to_string(count_) + (count_ == 1 ? " thread" : " threads");
  }
  std::size_t count() const override { return count_; }
  bool leads() const override { return true; }

  void run(const std::vector<std::size_t>& tasks, const Work& work) override {
    Queue queue(tasks, work);
    {
      std::vector<std::jthread> threads;
      for (std::size_t i = 0; i < count_; ++i) threads.emplace_back([&queue] { queue.work(); });
    }
    queue.rethrow();
  }

  void serve(const std::function<std::string(std::size_t task)>& /*compute*/) override {}

 private:
  std::size_t count_;
};

}  // namespace

std::size_t all_cores() {
  return std::max(1U, std::thread::hardware_concurrency());
}

std::unique_ptr<Executor> make_threads(std::size_t count) {
  return std::make_unique<Threads>(count);
}

}  // namespace rockstack
