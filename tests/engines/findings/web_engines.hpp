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

}  // namespace rockstack
