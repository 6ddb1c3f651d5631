#pragma once

#include <vector>

#include "analytic/scene/scene.hpp"
#include "engines/setup.hpp"

namespace rockstack {

/// Bottom to top: pivots touch where they have no gap, centres move as the initial state has them.
/// @throws std::runtime_error for a restitution, or a centre of mass off a block's middle, in one line.
std::vector<Placement> place(const Scene& scene);

}  // namespace rockstack
