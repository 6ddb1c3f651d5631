#pragma once

#include "engines/worker/request.hpp"

namespace rockstack {

/// Holds every field of a reply against what was asked: its status, and where that is "done" how many numbers
/// there are, their ranges, that the first sample is the start and that the run ends where a block topples.
/// @throws NotFinite for a motion beyond all numbers, std::runtime_error naming any other field that is
/// wrong.
void require_answer(const RunReply& reply, const RunRequest& asked);

}  // namespace rockstack
