#pragma once

#include "tests/analytic/unilateral/scenes.hpp"

namespace rockstack::testing {

/// Law unilateral with a static and a kinetic coefficient at all interfaces.
inline Scene with_coefficients(Scene scene, double friction, double kinetic) {
  scene = with_friction(std::move(scene), friction);
  scene.kinetic_friction.assign(scene.blocks.size(), kinetic);
  return scene;
}

/// A random block of law unilateral with two coefficients, at rest or leaning, on a ground that shakes.
Scene shaken_block(std::uint64_t seed);

/// The place of the block's centre and its angle at the end of a scene of one block, by time steps:
/// velocities are those of the first of all contact modes, each corner and the friction of the whole face,
/// that obeys Coulomb's law in the step, with the static coefficient where the face stuck, in no step in
/// which a corner comes to touch. Nothing of it is shared with the solver but the problem. It converges with
/// order one.
Pose<> block_stepped(const Scene& scene, std::size_t steps);

/// Random flat blocks that slide on each other and never turn, with two coefficients at each interface.
Scene sliding_stack(std::uint64_t seed);

/// The blocks' slips at the end of a scene whose blocks do not turn, by time steps in one dimension, with the
/// interfaces that stick looked for among all.
std::vector<double> slides_stepped(const Scene& scene, std::size_t steps);

}  // namespace rockstack::testing
