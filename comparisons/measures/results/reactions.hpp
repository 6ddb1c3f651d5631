#pragma once

#include <vector>

#include "analytic/scene/history.hpp"
#include "analytic/scene/scene.hpp"

namespace rockstack {

/// What each interface carries from the block below to the block above at every sample, row by row; open
/// interfaces have no centre: there it is the pivot. Precondition: the history has patterns.
std::vector<Reaction> reactions_of(const Scene& scene, const History& history);

}  // namespace rockstack
