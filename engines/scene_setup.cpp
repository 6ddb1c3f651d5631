#include "engines/scene_setup.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "analytic/scene/applied_forces.hpp"
#include "analytic/scene/lists.hpp"
#include "analytic/scene/restraint_law.hpp"
#include "analytic/scene/solve_options.hpp"

namespace rockstack {
namespace {

/// ∫ (end − t) a(t) dt over [from, to], on which the acceleration is smooth.
double smooth_displacement_integral(const GroundMotion& motion, double from, double to, double end) {
  // Gauss–Legendre on [−1, 1].
  static constexpr std::array<double, 3> points{0, 0.5384693101056831, 0.9061798459386640};
  static constexpr std::array<double, 3> weights{0.5688888888888889, 0.4786286704993665, 0.2369268850561891};
  const double middle = 0.5 * (from + to), half = 0.5 * (to - from);
  const auto value = [&](double t) { return (end - t) * acceleration(motion, t); };
  double sum = weights[0] * value(middle);
  for (std::size_t i = 1; i < points.size(); ++i)
    sum += weights[i] * (value(middle - half * points[i]) + value(middle + half * points[i]));
  return half * sum;
}

/// The next time after t at which the acceleration is not smooth.
double next_kink(const GroundMotion& motion, double t) {
  if (motion.pulse) return t < motion.pulse->start ? motion.pulse->start : motion.end();
  return motion.interval * (std::floor(t / motion.interval) + 1);
}

double displacement_integral(const GroundMotion& motion, double from, double to) {
  if (!motion.steps.empty()) {
    double sum = 0;
    for (const VelocityStep& step : motion.steps)
      if (step.time >= from && step.time < to) sum += step.size * (to - step.time);
    return sum;
  }
  const double last = std::min(to, motion.end());
  double sum = 0;
  for (double t = from; t < last;) {
    double next = std::min(last, next_kink(motion, t));
    if (!(next > t)) next = last;  // a kink that rounding puts at t itself
    sum += smooth_displacement_integral(motion, t, next, to);
    t = next;
  }
  return sum;
}

/// @throws Stopped at one step in many, where cancelled.
void look_at(std::size_t step, const std::function<bool()>* cancelled) {
  constexpr std::size_t steps_between_looks = 65536;  // some milliseconds
  if ((step + 1) % steps_between_looks == 0) stop_if_cancelled(cancelled);
}

/// Blocks count from 1 there.
BodyPoint body_point(int block, const Point<double>& arm) {
  return {static_cast<std::size_t>(block + 1), arm.x(), arm.y()};
}

AppliedRestraint applied_restraint(const RestraintLaw<double>& law) {
  return {.from = body_point(law.from, law.from_arm),
          .to = body_point(law.to, law.to_arm),
          .length = law.length,
          .stiffness = law.stiffness,
          .prestress = law.prestress,
          .yield = law.yield,
          .damping = law.damping};
}

/// Pushes with their mean forces over steps, so that engines give impulses whole.
std::vector<AppliedPush> applied_pushes(const Scene& scene, double dt, std::size_t steps,
                                        const std::function<bool()>* cancelled) {
  std::vector<AppliedPush> pushes;
  for (const PushPoint<double>& point : push_points<double>(scene)) {
    const GroundMotion& force = scene.pushes[pushes.size()].force;
    AppliedPush& push = pushes.emplace_back();
    push.point = body_point(point.block, point.arm);
    push.direction_x = point.direction.x();
    push.direction_y = point.direction.y();
    push.forces.reserve(steps);
    for (std::size_t step = 0; step < steps; ++step) {
      look_at(step, cancelled);
      push.forces.push_back(
          mean_acceleration(force, static_cast<double>(step) * dt, static_cast<double>(step + 1) * dt));
    }
  }
  return pushes;
}

/// Along one axis: displacement and velocity of the ground at the start of the next step.
struct GroundAxis {
  double displacement = 0, velocity = 0;

