#pragma once

#include "engines/worker/child.hpp"

namespace rockstack {

/// Starts a program in a session of its own, without a terminal, gives it `input` as standard input and waits
/// for its end. Safe to call from several threads. With this program it goes, and what it has started in its
/// session.
/// @throws std::runtime_error where the operating system will not start it.
ProcessEnd run_process(const std::filesystem::path& program, std::string_view input, const Limits& limits);

/// What says something to either end is heard at the other.
Ends socket_pair();

/// A program that answers one question after the other, each of them a line, under its own limits of time and
/// reply. It is started as by run_process(), and ends with this, or with the thread that has started it.
class LastingProcess {
 public:
  /// The limit of memory is that of all questions.
  LastingProcess(const std::filesystem::path& program, const Limits& limits, Ends ends = socket_pair());

  /// False where it has ended, or has said something that nobody asked.
  bool waits() const;

  /// Asks, and waits for the answer or for its end: as the rest of the result tells, or an empty reply.
  /// `processor_time` is that since the question.
  /// @throws std::runtime_error where the operating system has not started it.
  ProcessEnd ask(std::string_view question, const Limits& limits);

 private:
  FileDescriptor socket_;  ///< the other end is standard input of the program, and its descriptor 3
  Child child_;
};

}  // namespace rockstack
