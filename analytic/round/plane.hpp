#pragma once

#include "analytic/round/column.hpp"

namespace rockstack {

/// The direction from x, rad, of a plane that all that acts keeps the column in; none where it leaves any.
std::optional<double> plane_of(const RoundScene& scene);

/// The column held in the plane of that direction, as a block.
Scene planar_scene(const RoundScene& scene, double direction);

/// The motion of planar_scene(), told as one in space.
RoundMotion solve_in_plane(const RoundScene& scene, double direction, const std::vector<double>& times);

}  // namespace rockstack
