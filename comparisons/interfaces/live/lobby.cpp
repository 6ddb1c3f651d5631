#include "comparisons/interfaces/live/lobby.hpp"

#include <poll.h>
#include <sys/eventfd.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <stdexcept>
#include <utility>

namespace rockstack::live {
namespace {

std::int64_t milliseconds_to(Clock::time_point end) {
  const auto left = std::chrono::ceil<std::chrono::milliseconds>(end - Clock::now()).count();
  return std::max<std::int64_t>(0, left);
}

}  // namespace

bool wait_for(int socket, short event, Clock::time_point end) {
  for (;;) {
    pollfd watched{socket, event, 0};
    const int count = poll(&watched, 1, static_cast<int>(milliseconds_to(end)));
    if (count > 0) return true;
    if (count == 0 || errno != EINTR) return false;
  }
}

void close_both_ways(int socket) {
  ::shutdown(socket, SHUT_RDWR);
  close(socket);
}

Lobby::Lobby(Door door) : door_(std::move(door)), bell_(eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK)) {
  if (bell_ < 0) throw std::runtime_error("the live page's server: no event can be waited for");
  watching_ = std::thread([this] { watch(); });
}

void Lobby::add(int socket) {
  {
    const std::lock_guard lock(mutex_);
    arrived_.push_back(socket);
  }
  eventfd_write(bell_, 1);
}

Lobby::~Lobby() {
  {
    const std::lock_guard lock(mutex_);
    over_ = true;
  }
  eventfd_write(bell_, 1);
  watching_.join();
  close(bell_);
}

/// What has come of the first line, or of what a refused one still says, which is dropped.
void Lobby::hear(Guest& guest) {
  constexpr std::size_t longest_line = 8192;
  std::array<char, longest_line> bytes;
  const ssize_t count = recv(guest.socket, bytes.data(), bytes.size(), MSG_DONTWAIT);
  if (count < 0 && (errno == EAGAIN || errno == EINTR)) return;
  if (count <= 0) return close_both_ways(std::exchange(guest.socket, -1));
  if (guest.refused) return;
  guest.begun.append(bytes.data(), static_cast<std::size_t>(count));
  const std::size_t end = guest.begun.find('\n');
  if (end == std::string::npos && guest.begun.size() < longest_line) return;
  if (door_.admits(guest.begun.substr(0, end)))
    return door_.let_in(std::exchange(guest.socket, -1), std::move(guest.begun));
  guest.refused = true;
  send(guest.socket, door_.refusal.data(), door_.refusal.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
  // Were it closed before the other side has done so, what it still sends would undo the answer.
  ::shutdown(guest.socket, SHUT_WR);
}

void Lobby::close_late_ones() {
  constexpr std::size_t most = 512;
  const Clock::time_point now = Clock::now();
  std::size_t left = guests_.size();
  for (Guest& guest : guests_)
    if (left-- > most || guest.end <= now) close_both_ways(std::exchange(guest.socket, -1));
}

void Lobby::watch() {
  for (;;) {
    std::vector<pollfd> watched{{bell_, POLLIN, 0}};
    for (const Guest& guest : guests_) watched.push_back({guest.socket, POLLIN, 0});
    const auto wait = guests_.empty() ? -1 : milliseconds_to(guests_.front().end);
    poll(watched.data(), watched.size(), static_cast<int>(wait));
    for (std::size_t i = 0; i < guests_.size(); ++i)
      if (watched[i + 1].revents != 0) hear(guests_[i]);
    std::erase_if(guests_, [](const Guest& guest) { return guest.socket < 0; });
    eventfd_t ignored = 0;
    eventfd_read(bell_, &ignored);
    {
      const std::lock_guard lock(mutex_);
      if (over_) break;
      for (const int socket : arrived_) guests_.push_back({socket});
      arrived_.clear();
    }
    close_late_ones();
    std::erase_if(guests_, [](const Guest& guest) { return guest.socket < 0; });
  }
  for (const Guest& guest : guests_) close_both_ways(guest.socket);
}

}  // namespace rockstack::live
