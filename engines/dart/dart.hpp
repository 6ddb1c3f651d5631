#pragma once

#include <memory>
#include <vector>

#include "engines/engine.hpp"

namespace rockstack {

/// DART with each of its solvers of boxed complementarity problems: "dantzig", a pivoting method that has
/// projected Gauss–Seidel behind it where it fails, and "pgs", that iteration alone.
std::vector<std::unique_ptr<Engine>> make_dart();

}  // namespace rockstack
