#pragma once

#include <chrono>
#include <cstddef>
#include <string>

namespace rockstack::live {

/// A socket that gives up: reads end after so many bytes or so long, whatever they hold. It is not closed
/// with this.
class Connection {
 public:
  /// `bytes`: that may be read; `seconds`: until all of them are there, and likewise of each write.
  Connection(int socket, std::size_t bytes, double seconds);

  /// As read(2) and write(2), but that writes are whole; −1: no more.
  std::ptrdiff_t read(char* to, std::size_t size);
  std::ptrdiff_t write(const char* from, std::size_t size) const;

  bool can_read() const;  ///< before the time is over
  bool is_open() const;   ///< the other side has not closed it
  int socket() const { return socket_; }

 private:
  using Clock = std::chrono::steady_clock;
  int socket_;
  std::size_t left_;
  Clock::duration allowed_;
  Clock::time_point end_;
};

}  // namespace rockstack::live
