#pragma once

#include <vector>

#include "engines/conformance/check.hpp"
#include "engines/scene_setup.hpp"

namespace rockstack {

Scene at_rest(std::vector<Block> blocks, double duration);

/// Samples `value` from t = 0 on, m/s².
GroundMotion constant(double value);

/// A block of slenderness atan(0.2), released at half its slenderness.
Scene slender_block(double duration);

/// Spanos et al. 2001, free rocking.
Scene paper_scene(double duration);

/// What an engine made of a scene, with its bodies.
struct ObservedMotion {
  History history;
  std::vector<BodyState> bodies;  ///< sample by sample, in each from the lowest block up

  const BodyState& body(std::size_t sample, std::size_t block) const {
    return bodies[sample * static_cast<std::size_t>(history.blocks) + block];
  }
};

ObservedMotion run(const Adapter& adapter, const Scene& scene, double dt);

/// The same, shaken by a body force.
Adapter by_force(Adapter adapter);

/// Unit round-off of the engine's own numbers.
double rounding(const Adapter& adapter);

/// The shortest step at which gravity's share of a step stands clear of rounding, s.
double short_step(const Adapter& adapter);

double largest(const std::vector<double>& values);

/// The constants of Housner 1963 for slender_block().
struct Housner {
  Housner();
  double slenderness;  ///< rad
  double frequency;    ///< p, 1/s
  /// Angular velocity at which a block released at `angle` meets the ground, rad/s.
  double speed_at_ground(double angle) const;
};

/// Time from release at `start` to the ground: the energy integral of the full equation, s.
double quarter_period(const Housner& block, double start);

/// Time of the lowest block's first zero crossing, on the straight line between samples; not a number where
/// it never comes.
double first_ground_impact(const History& history);

}  // namespace rockstack
