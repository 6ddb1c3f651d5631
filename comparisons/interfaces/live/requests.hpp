#pragma once

#include <array>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <filesystem>
#include <functional>
#include <map>
#include <mutex>
#include <set>
#include <string>

#include "analytic/scene/ground/motion_library.hpp"

namespace rockstack::live {

/// What pages ask for. Each kind has a newest request of each page; exact answers never wait for engines.
enum class Kind { exact, engine, cloud };

/// Who asks: a page, and its requests in order.
struct Client {
  std::string page;
  Kind kind = Kind::exact;
  std::uint64_t sequence = 0;
};

/// Keeps to a few runs at a time, and knows which are superseded. Safe to call from several threads. What it
/// remembers of pages stays bounded: of the oldest it forgets that they asked.
class Scheduler {
 public:
  explicit Scheduler(std::size_t places) : places_(places) {}

  /// A request, which supersedes older ones of its kind and page.
  void note(const Client& client);
  bool is_superseded(const Client& client) const;

  /// Does `run` once there is a place, unless it is cancelled, which is asked while it waits.
  void serve(Kind kind, const std::function<bool()>& cancelled, const std::function<void()>& run);

 private:
  mutable std::mutex mutex_;
  std::condition_variable left_;
  std::size_t places_;
  std::array<std::size_t, 2> taken_{};  ///< by exact runs, and by engines
  std::map<std::string, std::array<std::uint64_t, 3>> newest_;
  std::deque<std::string> pages_;  ///< in order of their arrival
};

/// Answers what pages ask, each run in a process of its own that ends once its request is cancelled.
class Requests {
 public:
  /// `solver`: the program of exact_worker.cpp; `records`: that scenes may name.
  Requests(std::filesystem::path solver, std::set<std::string> records);

  /// {"page", "sequence", "kind": "exact", "engine" or "cloud", "member", "state"}: what answers.hpp says,
  /// with "milliseconds", or "failure" with the reason, or "dropped" for what is cancelled: superseded, or
  /// `gone`, which is asked now and then: whether the page has left. Safe to call from several threads.
  /// @throws InputError, std::invalid_argument or nlohmann::json::exception for a request that is none.
  std::string answer(const std::string& text, const std::function<bool()>& gone);

  /// {"state", "name", "runs"}: the texts "scene" and "suite" of files to save. @throws likewise.
  std::string files(const std::string& text);

 private:
  std::filesystem::path solver_;
  std::set<std::string> records_;
  MotionLibrary library_{std::size_t{16} << 20U};
  Scheduler scheduler_;
};

}  // namespace rockstack::live
