#include <exception>
#include <mutex>
#include <thread>

#include "comparisons/runs/execution/executor.hpp"

namespace rockstack {
namespace {

/// The parts not yet begun, and the first failure.
class Queue {
 public:
  Queue(const std::vector<std::size_t>& parts, const Work& work) : parts_(parts), work_(work) {}

  /// What each thread does.
  void work() {
    try {
      for (std::size_t part = 0; next(part);) {
        const std::string text = work_.compute(part);
        const std::lock_guard lock(mutex_);
        work_.deliver(part, text);
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
  bool next(std::size_t& part) {
    const std::lock_guard lock(mutex_);
    while (next_ < parts_.size() && work_.needless(parts_[next_])) ++next_;
    if (failure_ || next_ == parts_.size() || work_.stopped()) return false;
    part = parts_[next_++];
    return true;
  }

  const std::vector<std::size_t>& parts_;
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

  void run(const std::vector<std::size_t>& parts, const Work& work) override {
    Queue queue(parts, work);
    {
      std::vector<std::jthread> threads;
      for (std::size_t i = 0; i < count_; ++i) threads.emplace_back([&queue] { queue.work(); });
    }
    queue.rethrow();
  }

  void serve(const std::function<std::string(std::size_t part)>& /*compute*/) override {}

 private:
  std::size_t count_;
};

}  // namespace

std::unique_ptr<Executor> make_threads(std::size_t count) {
  return std::make_unique<Threads>(count);
}

}  // namespace rockstack
