#pragma once

#include "analytic/unilateral/solve_unilateral.hpp"
#include "tests/analytic/solver/stacks.hpp"

namespace rockstack::testing {

/// A scene with the friction of its interfaces.
struct RubbingScene {
  Scene scene;
  ContactOptions options;
};

/// The random stack of a seed, of one to four blocks, with friction of 0.1 … 0.9; one in four moves freely,
/// of the others the ground moves.
inline RubbingScene rubbing_scene(std::uint64_t seed) {
  RubbingScene result{seeded_scene(seed), {}};
  Draw draw(seed + 50000);
  for (std::size_t k = 0; k < result.scene.blocks.size(); ++k)
    result.options.friction.push_back(draw.between(0.1, 0.9));
  return result;
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
