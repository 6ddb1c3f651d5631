#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <nlohmann/json.hpp>
#include <semaphore>

#include "analytic/scene/ground/motion_library.hpp"
#include "comparisons/interfaces/live/live_page.hpp"

namespace rockstack::live {

/// What pages ask for. Each kind has a newest request of each page; exact answers never wait for engines.
enum class Kind { exact, engine, cloud };

/// Who asks: a page, and its requests in order.
struct Client {
  std::string page;
  Kind kind = Kind::exact;
  std::uint64_t sequence = 0;
};

/// Too many requests wait already, or one has waited for too long.
class Busy : public std::runtime_error {
 public:
  Busy() : std::runtime_error("busy with other requests: ask again in a second") {}
};

/// All that is wrong with a request, a line each.
class Faults : public std::invalid_argument {
 public:
  explicit Faults(std::vector<std::string> all)
      : std::invalid_argument("a request with several faults"), lines(std::move(all)) {}
  std::vector<std::string> lines;
};

/// The state that was read last without a fault; none before the first.
struct SoundState {
  std::mutex mutex;
  std::shared_ptr<const Json> state;
};

/// Keeps to a few runs at a time and a few that wait, and knows which are superseded. Safe to call from
/// several threads. What it remembers of pages stays bounded: of the oldest it forgets that they asked.
class Scheduler {
 public:
  /// `places` and `waiting`: of exact runs, and as many of engines.
  Scheduler(std::ptrdiff_t places, std::ptrdiff_t waiting)
      : exact_{std::counting_semaphore<>(places), std::counting_semaphore<>(waiting)},
        engines_{std::counting_semaphore<>(places), std::counting_semaphore<>(waiting)} {}

  /// A request, which supersedes older ones of its kind and page.
  void note(const Client& client);
  bool is_superseded(const Client& client) const;

  /// Does `run` once there is a place, unless it is cancelled, which is asked while it waits. @throws Busy
  void serve(Kind kind, const std::function<bool()>& cancelled, const std::function<void()>& run);

 private:
  struct Queue {
    std::counting_semaphore<> places, waiting;
  };

  mutable std::mutex mutex_;
  Queue exact_, engines_;
  std::map<std::string, std::array<std::uint64_t, 3>> newest_;
  std::deque<std::string> pages_;  ///< in order of their arrival
};

/// Answers what pages ask, each run in a process of its own that ends once its request is cancelled.
class Requests {
 public:
  /// `records`: that scenes may name.
  explicit Requests(std::set<std::string> records);

  /// {"page", "sequence", "kind": "exact", "engine" or "cloud", "member", "state"}: what live_state.hpp says,
  /// with "milliseconds", or "failure" with the reason, or "dropped" for what is cancelled: superseded, or
  /// `gone`, which is asked now and then: whether the page has left. Safe to call from several threads.
  /// @throws Faults, InputError, std::invalid_argument or nlohmann::json::exception for a request that is
  /// none; Busy.
  std::string answer(const std::string& text, const std::function<bool()>& gone);

  /// {"state", "name", "runs"}: the texts "scene" and "suite" of files to save. @throws likewise.
  std::string files(const std::string& text);

  std::size_t most_at_once() const;  ///< that run or wait

 private:
  std::set<std::string> records_;
  MotionLibrary library_{std::size_t{16} << 20U};
  SoundState sound_;
  Scheduler scheduler_;
};

/// Serves a page, its requests and the lessons beside it on this machine alone, until the program ends: on
/// 127.0.0.1, to who knows the token and calls the server by this address. A connection carries one request,
/// of limited length and time. `port` 0: any that is free.
/// `listening` is told the address, with a token that is drawn anew each time: of the lessons, where there
/// are any, else of the page. @throws std::runtime_error where the port is taken.
void serve(LivePage page, int port, const std::function<void(const std::string& address)>& listening);

}  // namespace rockstack::live
