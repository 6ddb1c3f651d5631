#pragma once

#include "analytic/scene/history.hpp"
#include "analytic/scene/kinematics.hpp"

namespace rockstack {

/// The centres of mass of all blocks at a sample, from the middle of the ground's interface, m, and their
/// velocities, m/s; a column each.
struct Centres {
  Points<double> at, rate;
};

/// Where slip and lift-off make places, from those; else from the angles, which tell them.
/// Precondition: a solver's history, which knows its patterns. `stack` is that of its scene.
Centres centres_at(const Stack<double>& stack, const History& history, std::size_t sample);

}  // namespace rockstack
