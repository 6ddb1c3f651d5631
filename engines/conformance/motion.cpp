// What a worker promises about how it is called; what an adapter tells its engine about bodies and forces,
// in the engine's own scheme; blocks that slide on each other and the ground, with a coefficient each.

#include "engines/conformance/check.hpp"

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
std::vector<double> final_slips(const Adapter& adapter, const Scene& scene) {
  const std::vector<double> slips = run(adapter, scene).history.slips;
  return {slips.end() - static_cast<std::ptrdiff_t>(scene.blocks.size()), slips.end()};
}

}  // namespace

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

/// With another run before it, in the same process where the worker shares one.
Judgement same_run_gives_the_same_bits(const Adapter& adapter) {
  const Scene scene = paper_scene(1);
  const auto one = run(adapter, scene).history.angles;
  run(adapter, slender_block(0.5));
  const auto other = run(adapter, scene).history.angles;
  return {one == other ? 0.0 : 1.0, 0, "runs of two that differ"};
}

/// The sample in which a block is past the angle at which it has toppled is the last.
Judgement history_ends_where_a_block_topples(const Adapter& adapter) {
  Scene scene = slender_block(3);
  scene.initial.velocities = {2};
  const Setup setup = set_up(scene, 1e-3, adapter.parameters);
  const std::vector<double> angles = adapter.run(setup, adapter.parameters).angles;
  const auto beyond =
      std::ranges::count_if(angles, [&](double angle) { return std::abs(angle) > setup.toppling_angles[0]; });
  return {beyond == 1 && std::abs(angles.back()) > setup.toppling_angles[0] ? 0.0 : 1.0, 0,
          "1 where the run does not end with the first sample past the toppling angle"};
}

/// vₙ = n a dt, yₙ = y₀ + a dt² (n²/2 + lead × n); semi-implicit Euler has n(n + 1)/2. The ground falls away
/// at 2 m/s² more than gravity: in its frame the block rises at that acceleration, and nothing touches it.
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
  const Scene scene = slender_block(usual_step);
  const ObservedMotion motion = run(adapter, scene);
  const double velocity = motion.history.velocities.back();
  const Block& block = scene.blocks[0];
  const double start = scene.initial.angles[0];
  const double arm = block.half_width * std::cos(start) - block.half_height * std::sin(start);
  const double about_pivot =
      block.inertia + block.mass * (std::pow(block.half_width, 2) + std::pow(block.half_height, 2));
  const double hinge = -usual_step * block.mass * scene.gravity * arm / about_pivot;
  const double fall = -scene.gravity * usual_step;
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
  const auto one = run(force, falling).history.angles;
  auto apart = run(force, weaker).history.angles;
  for (std::size_t i = 0; i < apart.size() && i < one.size(); ++i) apart[i] -= one[i];
  return {one.size() == apart.size() ? largest_magnitude(apart) : HUGE_VAL, 0,
          "largest angle difference, rad"};
}

Judgement mirrored_scene_mirrors_motion(const Adapter& adapter) {
  Scene scene = slender_block(1);
  scene.horizontal.interval = 0.25;
  scene.horizontal.samples = {0, 0.5, -0.5, 0.25, 0};
  const History history = run(adapter, scene).history;
  scene.initial.angles[0] *= -1;
  for (double& sample : scene.horizontal.samples) sample *= -1;
  std::vector<double> sum = run(adapter, scene).history.angles;
  if (sum.size() != history.angles.size()) return {HUGE_VAL, 0, "one of the two topples"};
  for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += history.angles[i];
  // Contacts are taken in another order, which may shift an impact by a step.
  return {largest_magnitude(sum), largest_magnitude(history.velocities) * usual_step,
          "largest sum of mirrored angles, rad"};
}

/// The paper's two blocks, with all their impacts.
Judgement motion_stays_in_the_plane(const Adapter& adapter) {
  double most = 0;
  for (const BodyState& body : run(adapter, paper_scene(2)).bodies)
    most = std::max({most, std::abs(body.z), body.tilt});
  // Rounding of numbers near 1, not gathered up from step to step.
  return {most, 100 * rounding(adapter), "largest place (m) or tilt out of the plane"};
}

/// The scheme takes μgh off the velocity in each step before it moves the block: from v it goes h[(K − 1) v −
/// μgh (K − 1) K/2], K = ⌈v/(μgh)⌉. A contact found a step late adds vh; half of it is for its motion then.
Judgement sliding_block_stops(const Adapter& adapter) {
  const double speed = 0.5, friction = 0.4;
  const Scene scene = sliding({friction}, 0.3);
  const double loss = friction * scene.gravity * usual_step;
  const double steps = std::ceil(speed / loss);
  const double way = usual_step * ((steps - 1) * speed - loss * (steps - 1) * steps / 2);
  return {std::abs(final_slips(adapter, scene)[0] - way), 1.5 * speed * usual_step,
          "deviation of the way along the ground, m"};
}

/// Two equal blocks: the upper one loses μ₂g and the lower one gains μ₂g − 2μ₁g until they move alike; then
/// both lose μ₁g.
Judgement each_interface_has_its_friction(const Adapter& adapter) {
  const Scene scene = sliding({0.1, 0.4}, 1.2);
  const double floor = 0.1 * scene.gravity, between = 0.4 * scene.gravity;
  const double along = 2 * between - 2 * floor;
  const double time = 1 / along;
  const double speed = 0.5 + (between - 2 * floor) * time;
  const double lower = 0.5 * time + 0.5 * (between - 2 * floor) * time * time + 0.5 * speed * speed / floor;
  const std::vector<double> slips = final_slips(adapter, scene);
  // Each speed, of a metre per second at most, is off by what friction takes in two steps.
  return {std::max(std::abs(slips[0] - lower), std::abs(slips[1] - 0.5 / along)), 4 * usual_step,
          "deviation of a slip, m"};
}

/// A block sinks by g dt² on one side before it is held, and slides on down that slope; one of two the more.
Judgement without_friction_blocks_slide_on(const Adapter& adapter) {
  const Scene scene = sliding({0, 0}, 0.3);
  const std::vector<double> slips = final_slips(adapter, scene);
  const double slope = 2 * scene.gravity * usual_step * usual_step / 2;
  return {std::max(std::abs(slips[0] - 0.15), std::abs(slips[1] - 0.3)),
          0.5 * scene.gravity * slope * scene.duration * scene.duration, "deviation of a slip, m"};
}

}  // namespace rockstack
