#include "engines/worker/process.hpp"

#include <poll.h>
#include <sys/socket.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <stdexcept>

namespace rockstack {
namespace {

/// Between looks at a child: often where it may be cancelled.
std::chrono::milliseconds tick_of(const Limits& limits) {
  return std::chrono::milliseconds(limits.cancelled != nullptr ? 5 : 50);
}

/// Waits for a tick at most until the socket takes some of what is left of a question, or has more of a
/// reply; hears what the child says meanwhile.
/// @return false where no more will come.
bool exchange(const FileDescriptor& socket, Child& child, std::string_view& left, std::string& reply,
              std::chrono::milliseconds tick) {
  std::array<pollfd, 2> watched{
      {{socket.get(), static_cast<short>(left.empty() ? POLLIN : POLLIN | POLLOUT), 0},
       {child.complaints(), POLLIN, 0}}};
  if (poll(watched.data(), watched.size(), static_cast<int>(tick.count())) <= 0) return !child.has_ended();
  if (watched[1].revents != 0) child.listen();
  if ((watched[0].revents & POLLOUT) != 0) {
    const ssize_t sent = send(socket.get(), left.data(), left.size(), MSG_DONTWAIT | MSG_NOSIGNAL);
    if (sent > 0) left.remove_prefix(static_cast<std::size_t>(sent));
  }
  std::array<char, 1 << 16> buffer{};
  const ssize_t got = recv(socket.get(), buffer.data(), buffer.size(), MSG_DONTWAIT);
  if (got > 0) reply.append(buffer.data(), static_cast<std::size_t>(got));
  return got > 0 || (got < 0 && errno == EAGAIN);
}

}  // namespace

Ends socket_pair() {
  std::array<int, 2> ends{};
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0)
    throw std::runtime_error("no sockets for a worker");
  return {high(ends[0]), high(ends[1])};
}

ProcessEnd run_process(const std::filesystem::path& program, std::string_view input, const Limits& limits) {
  const FileDescriptor in = memory_file(input), reply = memory_file({});
  Child child(program, in.get(), reply.get(), limits);
  Allowance time(child.number(), limits);
  child.wait_for_end(time, tick_of(limits));
  ProcessEnd end = child.finish(time);
  end.reply = content(reply);
  return end;
}

LastingProcess::LastingProcess(const std::filesystem::path& program, const Limits& limits, Ends ends)
    : socket_(std::move(ends.ours)), child_(program, ends.theirs.get(), ends.theirs.get(), limits) {}

bool LastingProcess::waits() const {
  pollfd watched{socket_.get(), POLLIN, 0};
  return child_.number() != 0 && poll(&watched, 1, 0) == 0;
}

ProcessEnd LastingProcess::ask(std::string_view question, const Limits& limits) {
  const std::chrono::milliseconds tick = tick_of(limits);
  const double before = child_.processor_time();
  child_.forget_words();
  Allowance time(child_.number(), limits, scheduled(child_.number()));
  const std::string line = std::string(question) + '\n';
  std::string_view left = line;
  std::string reply;
  bool open = true;
  while (open && !reply.ends_with('\n') && reply.size() <= limits.reply && time.lasts(tick))
    open = exchange(socket_, child_, left, reply, tick);
  const bool too_long = reply.size() > limits.reply;
  ProcessEnd end;
  if (reply.ends_with('\n') && !too_long) {
    end.processor_time = child_.processor_time();
    end.reply = std::move(reply);
  } else {
    if (!open) child_.wait_for_end(time, tick);
    end = child_.finish(time);
    if (too_long) {
      end.timed_out = end.cancelled = false;
      end.signal = SIGXFSZ;
    }
  }
  end.processor_time -= before;
  return end;
}

}  // namespace rockstack
