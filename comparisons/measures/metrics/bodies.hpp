#pragma once

#include "analytic/scene/history.hpp"
#include "analytic/scene/kinematics.hpp"

namespace rockstack {

/// Numbers of a list, one a block.
inline Vector<double> vector_of(std::span<const double> values) {
  return Vector<double>::Map(values.data(), static_cast<Eigen::Index>(values.size()));
}

/// The centres of mass of all blocks at a sample, from the middle of the ground's interface, m, a column
/// each. Where slip and lift-off make places, from those; else from the angles, which tell them. `stack` is
/// that of the history's scene.
Points<double> centre_places(const Stack<double>& stack, const History& history, std::size_t sample);

/// Places of centres, m, and their velocities, m/s.
struct Centres {
  Points<double> at, rate;
};

/// Precondition: a solver's history, which knows its patterns. `stack` is that of its scene.
Centres centres_at(const Stack<double>& stack, const History& history, std::size_t sample);

/// How far each centre is from its place at rest upright, m; of blocks on pivots by b sin θ − h (1 − cos θ),
/// without cancellation. Precondition: likewise.
Points<double> centre_displacements(const Stack<double>& stack, const History& history, std::size_t sample);

/// The centres alone at all samples, x and y in turn from the lowest block up, m. Precondition: likewise.
std::vector<double> centres_of(const Scene& scene, const History& history);

/// How far a motion goes from where it starts: the largest change of an angle, rad, or the longest way of a
/// centre as a share of the least block height, whichever is larger. `centres`: its own.
double extent_of_motion(const Scene& scene, const History& history, const std::vector<double>& centres);

/// The least height of a block, m: what positions are held against.
double least_height(const std::vector<Block>& blocks);

/// What bodies still do over the last tenth of their samples, where the exact motion is at rest all that
/// time.
struct Unrest {
  double hover = 0;   ///< height at which one stays over what it stands on, m
  double creep = 0;   ///< speed at which a centre goes one way, m/s
  double offset = 0;  ///< largest distance of a centre from the exact one at the end, m
};

/// From centres as centres_of() has them and the largest gap, m, at each of the first samples of `exact`. A
/// gap that varies by a hundredth is none at which a block stays; the creep is the smaller of the mean
/// velocities in both halves of that time, 0 where these point apart. Nothing where the exact motion is not
/// at rest, or of less than 20 samples.
std::optional<Unrest> unrest_of(const Scene& scene, const History& exact, const std::vector<double>& centres,
                                const std::vector<double>& gaps);

/// How deep a block must have sunk in for that to be told, as a share of the least block height.
inline constexpr double told_sinking = 1e-3;

/// Kinetic and potential energy of a stack in the ground's frame, zero at rest upright, at each sample, J.
/// Precondition: a solver's history, which knows its patterns.
std::vector<double> energies(const Scene& scene, const History& history);

/// Weight times the height of the centre of mass at rest, J: what energies are measured by.
double energy_scale(const Scene& scene);

/// Energy of the bodies, less the work done on them (`input`), and with what their contacts have stored: J,
/// at each sample. The true motion never makes it rise. Precondition: of equal size.
std::vector<double> energy_balance(const std::vector<double>& energy, const std::vector<double>& input,
                                   const std::vector<double>& elastic);

/// The largest rise above the least value before, J.
double largest_gain(const std::vector<double>& energy);

}  // namespace rockstack
