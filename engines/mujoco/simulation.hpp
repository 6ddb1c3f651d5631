#pragma once

#include <memory>

#include "engines/parameters.hpp"
#include "engines/setup.hpp"
#include "engines/simulation.hpp"

namespace rockstack {

/// In the order of MuJoCo's own numbers.
enum class MujocoSolver { pgs, cg, newton };

/// A stack inside MuJoCo. Precondition: `parameters` are checked.
/// @throws std::runtime_error with the library's own error.
std::unique_ptr<Simulation> start_mujoco(MujocoSolver solver, const Setup& setup,
                                         const Parameters& parameters);

}  // namespace rockstack
