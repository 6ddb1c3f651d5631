#pragma once

#include <array>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <mutex>
#include <string>

namespace rockstack::live {

/// What pages ask for. Each kind has a newest question of each page; exact answers never wait for engines.
enum class Kind { exact, engine, cloud };

/// Who asks: a page, and its questions in order.
struct Asker {
  std::string page;
  Kind kind = Kind::exact;
  std::uint64_t sequence = 0;
};

/// Keeps to a few runs at a time, and knows which are still wanted. Safe to call from several threads. What
/// it remembers of pages stays bounded: of the oldest it forgets that they asked.
class Desk {
 public:
  explicit Desk(std::size_t places) : places_(places) {}

  /// A question, which makes older ones of its kind and page unwanted.
  void note(const Asker& asker);
  bool is_superseded(const Asker& asker) const;

  /// Does `run` once there is a place; `unwanted` is asked while it waits.
  /// @return whether it was done.
  bool serve(Kind kind, const std::function<bool()>& unwanted, const std::function<void()>& run);

 private:
  mutable std::mutex mutex_;
  std::condition_variable left_;
  std::size_t places_;
  std::array<std::size_t, 2> taken_{};  ///< by exact runs, and by engines
  std::map<std::string, std::array<std::uint64_t, 3>> newest_;
  std::deque<std::string> pages_;  ///< in order of their arrival
};

}  // namespace rockstack::live
