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

/// Whether an answer is one to another question of its process rather than to that which was asked: its
/// number of samples or its start is the other's. Of two questions alike in these it says nothing.
bool answers_rather(const Trajectory& made, const Setup& other, const Setup& asked);

}  // namespace rockstack
