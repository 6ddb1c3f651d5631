#pragma once

#include <string>
#include <vector>

#include "analytic/scene/history.hpp"
#include "analytic/scene/scene.hpp"

namespace rockstack {

/// What each interface carries from the block below to the block above at every sample, row by row; open
/// interfaces have no centre: there it is the pivot. Precondition: the history has patterns.
std::vector<Reaction> reactions_of(const Scene& scene, const History& history);

/// time,normal_1,…,tangential_1,…,centre_1,…: what each interface carries from the block below to the block
/// above at every sample, in N along the normal of its face and along the face; and where a closed interface
/// carries it, in m from its middle (empty where it is open: there it is the pivot).
/// Precondition: the history has patterns.
std::string reactions_csv(const Scene& scene, const History& history);

}  // namespace rockstack
