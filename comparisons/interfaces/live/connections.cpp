#include "comparisons/interfaces/live/connections.hpp"

#include <sys/ioctl.h>
#include <sys/socket.h>

#include <algorithm>

namespace rockstack::live {
namespace {

bool is_silent(int socket) {
  int bytes = 0;
  return ioctl(socket, FIONREAD, &bytes) == 0 && bytes == 0;
}

}  // namespace

void Connections::queue() {
  const std::lock_guard lock(mutex_);
  ++open_;
  make_room(-1);
}

void Connections::enter(int socket) {
  const std::lock_guard lock(mutex_);
  sockets_.push_back(socket);
  make_room(socket);
}

void Connections::admit(int socket) {
  const std::lock_guard lock(mutex_);
  std::erase(sockets_, socket);
}

void Connections::leave(int socket) {
  const std::lock_guard lock(mutex_);
  std::erase(sockets_, socket);
  --open_;
}

void Connections::make_room(int except) {
  if (open_ <= threads_) return;
  const auto silent =
      std::ranges::find_if(sockets_, [&](int socket) { return socket != except && is_silent(socket); });
  if (silent == sockets_.end()) return;
  shutdown(*silent, SHUT_RDWR);
  sockets_.erase(silent);
}

}  // namespace rockstack::live
