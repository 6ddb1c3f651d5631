// Pushes, tendons and dampers on a block without weight that nothing touches.

#include "engines/conformance/check.hpp"

namespace rockstack {
namespace {

constexpr const char* no_forces_on_blocks = "the engine is told of no forces on blocks";

constexpr double speed = 0.5;  ///< at which a block begins, m/s
constexpr double gap = 0.5;    ///< over the ground, m
constexpr double reach = 3;    ///< from its middle to where restraints are anchored, m

/// A cube that floats, as its ground falls as it does.
Scene floating(double velocity, double duration) {
  Scene scene = at_rest({make_block(1, 1, 500)}, duration);
  scene.law = Law::unilateral;
  scene.initial.gaps = {gap};
  scene.initial.slip_velocities = {velocity};
  scene.vertical = constant(-scene.gravity);
  return scene;
}

/// Between the cube's middle and the ground, whose anchor is as high, to its right or left.
Restraint restraint(RestraintKind kind, int side) {
  Restraint made;
  made.kind = kind;
  made.from = {1, 0, 0.5};
  made.to = {0, side * reach, gap + 0.5};
  return made;
}

/// What numbers near the reach lose by rounding over so many steps, m, or m/s; and what an engine that
/// chooses its steps may be off by.
double rounded_off(const Adapter& adapter, const Scene& scene) {
  const auto accuracy = adapter.parameters.find("accuracy");
  return 2 * reach * rounding(adapter) * scene.duration / usual_step +
         (accuracy != adapter.parameters.end() ? accuracy->second : 0);
}

}  // namespace

/// A constant force F at an arm r moves the centre by Ft²/2m and turns the block by Frt²/2I, both read `lead`
/// steps ahead. As the block turns by θ its arm shortens: θ lacks θ³/30 then.
Judgement push_moves_and_turns_a_block(const Adapter& adapter) {
  const double force = 1e4, arm = 0.1;
  Scene scene = floating(0, 0.1);
  scene.pushes = {{.point = {1, 0, 0.5 + arm}, .force = constant(force)}};
  const double n = scene.duration / usual_step;
  const double halved = usual_step * usual_step * n * (0.5 * n + adapter.lead);
  const Block& block = scene.blocks[0];
  const double way = force / block.mass * halved, angle = force * arm / block.inertia * halved;
  if (!adapter.applied_forces) return {0, 0, no_forces_on_blocks};
  const ObservedMotion motion = run(by_force(adapter), scene);
  const double apart =
      std::max(std::abs(motion.bodies.back().x - way), std::abs(motion.history.angles.back() - angle));
  return {apart, std::pow(angle, 3) / 20 + rounded_off(adapter, scene),
          "deviation of the way (m) or the angle (rad)"};
}

/// Between two tendons a block swings along them by ω² = 2k/m, whatever their prestress: x = (v/ω) sin ωt. A
/// force that is constant over a step h changes ω by its share (ωh)²/24.
Judgement block_swings_on_tendons(const Adapter& adapter) {
  Scene scene = floating(speed, 0.3);
  for (const int side : {-1, 1}) {
    Restraint& tendon = scene.restraints.emplace_back(restraint(RestraintKind::tendon, side));
    tendon.stiffness = 5e4;
    tendon.prestress = 2e4;
  }
  const double frequency = std::sqrt(2 * 5e4 / scene.blocks[0].mass);
  if (!adapter.applied_forces) return {0, 0, no_forces_on_blocks};
  const ObservedMotion motion = run(by_force(adapter), scene);
  double apart = 0;
  for (std::size_t i = 0; i < motion.history.size(); ++i)
    apart = std::max(apart, std::abs(motion.body(i, 0).x -
                                     speed / frequency * std::sin(frequency * motion.history.times[i])));
  const double step = frequency * usual_step;
  return {apart, speed * scene.duration * step * step / 6 + rounded_off(adapter, scene),
          "largest deviation of the way, m"};
}

/// v = v₀ exp(−ct/m). Taken as a step begins, the damper's force is larger by a share of ch/2m.
Judgement damper_slows_a_block(const Adapter& adapter) {
  Scene scene = floating(speed, 0.5);
  scene.restraints = {restraint(RestraintKind::damper, 1)};
  scene.restraints[0].damping = 1000;
  const double rate = 1000 / scene.blocks[0].mass;
  if (!adapter.applied_forces) return {0, 0, no_forces_on_blocks};
  const ObservedMotion motion = run(by_force(adapter), scene);
  const double left = speed * std::exp(-rate * scene.duration);
  return {std::abs(motion.bodies.back().velocity_x - left),
          left * rate * scene.duration * rate * usual_step + rounded_off(adapter, scene),
          "deviation of the velocity, m/s"};
}

/// A tendon stretches by Y/k, yields at Y until the block stops, and throws it back with what it holds,
/// Y²/2k, until it is slack: v = −Y/√(km), and no force any more.
Judgement tendon_yields_and_goes_slack(const Adapter& adapter) {
  const double stiffness = 5e4, yield = 1000;
  Scene scene = floating(speed, 0.8);
  scene.restraints = {restraint(RestraintKind::tendon, -1)};
  scene.restraints[0].stiffness = stiffness;
  scene.restraints[0].yield = yield;
  // Slack where the cube floats; upright on the ground it would be longer.
  scene.restraints[0].prestress = stiffness * (std::hypot(reach, gap) - reach);
  const double mass = scene.blocks[0].mass, frequency = std::sqrt(stiffness / mass);
  if (!adapter.applied_forces) return {0, 0, no_forces_on_blocks};
  const ObservedMotion motion = run(by_force(adapter), scene);
  const double back = -yield / std::sqrt(stiffness * mass);
  return {std::abs(motion.bodies.back().velocity_x - back),
          std::abs(back) * frequency * usual_step + rounded_off(adapter, scene),
          "deviation of the velocity when slack, m/s"};
}

}  // namespace rockstack
