#pragma once

#include <string>
#include <vector>

#include "engines/worker/worker_engine.hpp"

namespace rockstack {

/// Every engine with every solver that this program was built with; worker programs are asked for theirs at
/// the first call. Those switched off are not there. @throws std::runtime_error naming a worker program that
/// is not beside this one and not where it was built.
const std::vector<WorkerEngine>& engines();

/// Finds "bullet", "ode" or "bullet:nncg"; without a solver, the engine's first.
/// @throws InputError naming what was asked for, what is there and what this build leaves out.
const WorkerEngine& find_engine(const std::string& name);

/// Names of engines that were left out when this program was built.
std::vector<std::string> engines_left_out();

}  // namespace rockstack
