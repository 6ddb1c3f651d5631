#pragma once

#include "engines/engine.hpp"

struct mjModel_;

namespace rockstack {

using MujocoModel = std::unique_ptr<mjModel_, void (*)(mjModel_*)>;

/// A stack as MuJoCo compiles it. Bodies from 1: the ground where it really moves, with two coordinates (x,
/// y), then the blocks, bottom to top, with three each (x, y, angle anticlockwise).
/// @throws std::runtime_error with the library's own error.
MujocoModel compile_stack(const Setup& setup, const Parameters& parameters);

/// In the order of MuJoCo's own numbers.
enum class MujocoSolver { pgs, cg, newton };

/// A stack inside MuJoCo. Precondition: `parameters` are checked.
/// @throws std::runtime_error with the library's own error.
std::unique_ptr<Simulation> start_mujoco(MujocoSolver solver, const Setup& setup,
                                         const Parameters& parameters);

}  // namespace rockstack
