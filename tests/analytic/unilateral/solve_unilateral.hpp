#pragma once

#include <span>

#include "analytic/solve.hpp"
#include "analytic/unilateral/contact/contact_model.hpp"

namespace rockstack {

/// The motion of a scene under its law or, where that keeps pivots, law `unilateral`. Where no samples are
/// asked for, there is one of its end.
inline History solve_unilateral(Scene scene, SolveOptions options = {}) {
  if (!leaves_pivots(scene.law)) scene.law = Law::unilateral;
  options.end = options.end || options.sample_times.empty();
  return solve(scene, options);
}

/// Poses of blocks, or rates of them, of x and y in turn and of angles.
inline Poses<> poses_of(std::span<const double> centres, std::span<const double> angles) {
  Poses<> poses;
  for (std::size_t k = 0; k < angles.size(); ++k)
    poses.push_back({centres[2 * k], centres[2 * k + 1], angles[k]});
  return poses;
}

inline Bodies<> bodies_before(const Event& event) {
  const std::span<const double> centres = event.centres;
  return {poses_of(centres, event.angles), poses_of(centres.subspan(centres.size() / 3), event.before)};
}

inline Bodies<> bodies_after(const Event& event) {
  const std::span<const double> centres = event.centres;
  return {poses_of(centres, event.angles), poses_of(centres.subspan(centres.size() / 3 * 2), event.after)};
}

inline Bodies<> bodies_at(const History& history, std::size_t sample) {
  const std::size_t first = 2 * sample * static_cast<std::size_t>(history.blocks);
  return {poses_of(std::span(history.centres).subspan(first), history.angles_at(sample)),
          poses_of(std::span(history.centre_velocities).subspan(first), history.velocities_at(sample))};
}

/// A row of a history.
struct Sample {
  double time;
  Bodies<> bodies;
  std::span<const double> slips, gaps;
  std::span<const Reaction> reactions;
  std::span<const SpringEnergy> springs;  ///< under law `compliant` alone
};

inline std::vector<Sample> samples_of(const History& history) {
  std::vector<Sample> samples;
  for (std::size_t i = 0; i < history.size(); ++i) {
    samples.push_back({history.times[i],
                       bodies_at(history, i),
                       history.row(history.slips, i),
                       history.row(history.gaps, i),
                       history.row(history.reactions, i),
                       {}});
    if (!history.spring_energies.empty()) samples.back().springs = history.row(history.spring_energies, i);
  }
  return samples;
}

/// Whether an event ends a motion before its scene's end.
inline bool ends_early(const History& history) {
  return !history.events.empty() && ends_motion(history.events.back().kind);
}

/// Bodies where a motion ends. Precondition: it ends early, or its last sample is of its end.
inline Bodies<> bodies_at_end(const History& history) {
  return ends_early(history) ? bodies_after(history.events.back()) : bodies_at(history, history.size() - 1);
}

/// Whether nothing slides or is apart.
inline bool all_stick(const Pattern& pattern) {
  return name(pattern).find_first_of("-<>") == std::string::npos;
}

/// Kinetic energy and that of weight, J, in the frame of the ground, from the middle of its interface.
inline double energy(const Scene& scene, const Bodies<>& bodies) {
  const Gravity gravity = gravity_of(scene);
  double sum = 0;
  for (std::size_t k = 0; k < scene.blocks.size(); ++k) {
    const Block& block = scene.blocks[k];
    const Pose<>& rate = bodies.velocity[k];
    sum += block.mass * (rate.x * rate.x + rate.y * rate.y) / 2 +
           block.inertia * rate.angle * rate.angle / 2 +
           block.mass * (gravity.across * bodies.pose[k].y - gravity.along * bodies.pose[k].x);
  }
  return sum;
}

}  // namespace rockstack
