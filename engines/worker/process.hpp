#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

namespace rockstack {

/// What a worker may take. The memory limit is one on address space; a program with address sanitizer runs
/// without it, because that reserves terabytes.
struct Limits {
  double time = 600;  ///< wall time in which nobody has stopped it, s; may be infinite
  std::uint64_t memory = std::uint64_t{4} << 30;    ///< bytes
  std::uint64_t reply = std::uint64_t{16} << 20;    ///< bytes of its reply, as of any file that it writes
  const std::function<bool()>* unwanted = nullptr;  ///< asked every few ms: true ends the run; null: none
};

/// How a process ended.
struct ProcessEnd {
  bool timed_out = false;     ///< and was killed for it
  bool unwanted = false;      ///< likewise
  int signal = 0;             ///< that ended it otherwise; 0: none did
  int exit_code = 0;          ///< where it ended by itself
  double processor_time = 0;  ///< user and system, as the operating system accounts for it, s
  std::string reply;          ///< what it wrote to descriptor 3
  std::string last_words;     ///< last line on standard error, of its first 64 KiB
};

/// Starts a program, gives it `input` as standard input and waits for its end. Safe to call from several
/// threads. The program goes when this one does, and what it has started goes with it.
/// @throws std::runtime_error where the operating system will not start it.
ProcessEnd run_process(const std::filesystem::path& program, std::string_view input, const Limits& limits);

}  // namespace rockstack
