#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

namespace rockstack {

/// What a worker may take. The memory limit is one on what it may write to and shares with nobody
/// (RLIMIT_DATA), not on the addresses that it reserves; a program with address sanitizer runs without it,
/// because that claims terabytes.
struct Limits {
  /// While this process runs, s: by the clock, also where the worker sleeps or is stopped, less what it
  /// waited for processors that others had; may be infinite.
  double time = 600;
  std::uint64_t memory = std::uint64_t{4} << 30;    ///< bytes
  std::uint64_t reply = std::uint64_t{16} << 20;    ///< bytes of its reply, as of any file that it writes
  const std::function<bool()>* unwanted = nullptr;  ///< asked every few ms: true ends the run; null: none
};

/// How a process ended, or answered.
struct ProcessEnd {
  bool timed_out = false;     ///< and was killed for it
  bool unwanted = false;      ///< likewise
  bool stopped = false;       ///< by a signal, and not going on, when it was killed
  int signal = 0;             ///< that ended it otherwise; 0: none did
  int exit_code = 0;          ///< where it ended by itself
  double processor_time = 0;  ///< user and system, as the operating system accounts for it, s
  std::string reply;          ///< what it wrote to descriptor 3
  std::string last_words;     ///< the line on standard error, of its first 64 KiB, that tells most
};

/// Starts a program in a session of its own, without a terminal, gives it `input` as standard input and waits
/// for its end. Safe to call from several threads. The program goes when this one does, and what it has
/// started in its session goes with it.
/// @throws std::runtime_error where the operating system will not start it.
ProcessEnd run_process(const std::filesystem::path& program, std::string_view input, const Limits& limits);

/// A program that answers one question after the other, each of them a line, under its own limits of time and
/// reply. It is started as by run_process(), and ends with this, or with the thread that has started it.
class LastingProcess {
 public:
  /// The limit of memory is that of all questions.
  LastingProcess(const std::filesystem::path& program, const Limits& limits);
  ~LastingProcess();

  /// False where it has ended, or has said something that nobody asked.
  bool waits() const;

  /// Asks, and waits for the answer or for its end: as the rest of the result tells, or an empty reply.
  /// `processor_time` is that since the question.
  /// @throws std::runtime_error where the operating system has not started it.
  ProcessEnd ask(std::string_view question, const Limits& limits);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace rockstack
