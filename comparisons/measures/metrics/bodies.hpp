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

/// What bodies still do over the last tenth of their samples. Each is told where the exact motion has none of
/// it all that time: `hover` where nothing is apart, `turn` where no angle changes, the others at rest.
struct Unrest {
  std::optional<double> hover = {};   ///< height at which one stays over what it stands on, m
  std::optional<double> turn = {};    ///< speed at which angles go one way, rad/s
  std::optional<double> creep = {};   ///< speed at which a centre goes one way, m/s
  std::optional<double> offset = {};  ///< largest distance of a centre from the exact one at the end, m
};

/// From a motion, its centres as centres_of() has them and the largest gap, m, at each of the first samples
/// of `exact`. A gap that varies by a hundredth is none at which a block stays; what goes one way has the
/// smaller of its mean velocities in both halves of that time, 0 where these point apart. Nothing of less
/// than 20 samples.
Unrest unrest_of(const Scene& scene, const History& exact, const History& motion,
                 const std::vector<double>& centres, const std::vector<double>& gaps);

/// The largest height, m, of a block over what it stands on at each sample; zero where places do not tell.
std::vector<double> largest_gaps(const History& history);

/// By how much the gaps of a motion exceed all that the exact motion has from `lag`, s, before that time on,
/// m, at the samples of both. Beyond `horizon`, s, where times do not tell, from the horizon on.
double largest_rise(const History& exact, const std::vector<double>& gaps, double horizon, double lag);

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
