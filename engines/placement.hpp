#pragma once

#include <vector>

#include "analytic/scene/scene.hpp"
#include "engines/setup.hpp"

namespace rockstack {

/// Bottom to top: pivots touch, centres move as the pattern and the slips of the initial state make them.
/// @throws std::runtime_error for a restitution, or a centre of mass off a block's middle, in one line.
std::vector<Placement> place(const Scene& scene);

/// Gravity alone, in the axes of the ground.
BodyAcceleration body_acceleration(const Scene& scene);

/// Gravity less the mean ground acceleration over [from, to], from < to.
BodyAcceleration body_acceleration(const Scene& scene, double from, double to);

/// True where a ground motion makes body_acceleration() change with time.
inline bool is_shaken(const Scene& scene) {
  return !scene.horizontal.empty() || !scene.vertical.empty();
}

}  // namespace rockstack
