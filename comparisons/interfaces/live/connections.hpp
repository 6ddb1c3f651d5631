#pragma once

#include <httplib.h>

#include <chrono>
#include <functional>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace rockstack::live {

inline constexpr std::size_t longest_request = std::size_t{512} << 10U;  ///< bytes, headers included
inline constexpr std::chrono::seconds reading_time{10};  ///< of a whole request, and of each write

void close_both_ways(int socket);

using Clock = std::chrono::steady_clock;

/// A connection that gives up: reads end after so many bytes or so long, whatever they hold. The socket is
/// not closed with this.
class BoundedStream : public httplib::Stream {
 public:
  /// `begun`: what has been read of it.
  BoundedStream(int socket, std::string begun) : socket_(socket), begun_(std::move(begun)) {}

  bool is_readable() const override;
  bool is_writable() const override;  ///< whether the other side has not closed it
  ssize_t read(char* to, std::size_t size) override;
  ssize_t write(const char* from, std::size_t size) override;  ///< all of it, or −1

  void get_remote_ip_and_port(std::string& ip, int& port) const override;
  void get_local_ip_and_port(std::string& ip, int& port) const override { get_remote_ip_and_port(ip, port); }
  socket_t socket() const override { return socket_; }

 private:
  int socket_;
  std::string begun_;
  std::size_t heard_ = 0;  ///< of that
  std::size_t left_ = longest_request;
  Clock::time_point end_ = Clock::now() + reading_time;
};

/// Reads the first line of every connection, many at once in one thread, and nothing more of one that may not
/// come in: it is told why and closed. So is one that is silent for too long, and of very many the oldest.
/// Those that may come in are served by threads of their own.
class Lobby : public httplib::TaskQueue {
 public:
  struct Door {
    std::function<bool(const std::string& line)> admits;
    std::string refusal;                                       ///< the answer to others
    std::function<void(int socket, std::string begun)> serve;  ///< closes the socket
  };

  Lobby(std::size_t threads, Door door);

  void add(int socket);

  void enqueue(std::function<void()> accepted) override { accepted(); }
  void shutdown() override;

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
  httplib::ThreadPool pool_;
  std::mutex mutex_;
  std::vector<int> arrived_;  ///< not yet among the guests
  bool over_ = false;
  int bell_;  ///< rings when one has arrived
  std::vector<Guest>
      guests_;  ///< of the watching thread, in the order of their arrival; without socket: gone
  std::thread watching_;
};

}  // namespace rockstack::live
