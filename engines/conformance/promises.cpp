// What a worker promises about how it is called.

#include <algorithm>
#include <cmath>

#include "engines/conformance/scenes.hpp"

namespace rockstack {

/// An angle goes into a rotation and back, a place into the engine's own numbers.
Judgement initial_state_is_the_scenes(const Adapter& adapter) {
  Scene scene = paper_scene(1e-3);
  scene.initial.angles = {0.05, -0.1};
  scene.initial.velocities = {-0.3, 0.2};
  const Setup setup = set_up(scene, 1e-3, adapter.parameters);
  const Trajectory trajectory = adapter.run(setup, adapter.parameters);
  double apart = 0;
  for (std::size_t k = 0; k < 2; ++k) {
    const Placement& placed = setup.blocks[k];
    const BodyState& body = trajectory.bodies[k];
    apart =
        std::max({apart, std::abs(trajectory.angles[k] - placed.angle),
                  std::abs(trajectory.velocities[k] - placed.angular_velocity), std::abs(body.x - placed.x),
                  std::abs(body.y - placed.y), std::abs(body.velocity_x - placed.velocity_x),
                  std::abs(body.velocity_y - placed.velocity_y)});
  }
  // A few roundings of numbers near 3.
  return {apart, 20 * rounding(adapter), "largest deviation of a place, an angle or a velocity (SI)"};
}

Judgement same_run_gives_the_same_bits(const Adapter& adapter) {
  const Scene scene = paper_scene(1);
  const auto one = run(adapter, scene, 1e-3).history.angles;
  const auto other = run(adapter, scene, 1e-3).history.angles;
  return {one == other ? 0.0 : 1.0, 0, "runs of two that differ"};
}

/// The sample in which a block is past the angle at which it has toppled is the last.
Judgement history_ends_where_a_block_topples(const Adapter& adapter) {
  Scene scene = slender_block(3);
  scene.initial.velocities = {2};
  const Setup setup = set_up(scene, 1e-3, adapter.parameters);
  const std::vector<double> angles = adapter.run(setup, adapter.parameters).angles;
  const auto beyond = std::count_if(angles.begin(), angles.end(),
                                    [&](double angle) { return std::abs(angle) > setup.toppling_angles[0]; });
  return {beyond == 1 && std::abs(angles.back()) > setup.toppling_angles[0] ? 0.0 : 1.0, 0,
          "1 where the run does not end with the first sample past the toppling angle"};
}

}  // namespace rockstack
