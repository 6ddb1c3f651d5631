#pragma once

#include <string>

#include "engines/worker/worker_engine.hpp"

namespace rockstack {

/// An engine by its name and solver; nullptr where node or the packages are not there.
const WorkerEngine* there(const std::string& name);

/// The question of a bare program for a scene of one block that moves at the start, with more words at its
/// end.
std::string moving_question(const WorkerEngine& engine, const Scene& scene, double dt,
                            const Parameters& parameters, const std::string& more = "");

/// A block that its friction holds on ground which accelerates by 0.2 g, for 0.5 s.
Scene block_held_by_friction();

/// Bare programs print what the ground bears in the place of angles, by what they can tell of it.
std::vector<double> borne(const WorkerEngine& engine, const Scene& scene, int what);
inline constexpr int pressing = 1, rubbing = 2;

}  // namespace rockstack
