#pragma once

#include "analytic/scene/history.hpp"
#include "analytic/scene/kinematics.hpp"
#include "comparisons/measures/metrics/difference.hpp"

namespace rockstack {

/// The centres of mass of all blocks at a sample, from the middle of the ground's interface, m, and their
/// velocities, m/s; a column each.
struct Centres {
  Points<double> at, rate;
};

/// Where slip and lift-off make places, from those; else from the angles, which tell them.
/// Precondition: a solver's history, which knows its patterns. `stack` is that of its scene.
Centres centres_at(const Stack<double>& stack, const History& history, std::size_t sample);

/// The centres alone at all samples, x and y in turn from the lowest block up, m. Precondition: likewise.
std::vector<double> centres_of(const Scene& scene, const History& history);

/// How far two motions' centres are apart at times of both, m. Precondition: centres as centres_of() has
/// them, as many as times or more.
Difference position_difference(const std::vector<double>& times, const std::vector<double>& first,
                               const std::vector<double>& second, std::size_t blocks);

/// How far a motion goes from where it starts: the largest change of an angle, rad, or the longest way of a
/// centre as a share of the least block height, whichever is larger. `centres`: its own.
double extent_of_motion(const Scene& scene, const History& history, const std::vector<double>& centres);

/// The least height of a block, m: what positions are held against.
double least_height(const std::vector<Block>& blocks);

/// How deep a block must have sunk in for that to be told, as a share of the least block height.
inline constexpr double told_sinking = 1e-3;

}  // namespace rockstack
