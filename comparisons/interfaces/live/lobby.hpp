#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace rockstack::live {

inline constexpr std::chrono::seconds reading_time{10};  ///< of a whole request, and of each write

using Clock = std::chrono::steady_clock;

/// Waits for an event on a socket. @return whether it came before the end.
bool wait_for(int socket, short event, Clock::time_point end);

void close_both_ways(int socket);

/// Reads the first line of every connection, many at once in one thread, and nothing more of one that may not
/// come in: it is told why and closed. So is one that is silent for too long, and of very many the oldest.
class Lobby {
 public:
  struct Door {
    std::function<bool(const std::string& line)> admits;
    std::string refusal;  ///< the answer to others
    /// Has another thread serve it and close the socket.
    std::function<void(int socket, std::string begun)> let_in;
  };

  explicit Lobby(Door door);
  ~Lobby();
  Lobby(const Lobby&) = delete;
  Lobby& operator=(const Lobby&) = delete;

  void add(int socket);

 private:
  struct Guest {
    int socket = -1;
    std::string begun = {};
    bool refused = false;
    Clock::time_point end = Clock::now() + reading_time;
  };

  void watch();
  void hear(Guest& guest);
  void close_late_ones();

  Door door_;
  std::mutex mutex_;
  std::vector<int> arrived_;  ///< not yet among the guests
  bool over_ = false;
  int bell_;                   ///< rings when one has arrived
  std::vector<Guest> guests_;  ///< of the watching thread, in order of arrival; without socket: gone
  std::thread watching_;
};

}  // namespace rockstack::live
