// What an adapter tells its engine about bodies and forces, seen in the engine's own scheme.

#include <algorithm>
#include <cmath>

#include "engines/conformance/scenes.hpp"

namespace rockstack {

/// vₙ = n a dt, yₙ = y₀ + a dt² (n²/2 + lead × n); semi-implicit Euler has n(n + 1)/2. The ground falls away
/// at 2 m/s² more than gravity, so that in its frame the block rises at that acceleration and nothing touches
/// it.
Judgement free_fall_is_the_schemes(const Adapter& adapter) {
  const double dt = 1e-2;
  Scene scene = at_rest({make_block(0.4, 2, 2500)}, 1);
  scene.vertical = constant(-scene.gravity - 2);
  const ObservedMotion motion = run(adapter, scene, dt);
  const int steps = 100;
  double apart = motion.history.size() == steps + 1 ? 0 : HUGE_VAL;
  for (std::size_t sample = 1; sample < motion.history.size(); ++sample) {
    const auto n = static_cast<double>(sample);
    const BodyState& body = motion.body(sample, 0);
    apart = std::max({apart, std::abs(body.y - (1 + dt * dt * n * (n + 2 * adapter.lead))),
                      std::abs(body.velocity_y - 2 * n * dt), std::abs(body.x)});
  }
  // Each step rounds gravity, velocity and place, which stay below 10, once or twice. What chooses steps by
  // an accuracy errs where it starts, at its lowest order; from then on a parabola has no error.
  const auto accuracy = adapter.parameters.find("accuracy");
  const double chosen = accuracy != adapter.parameters.end() ? accuracy->second : 0;
  return {apart, std::max(30 * steps * rounding(adapter), chosen),
          "largest deviation of place (m) or velocity (m/s)"};
}

/// With both bottom corners of one side on the ground, the velocity after one step is that under gravity
/// alone, where the engine does not see the contact yet, or that of a hinge at the corner:
/// ω = dt m g (b cos θ − h sin θ) / (I + m (b² + h²)).
Judgement first_step_is_free_fall_or_a_hinge(const Adapter& adapter) {
  const double dt = 1e-3;
  const Scene scene = slender_block(dt);
  const ObservedMotion motion = run(adapter, scene, dt);
  const double velocity = motion.history.velocities.back();
  const Block& block = scene.blocks[0];
  const double start = scene.initial.angles[0];
  const double arm = block.half_width * std::cos(start) - block.half_height * std::sin(start);
  const double about_pivot =
      block.inertia + block.mass * (std::pow(block.half_width, 2) + std::pow(block.half_height, 2));
  const double hinge = -dt * block.mass * scene.gravity * arm / about_pivot;
  const double fall = -scene.gravity * dt;
  const double from_hinge = std::abs(velocity - hinge) / std::abs(hinge);
  const double from_fall = std::max(std::abs(velocity) / std::abs(hinge),
                                    std::abs(motion.bodies.back().velocity_y - fall) / -fall);
  // An iterative solver leaves some 1e-4 of the change to later steps.
  return {std::min(from_hinge, from_fall), 1e-3, "share of the hinge's or the fall's velocity"};
}

/// Gravity and half of it add without rounding, so that both runs are the same to the bit in double
/// precision; in single the sum is rounded either way.
Judgement falling_ground_is_weaker_gravity(const Adapter& adapter) {
  Scene falling = slender_block(1);
  falling.vertical = constant(-0.5 * falling.gravity);
  Scene weaker = slender_block(1);
  weaker.gravity = 0.5 * weaker.gravity;
  const Adapter force = by_force(adapter);
  const auto one = run(force, falling, 1e-3).history.angles;
  auto apart = run(force, weaker, 1e-3).history.angles;
  for (std::size_t i = 0; i < apart.size() && i < one.size(); ++i) apart[i] -= one[i];
  return {one.size() == apart.size() ? largest(apart) : HUGE_VAL, 0, "largest angle difference, rad"};
}

Judgement mirrored_scene_mirrors_motion(const Adapter& adapter) {
  const double dt = 1e-3;
  Scene scene = slender_block(1);
  scene.horizontal.interval = 0.25;
  scene.horizontal.samples = {0, 0.5, -0.5, 0.25, 0};
  const History history = run(adapter, scene, dt).history;
  scene.initial.angles[0] *= -1;
  for (double& sample : scene.horizontal.samples) sample *= -1;
  std::vector<double> sum = run(adapter, scene, dt).history.angles;
  if (sum.size() != history.angles.size()) return {HUGE_VAL, 0, "one of the two topples"};
  for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += history.angles[i];
  // Contacts are taken in another order, which may shift an impact by a step.
  return {largest(sum), largest(history.velocities) * dt, "largest sum of mirrored angles, rad"};
}

/// The paper's two blocks, with all their impacts.
Judgement motion_stays_in_the_plane(const Adapter& adapter) {
  const double dt = 1e-3;
  double most = 0;
  for (const BodyState& body : run(adapter, paper_scene(2), dt).bodies)
    most = std::max({most, std::abs(body.z), body.tilt});
  // Rounding of numbers near 1, not gathered up from step to step.
  return {most, 100 * rounding(adapter), "largest place (m) or tilt out of the plane"};
}

}  // namespace rockstack
