#pragma once

#include <memory>
#include <vector>

#include "engines/engine.hpp"

namespace rockstack {

/// MuJoCo with each of its solvers: "newton", "cg" (conjugate gradients) and "pgs" (projected Gauss–Seidel).
std::vector<std::unique_ptr<Engine>> make_mujoco();

}  // namespace rockstack
