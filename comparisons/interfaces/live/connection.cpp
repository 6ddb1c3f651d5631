#include "comparisons/interfaces/live/connection.hpp"

#include <poll.h>
#include <sys/socket.h>

#include <algorithm>
#include <cerrno>

namespace rockstack::live {
namespace {

using Clock = std::chrono::steady_clock;

/// Waits for an event on a socket. @return whether it came before the end.
bool wait_for(int socket, short event, Clock::time_point end) {
  for (;;) {
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(end - Clock::now()).count();
    pollfd watched{socket, event, 0};
    const int count = poll(&watched, 1, static_cast<int>(std::max<std::int64_t>(0, left)));
    if (count > 0) return true;
    if (count == 0 || errno != EINTR) return false;
  }
}

}  // namespace

Connection::Connection(int socket, std::size_t bytes, double seconds)
    : socket_(socket),
      left_(bytes),
      allowed_(std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds))),
      end_(Clock::now() + allowed_) {}

bool Connection::can_read() const {
  return left_ > 0 && wait_for(socket_, POLLIN, end_);
}

std::ptrdiff_t Connection::read(char* to, std::size_t size) {
  if (!can_read()) return -1;
  const std::ptrdiff_t count = recv(socket_, to, std::min(size, left_), 0);
  if (count > 0) left_ -= static_cast<std::size_t>(count);
  return count;
}

std::ptrdiff_t Connection::write(const char* from, std::size_t size) const {
  const Clock::time_point end = Clock::now() + allowed_;
  std::size_t done = 0;
  while (done < size) {
    if (!wait_for(socket_, POLLOUT, end)) return -1;
    const std::ptrdiff_t count = send(socket_, from + done, size - done, MSG_NOSIGNAL | MSG_DONTWAIT);
    if (count < 0 && (errno == EAGAIN || errno == EINTR)) continue;
    if (count <= 0) return -1;
    done += static_cast<std::size_t>(count);
  }
  return static_cast<std::ptrdiff_t>(done);
}

bool Connection::is_open() const {
  char byte = 0;
  const std::ptrdiff_t count = recv(socket_, &byte, 1, MSG_PEEK | MSG_DONTWAIT);
  return count > 0 || (count < 0 && (errno == EAGAIN || errno == EINTR));
}

}  // namespace rockstack::live
