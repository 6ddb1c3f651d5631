// A block whose centre of mass is off its middle: it turns about that, stands over it, and each of its sides
// has a slenderness of its own.

#include "engines/conformance/rocking.hpp"

namespace rockstack {
namespace {

constexpr const char* middle_alone = "the engine's bodies have their centre of mass in the middle";

/// A statue: low and to the right in a box of 0.4 m by 2 m, with an inertia that is no rectangle's.
Block statue() {
  Block block = make_block(0.4, 2, 2500);
  block.inertia = 0.9 * block.inertia;
  block.offset_x = 0.06;
  block.offset_y = -0.25;
  return block;
}

/// Constants of its motion about the corner on a side, 1 to the right: tan α = (b ∓ e) / h, p² = mgR / I₀.
Housner about_corner(const Block& block, double gravity, int side) {
  const double across = block.half_width - side * block.offset_x, up = block.half_height + block.offset_y;
  const double radius = std::hypot(across, up);
  return {std::atan2(across, up),
          std::sqrt(block.mass * gravity * radius / (block.inertia + block.mass * radius * radius))};
}

/// The larger value of both sides.
template <class Judge>
Judgement on_both_sides(const Adapter& adapter, double limit, const char* what, const Judge& judge) {
  if (!adapter.center_of_mass) return {0, limit, middle_alone};
  double most = 0;
  for (const int side : {-1, 1}) {
    const double value = judge(side, about_corner(statue(), 9.81, side));
    most = std::isnan(value) ? HUGE_VAL : std::max(most, value);
  }
  return {most, limit, what};
}

}  // namespace

/// Thrown to the right from a metre above the ground, its centre of mass falls as if it did not turn.
Judgement eccentric_block_falls_as_it_turns(const Adapter& adapter) {
  const double dt = 1e-2, speed = 0.5, spin = 2;
  const double limit = 1e-4;  // a turn about another point of the block is off by centimetres
  if (!adapter.center_of_mass) return {0, limit, middle_alone};
  Scene scene = at_rest({statue()}, 0.3);
  scene.law = Law::unilateral;
  scene.initial.gaps = {1};
  scene.initial.slip_velocities = {speed};
  scene.initial.velocities = {spin};
  const ObservedMotion motion = run(adapter, scene, dt);
  const BodyState& start = motion.body(0, 0);
  double apart = 0;
  for (std::size_t sample = 0; sample < motion.history.size(); ++sample) {
    const auto n = static_cast<double>(sample);
    const BodyState& body = motion.body(sample, 0);
    const double fall = scene.gravity * dt * dt * n * (0.5 * n + adapter.lead);
    apart = std::max({apart, std::abs(body.x - start.x - speed * n * dt), std::abs(start.y - body.y - fall)});
  }
  const bool turns = std::abs(motion.history.angles.back() / (spin * scene.duration) - 1) < 0.01;
  return {turns ? apart : HUGE_VAL, limit, "largest deviation of the centre of mass, m"};
}

/// Pushed over either corner by three tenths more than its side bears: as strong_push_rocks(). A slenderness
/// that is wrong by 1 % shows as 3 %.
Judgement eccentric_block_rocks_both_ways(const Adapter& adapter) {
  const double duration = 0.3;
  return on_both_sides(adapter, 0.01 + short_step(adapter) / duration,
                       "angle's deviation from the closed form, as a share of it",
                       [&](int side, const Housner& corner) {
                         Scene scene = at_rest({statue()}, duration);
                         const double share = 1.3 * std::tan(corner.slenderness);
                         scene.horizontal = constant(-side * share * scene.gravity);
                         const History history = run(adapter, scene, short_step(adapter)).history;
                         const double exact = side * pushed_angle(corner, share, duration);
                         return std::abs(history.angles.back() / exact - 1);
                       });
}

/// Released at half the slenderness of either side: as quarter_period_is_housners().
Judgement eccentric_block_lands_in_time(const Adapter& adapter) {
  return on_both_sides(adapter, 1, "error, steps", [&](int side, const Housner& corner) {
    Scene scene = at_rest({statue()}, 0.8);
    const double start = 0.5 * corner.slenderness;
    scene.initial.angles = {side * start};
    const double landing = first_ground_impact(run(adapter, scene).history);
    return std::abs(landing - quarter_period(corner, start)) / usual_step;
  });
}

/// On a slope to either side the ground's force acts where the weight's line meets it: e + h tan(slope).
Judgement eccentric_block_bears_off_its_middle(const Adapter& adapter) {
  constexpr double limit = 0.01, tilt = 0.1, settled = 0.5;  // of the half width; rad; s
  if (!adapter.center_of_mass) return {0, limit, middle_alone};
  Scene scene = at_rest({statue()}, 1);
  const Block& block = scene.blocks[0];
  double most = 0;
  for (const double inclination : {-tilt, tilt}) {
    scene.inclination = inclination;
    const History history = run(adapter, scene).history;
    if (history.reactions.empty()) return {0, limit, tells_no_forces};
    double borne = 0, moment = 0;
    for (std::size_t i = 1; i < history.size(); ++i) {
      const Reaction& told = history.reactions[i];
      if (history.times[i] < settled || std::isnan(told.centre)) continue;
      borne += told.normal;
      moment += told.normal * told.centre;
    }
    const double exact = block.offset_x + (block.half_height + block.offset_y) * std::tan(inclination);
    const double apart = std::abs(moment / borne - exact) / block.half_width;
    most = std::isnan(apart) ? HUGE_VAL : std::max(most, apart);
  }
  return {most, limit, "deviation of the mean centre of the ground's force, as a share of the half width"};
}

}  // namespace rockstack
