#pragma once

#include <cmath>
#include <utility>

#include "tests/analytic/solver/stacks.hpp"
#include "tests/analytic/unilateral/solve_unilateral.hpp"

namespace rockstack::testing {

/// Closed forms round in their own operations and in the solver's, some tens of units in the last place.
constexpr double round_off = 1e-13;

/// A scene of law unilateral with the same friction at all interfaces.
inline Scene with_friction(Scene scene, double friction) {
  scene.law = Law::unilateral;
  scene.friction.assign(scene.blocks.size(), friction);
  return scene;
}

/// The random stack of a seed, of one to four blocks, with friction of 0.1 … 0.9; one in four moves freely,
/// of the others the ground moves.
inline Scene rubbing_scene(std::uint64_t seed) {
  Scene scene = with_friction(seeded_scene(seed), 0);
  Draw draw(seed + 50000);
  for (double& friction : scene.friction) friction = draw.between(0.1, 0.9);
  return scene;
}

/// A scene with friction drawn for each interface: none, 0 … 10, or 0.001 … 10 by decades.
inline Scene slippery(Scene scene, std::uint64_t seed) {
  scene = with_friction(std::move(scene), 0);
  Draw draw(seed + 77000);
  for (double& friction : scene.friction) {
    const int kind = draw.below(4);
    friction = kind == 0 ? 0 : kind == 1 ? draw.between(0, 10) : std::pow(10, draw.between(-3, 1));
  }
  return scene;
}

/// One uniform block of half-sizes b and h in m, at rest.
inline Scene single(double half_width, double half_height, double duration) {
  return released({block(2 * half_width, 2 * half_height)}, {0}, duration);
}

inline GroundMotion pulse_of(PulseShape shape, double amplitude, double period, double start = 0) {
  GroundMotion motion;
  motion.pulse = Pulse{.shape = shape, .amplitude = amplitude, .period = period, .start = start};
  return motion;
}

}  // namespace rockstack::testing
