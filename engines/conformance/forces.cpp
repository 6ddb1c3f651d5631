// What interfaces bear, beside closed forms and the momentum of what stands on them. An engine that tells no
// forces has nothing to be judged by.

#include "analytic/scene/kinematics.hpp"
#include "engines/conformance/check.hpp"

namespace rockstack {
namespace {

constexpr double slope = 0.3490658503988659;  // 20°, rad
constexpr double settled = 0.5;               // s, by when a block that is set down bears its weight
constexpr double near = 0.01;                 // of the weight, or of an impact

const Judgement untold{0, near, tells_no_forces};

Scene cube_on_slope(double friction) {
  Scene scene = at_rest({make_block(1, 1, 2500)}, 1);
  scene.inclination = slope;
  scene.friction = {friction};
  return scene;
}

struct Force {
  double normal, tangential;  ///< N, on the block
};

/// By how much the mean of what the ground bears from a time on is off the mean of what `expected` has for
/// the samples at which steps end, as a share of the weight. Engines that find contacts by overlap lose one
/// now and then: a step bears nothing, and the next one twice as much.
template <class Expected>
Judgement deviation(const Adapter& adapter, const Scene& scene, double from, const Expected& expected) {
  const ObservedMotion motion = run(adapter, scene);
  if (motion.history.reactions.empty()) return untold;
  double normal = 0, tangential = 0, steps = 0;
  for (std::size_t i = 1; i < motion.history.size(); ++i) {
    if (motion.history.times[i] < from) continue;
    const Reaction& told = motion.history.reactions[i];
    const Force force = expected(motion.history, i);
    normal += told.normal - force.normal;
    tangential += told.tangential - force.tangential;
    ++steps;
  }
  if (steps == 0) return {HUGE_VAL, near, "the block topples"};
  return {std::hypot(normal, tangential) / steps / (scene.blocks[0].mass * scene.gravity), near,
          "deviation of the mean force, as a share of the weight"};
}

/// What the pivot bears of a block that turns about it: the acceleration of its centre, R from the pivot and
/// at φ = slenderness − |angle| from above it, by φ'' = p² sin φ, and its weight.
Force pivot_force(const Block& block, double gravity, double angle, double velocity) {
  const double radius = std::hypot(block.half_width, block.half_height), side = angle < 0 ? -1 : 1;
  const double squared =
      block.mass * gravity * radius / (block.inertia + block.mass * radius * radius);  // p², 1/s²
  const double phi = std::atan2(block.half_width, block.half_height) - std::abs(angle);
  const double turning = squared * std::sin(phi), spin = velocity * velocity;
  return {block.mass * (gravity - radius * (turning * std::sin(phi) + spin * std::cos(phi))),
          -side * block.mass * radius * (turning * std::cos(phi) - spin * std::sin(phi))};
}

/// What an interface has to bear in a step, to the right and up, N: what those above it gain, less gravity.
Point<double> borne(const Scene& scene, const ObservedMotion& motion, std::size_t sample, std::size_t from) {
  Point<double> force = Point<double>::Zero();
  for (std::size_t k = from; k < scene.blocks.size(); ++k) {
    const BodyState &before = motion.body(sample - 1, k), &after = motion.body(sample, k);
    force += scene.blocks[k].mass *
             Point<double>((after.velocity_x - before.velocity_x) / usual_step,
                           (after.velocity_y - before.velocity_y) / usual_step + scene.gravity);
  }
  return force;
}

}  // namespace

Judgement resting_block_presses_with_its_weight(const Adapter& adapter) {
  const Scene scene = at_rest({make_block(1, 1, 2500)}, 1);
  const double weight = scene.blocks[0].mass * scene.gravity;
  return deviation(adapter, scene, settled, [&](const History&, std::size_t) { return Force{weight, 0}; });
}

/// N = mg cos 20° and T = mg sin 20°, up the slope: 9.218 and 3.355 N a kilogram.
Judgement block_on_a_slope_presses_by_its_tilt(const Adapter& adapter) {
  const Scene scene = cube_on_slope(1);
  const double weight = scene.blocks[0].mass * scene.gravity;
  const Force expected{weight * std::cos(slope), -weight * std::sin(slope)};
  return deviation(adapter, scene, settled, [&](const History&, std::size_t) { return expected; });
}

/// T = μN while it slides.
Judgement sliding_block_rubs_by_its_friction(const Adapter& adapter) {
  const double friction = 0.2;
  const Scene scene = cube_on_slope(friction);
  const double normal = scene.blocks[0].mass * scene.gravity * std::cos(slope);
  const Force expected{normal, -friction * normal};
  return deviation(adapter, scene, settled, [&](const History&, std::size_t) { return expected; });
}

/// By the block's own angle and velocity, those of the middle of the step.
Judgement pivot_bears_a_turning_block(const Adapter& adapter) {
  const double settling = 0.1, before_it_lands = 0.45;  // s
  const Scene scene = slender_block(before_it_lands);
  return deviation(adapter, scene, settling, [&](const History& history, std::size_t i) {
    return pivot_force(scene.blocks[0], scene.gravity, 0.5 * (history.angles[i - 1] + history.angles[i]),
                       0.5 * (history.velocities[i - 1] + history.velocities[i]));
  });
}

/// The paper's two blocks, through their impacts: d'Alembert's principle at both interfaces in every step.
Judgement forces_are_what_moves_the_blocks(const Adapter& adapter) {
  const Scene scene = paper_scene(1);
  const ObservedMotion motion = run(adapter, scene);
  const History& history = motion.history;
  if (history.reactions.empty()) return untold;
  double most = 0;
  for (std::size_t i = 1; i < history.size(); ++i)
    for (std::size_t k = 0; k < 2; ++k) {
      const double face = k == 0 ? 0 : history.angles_at(i - 1)[0];
      const double cosine = std::cos(face), sine = std::sin(face);
      const Reaction& told = history.row(history.reactions, i)[k];
      const Point<double> force{told.normal * sine + told.tangential * cosine,
                                told.normal * cosine - told.tangential * sine};
      const double scale = scene.blocks[k].mass * scene.gravity + force.norm();
      most = std::max(most, (force - borne(scene, motion, i, k)).norm() / scale);
    }
  return {most, near, "deviation from the momentum that blocks gain, as a share of weight and force"};
}

}  // namespace rockstack
