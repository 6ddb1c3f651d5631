// Blocks that slide on each other and on the ground, each interface with a coefficient of its own.

#include <algorithm>
#include <cmath>

#include "engines/conformance/scenes.hpp"

namespace rockstack {
namespace {

/// Flat blocks, all alike, that start with slips of 0.5 m/s on the ground and 1 m/s on each other.
Scene sliding(std::vector<double> friction, double duration) {
  Scene scene = at_rest(std::vector<Block>(friction.size(), make_block(2, 0.4, 2500)), duration);
  scene.law = Law::unilateral;
  scene.initial.slip_velocities.assign(friction.size(), 1);
  scene.initial.slip_velocities[0] = 0.5;
  scene.friction = std::move(friction);
  return scene;
}

/// How far each block has slipped by the end, m.
std::vector<double> final_slips(const Adapter& adapter, const Scene& scene, double dt) {
  const std::vector<double> slips = run(adapter, scene, dt).history.slips;
  return {slips.end() - static_cast<std::ptrdiff_t>(scene.blocks.size()), slips.end()};
}

}  // namespace

/// The scheme takes μgh off the velocity in each step before it moves the block: from v it goes h[(K − 1) v −
/// μgh (K − 1) K/2], K = ⌈v/(μgh)⌉. A contact that is found a step late adds vh; another half for what
/// moves it meanwhile.
Judgement sliding_block_stops(const Adapter& adapter) {
  const double dt = 1e-3, speed = 0.5, friction = 0.4;
  const Scene scene = sliding({friction}, 0.3);
  const double loss = friction * scene.gravity * dt;
  const double steps = std::ceil(speed / loss);
  const double way = dt * ((steps - 1) * speed - loss * (steps - 1) * steps / 2);
  return {std::abs(final_slips(adapter, scene, dt)[0] - way), 1.5 * speed * dt,
          "deviation of the way along the ground, m"};
}

/// Of two equal blocks the upper one loses μ₂g and the lower one gains μ₂g − 2μ₁g until they move alike; then
/// both lose μ₁g.
Judgement each_interface_has_its_friction(const Adapter& adapter) {
  const double dt = 1e-3;
  const Scene scene = sliding({0.1, 0.4}, 1.2);
  const double floor = 0.1 * scene.gravity, between = 0.4 * scene.gravity;
  const double along = 2 * between - 2 * floor;
  const double time = 1 / along;
  const double speed = 0.5 + (between - 2 * floor) * time;
  const double lower = 0.5 * time + 0.5 * (between - 2 * floor) * time * time + 0.5 * speed * speed / floor;
  const std::vector<double> slips = final_slips(adapter, scene, dt);
  // Each speed, of a metre per second at most, is off by what friction takes in two steps.
  return {std::max(std::abs(slips[0] - lower), std::abs(slips[1] - 0.5 / along)), 4 * dt,
          "deviation of a slip, m"};
}

/// A block that sinks by g dt² on one side before it is held slides on down that slope, one of two such the
/// more.
Judgement without_friction_blocks_slide_on(const Adapter& adapter) {
  const Scene scene = sliding({0, 0}, 0.3);
  const double dt = 1e-3;
  const std::vector<double> slips = final_slips(adapter, scene, dt);
  const double slope = 2 * scene.gravity * dt * dt / 2;
  return {std::max(std::abs(slips[0] - 0.15), std::abs(slips[1] - 0.3)),
          0.5 * scene.gravity * slope * scene.duration * scene.duration, "deviation of a slip, m"};
}

}  // namespace rockstack
