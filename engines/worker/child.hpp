#pragma once

#include <sys/types.h>

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <utility>

#include "engines/worker/last_words.hpp"

namespace rockstack {

/// What a worker may take. The memory limit is one on what it may write to and shares with nobody
/// (RLIMIT_DATA), not on the addresses it reserves; address sanitizer, which claims terabytes, has none.
struct Limits {
  /// While this process runs, s: by the clock, also where the worker sleeps or is stopped, less what it
  /// waited for processors that others had; may be infinite.
  double time = 600;
  std::uint64_t memory = std::uint64_t{4} << 30;     ///< bytes
  std::uint64_t reply = std::uint64_t{16} << 20;     ///< bytes of its reply, as of any file that it writes
  const std::function<bool()>* cancelled = nullptr;  ///< asked every few ms: true ends the run; null: none
};

/// How a process ended, or answered.
struct ProcessEnd {
  bool timed_out = false;     ///< and was killed for it
  bool cancelled = false;     ///< of Limits, was true
  bool stopped = false;       ///< by a signal, and not going on, when it was killed
  int signal = 0;             ///< that ended it otherwise; 0: none did
  int exit_code = 0;          ///< where it ended by itself
  double processor_time = 0;  ///< user and system, as the operating system accounts for it, s
  std::string reply;          ///< what it wrote to descriptor 3
  std::string last_words;     ///< the line on standard error that tells most
};

/// An open file that closes itself and that no other program inherits.
class FileDescriptor {
 public:
  /// @throws std::runtime_error for a number below 0.
  explicit FileDescriptor(int number);
  FileDescriptor(FileDescriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  FileDescriptor& operator=(FileDescriptor&&) = delete;
  ~FileDescriptor();
  int get() const { return number_; }

 private:
  int number_;
};

/// Moves a file out of the way of the numbers that a child gives to its own files.
FileDescriptor high(int number);

/// A file in memory that has some content.
FileDescriptor memory_file(std::string_view content);

/// All of such a file.
std::string content(const FileDescriptor& file);

/// Ends of a pipe or a pair of sockets: the one of this process, and the one of its child.
struct Ends {
  FileDescriptor ours, theirs;
};

/// A pipe that is read without waiting.
Ends make_pipe();

/// What the operating system's scheduler has given to the threads of a session that are there, s.
struct Scheduled {
  double run = 0;     ///< with a processor
  double waited = 0;  ///< ready for one, while others had it
};

Scheduled scheduled(pid_t session);

/// The time that a child may take. Little passes while this process is stopped.
class Allowance {
 public:
  /// `before`: what its session was given for something else.
  Allowance(pid_t session, const Limits& limits, Scheduled before = {})
      : session_(session), limit_(limits.time), asked_(limits.cancelled), before_(before) {}

  bool cancelled() const { return cancelled_; }

  /// Counts the time since the last call, in which this process meant to wait for `wait` at most.
  /// @return whether any is left, for what is still wanted.
  bool lasts(std::chrono::microseconds wait);

 private:
  double used() const;

  pid_t session_;
  double limit_;
  const std::function<bool()>* asked_;
  Scheduled before_;
  double clock_ = 0;
  bool cancelled_ = false;
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

/// A program that runs in a session of its own, without a terminal. Both go with this.
class Child {
 public:
  /// Starts it with these files as standard input and descriptor 3, under the limits of memory and reply.
  Child(const std::filesystem::path& program, int input, int reply, const Limits& limits,
        Ends complaints = make_pipe());
  ~Child();
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  /// 0 where it is finished.
  pid_t number() const { return number_; }

  /// User and system time of the program so far, s.
  double processor_time() const;

  bool has_ended() const;

  /// Waits until it has ended, or its time is over, and hears what it says. @return whether it has.
  bool wait_for_end(Allowance& time, std::chrono::milliseconds tick);

  /// Standard error, to be polled; -1 once nobody writes to it.
  int complaints() const { return silent_ ? -1 : complaints_.get(); }

  /// Takes what waits on standard error: a full pipe would hold the program up.
  void listen();

  /// Drops the words so far, which are of a question before.
  void forget_words();

  /// Kills it where it has not ended, and what else is left of its session; how it has ended.
  /// @throws std::runtime_error where it could not be started.
  ProcessEnd finish(const Allowance& time);

 private:
  std::string program_;
  FileDescriptor failure_, complaints_;
  LastWords words_;
  bool silent_ = false;  ///< nobody has the other end of its standard error any more
  pid_t number_ = 0;
};

}  // namespace rockstack
