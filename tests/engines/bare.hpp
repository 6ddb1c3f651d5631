#pragma once

#include <string>
#include <vector>

#include "engines/worker/worker_engine.hpp"

namespace rockstack {

/// What a bare program (bare/) reads: the scene in plain numbers, and those settings that are not the
/// library's own.
std::string bare_question(const WorkerEngine& engine, const Scene& scene, double step,
                          const Parameters& parameters);

/// The angles that the bare program of an engine ("bullet", "bullet-single", "ode") prints, step after step.
/// @throws std::runtime_error where it does not take the question.
std::vector<double> bare_angles(const std::string& engine, const std::string& question);

}  // namespace rockstack
