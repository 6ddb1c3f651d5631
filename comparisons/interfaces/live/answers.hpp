#pragma once

#include <nlohmann/json_fwd.hpp>

#include "analytic/scene/scene.hpp"
#include "comparisons/interfaces/live/live_state.hpp"
#include "engines/worker/worker_engine.hpp"

namespace rockstack::live {

// What a page is told of a motion: a track as the player's script reads it, energies as parts of
// energy_scale() at "energy_times", impacts as [time, interface, side], a verdict. Lists of numbers are as
// plots::packed().

/// The exact motion at multiples of `interval`, s, with what the player draws it by. A motion that cannot be
/// followed to its end is told up to there, with "failure".
nlohmann::ordered_json exact_answer(const Scene& scene, double interval);

/// Times and angles alone.
nlohmann::ordered_json exact_member(const Scene& scene, double interval);

/// An engine's run, of `stride` samples one.
nlohmann::ordered_json engine_answer(const LiveState& state, const WorkerRun& run, std::size_t stride);
nlohmann::ordered_json engine_member(const WorkerRun& run, std::size_t stride);

}  // namespace rockstack::live
