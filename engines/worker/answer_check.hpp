#pragma once

#include "engines/worker/request.hpp"

namespace rockstack {

/// Checks what a worker says of its engines, which goes into file names, tables and pages.
/// @throws std::runtime_error naming what is wrong, with its value and what is allowed.
void check_descriptions(const std::vector<EngineDescription>& engines);

/// Holds every field of a reply against what was asked: its status, and where that is "done" how many numbers
/// there are, their ranges, that the first sample is the start and that the run ends where a block topples.
/// @throws NotFinite for a motion beyond all numbers, std::runtime_error naming another field that is wrong.
void require_answer(const RunReply& reply, const RunRequest& asked);

/// The line of a program's standard error that tells most of why it failed: the last of the form "Error: …",
/// as all runtimes have it, below which some list calls or name themselves; without one, the last line.
std::string telling_line(std::string_view text);

}  // namespace rockstack
