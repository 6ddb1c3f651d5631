#include "comparisons/interfaces/live/desk.hpp"

#include <algorithm>
#include <chrono>

namespace rockstack::live {

void Desk::note(const Asker& asker) {
  constexpr std::size_t most_pages = 64;
  const std::lock_guard lock(mutex_);
  const auto [entry, fresh] = newest_.try_emplace(asker.page);
  if (fresh) pages_.push_back(asker.page);
  std::uint64_t& newest = entry->second[static_cast<std::size_t>(asker.kind)];
  newest = std::max(newest, asker.sequence);
  if (pages_.size() <= most_pages) return;
  newest_.erase(pages_.front());
  pages_.pop_front();
}

bool Desk::is_superseded(const Asker& asker) const {
  const std::lock_guard lock(mutex_);
  const auto found = newest_.find(asker.page);
  return found != newest_.end() && found->second[static_cast<std::size_t>(asker.kind)] > asker.sequence;
}

bool Desk::serve(Kind kind, const std::function<bool()>& unwanted, const std::function<void()>& run) {
  constexpr std::chrono::milliseconds tick{5};
  std::size_t& taken = taken_[kind == Kind::exact ? 0 : 1];
  {
    std::unique_lock lock(mutex_);
    while (taken >= places_) {
      left_.wait_for(lock, tick);
      lock.unlock();
      if (unwanted()) return false;
      lock.lock();
    }
    ++taken;
  }
  const auto leave = [&] {
    {
      const std::lock_guard lock(mutex_);
      --taken;
    }
    left_.notify_all();
  };
  try {
    run();
  } catch (...) {
    leave();
    throw;
  }
  leave();
  return true;
}

}  // namespace rockstack::live