  /// Moves on to the end of the step; returns the mean velocity over it.
  double advance(const GroundMotion& motion, double from, double to) {
    if (motion.empty()) return 0;
    const double length = to - from;
    const double mean = velocity + displacement_integral(motion, from, to) / length;
    displacement += mean * length;
    velocity += mean_acceleration(motion, from, to) * length;
    return mean;
  }
};

/// @throws std::runtime_error, as require_able().
void require_applied_forces(const EngineDescription& engine, const Scene& scene) {
  if (engine.capabilities.applied_forces) return;
  for (const auto& [key, given] :
       {std::pair{"push", !scene.pushes.empty()}, {"restraint", !scene.restraints.empty()}})
    if (given)
      throw std::runtime_error(fmt::format("{}: {} is told of no forces on blocks", key, engine.full_name()));
}

}  // namespace

std::vector<GroundStep> ground_path(const Scene& scene, double dt, std::size_t steps,
                                    const std::function<bool()>* cancelled) {
  std::vector<GroundStep> path;
  path.reserve(steps);
  GroundAxis x, y;
  for (std::size_t step = 0; step < steps; ++step) {
    look_at(step, cancelled);
    const double from = static_cast<double>(step) * dt, to = static_cast<double>(step + 1) * dt;
    GroundStep& now = path.emplace_back(GroundStep{x.displacement, y.displacement});
    now.velocity_x = x.advance(scene.horizontal, from, to);
    now.velocity_y = y.advance(scene.vertical, from, to);
  }
  return path;
}

BodyAcceleration body_acceleration(const Scene& scene) {
  const Gravity gravity = gravity_of(scene);
  return {gravity.along, -gravity.across};
}

BodyAcceleration body_acceleration(const Scene& scene, double from, double to) {
  const BodyAcceleration still = body_acceleration(scene);
  return {still.x - mean_acceleration(scene.horizontal, from, to),
          still.y - mean_acceleration(scene.vertical, from, to)};
}

FixedBox place_wall(const Placement& block, int side) {
  const double size = 2 * block.height;
  return {side * (block.width + size) / 2, size / 2, size, size, block.depth};
}

Parameters with_restitution(const EngineDescription& engine, const Scene& scene, Parameters parameters) {
  if (scene.point_restitution == 0) return parameters;
  for (const Setting& setting : engine.settings) {
    if (setting.role == SettingRole::restitution) parameters[setting.name] = scene.point_restitution;
    if (setting.role == SettingRole::restitution_threshold) parameters[setting.name] = setting.least;
  }
  return parameters;
}

void require_able(const EngineDescription& engine, const Scene& scene) {
  const bool bounces =
      std::ranges::find(engine.settings, SettingRole::restitution, &Setting::role) != engine.settings.end();
  if (scene.point_restitution != 0 && !bounces)
    throw std::runtime_error(
        fmt::format("contact.restitution: {} has no coefficient of restitution", engine.full_name()));
  require_applied_forces(engine, scene);
  const auto off = std::ranges::find_if(
      scene.blocks, [](const Block& block) { return block.offset_x != 0 || block.offset_y != 0; });
  if (off != scene.blocks.end() && !engine.capabilities.center_of_mass)
    throw std::runtime_error(
        fmt::format("blocks.{}.center_of_mass: {} has centres of mass in the middle of its boxes",
                    off - scene.blocks.begin() + 1, engine.full_name()));
}

void require_wall(const EngineDescription& engine, const Scene& scene) {
  if (scene.wall.side != 0 && !engine.capabilities.wall)
    throw std::runtime_error(fmt::format("wall: {} is told of none", engine.full_name()));
}

double step_count(double duration, double dt) {
  return std::floor(duration / dt + 1e-9);
}

bool moves_ground(const Parameters& parameters) {
  // All engines that can move the ground name the parameter so.
  const auto shaking = parameters.find("shaking");
  return shaking != parameters.end() && shaking->second != 0;
}

Setup set_up(const Scene& scene, double dt, const Parameters& parameters,
             const std::function<bool()>* cancelled) {
  check_step(dt, scene.duration);
  Setup setup;
  setup.blocks = place(scene);
  setup.friction = friction_of(scene);
  setup.kinetic_friction = scene.kinetic_friction;
  setup.gravity = body_acceleration(scene);
  if (scene.wall.side != 0) setup.wall = place_wall(setup.blocks.front(), scene.wall.side);
  for (int k = 0; k < static_cast<int>(scene.blocks.size()); ++k)
    setup.toppling_angles.push_back(toppling_angle(scene, k));
  setup.dt = dt;
  setup.steps = static_cast<std::size_t>(step_count(scene.duration, dt));
  setup.pushes = applied_pushes(scene, dt, setup.steps, cancelled);
  setup.restraints = mapped(restraint_laws<double>(scene), applied_restraint);
  if (!is_shaken(scene)) return setup;
  if (moves_ground(parameters)) {
    setup.ground = ground_path(scene, dt, setup.steps, cancelled);
    return setup;
  }
  setup.accelerations.reserve(setup.steps);
  for (std::size_t step = 0; step < setup.steps; ++step) {
    look_at(step, cancelled);
    setup.accelerations.push_back(
        body_acceleration(scene, static_cast<double>(step) * dt, static_cast<double>(step + 1) * dt));
  }
  return setup;
}

void check_step(double dt, double duration) {
  const double shortest = 1e-9 * duration;
  if (!(dt >= shortest && dt <= duration * (1 + 1e-9)))
    throw std::invalid_argument(
        fmt::format("dt = {} s: must be from {} s to the duration, {} s", dt, shortest, duration));
}

}  // namespace rockstack
