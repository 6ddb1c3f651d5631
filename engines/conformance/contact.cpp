// Blocks that stand, are pushed, rock and hit the ground; and two, which show what one cannot: masses.

#include "engines/conformance/rocking.hpp"

namespace rockstack {
namespace {

/// The larger of angle and velocity over what they may be.
Judgement quiet(const Adapter& adapter, const Scene& scene, double limit) {
  const History history = run(adapter, scene).history;
  return {std::max(largest_magnitude(history.angles), largest_magnitude(history.velocities) * usual_step),
          limit, "largest angle, or angular velocity times the step, rad"};
}

double quarter_period_error(const Adapter& adapter, double dt) {
  const double exact = quarter_period(Housner{}, slender_block(1).initial.angles[0]);
  return std::abs(first_ground_impact(run(adapter, slender_block(0.7), dt).history) - exact);
}

bool topples(const Adapter& adapter, double share) {
  Scene scene = slender_block(4);
  scene.initial.angles = {share * Housner{}.slenderness};
  return run(adapter, scene).history.times.back() < scene.duration - 1e-6;
}

}  // namespace

/// In its first step the block sinks by g dt² at most before a contact holds it, perhaps on one side first.
Judgement block_at_rest_stays(const Adapter& adapter) {
  return quiet(adapter, at_rest({make_block(0.4, 2, 2500)}, 1), 9.81 * usual_step * usual_step / 0.4);
}

/// As above, for each of two interfaces over its width; the narrower is 1 m.
Judgement stack_at_rest_stays(const Adapter& adapter) {
  return quiet(adapter, at_rest(paper_scene(1).blocks, 1), 2 * 9.81 * usual_step * usual_step);
}

/// A contact holds where faces meet, not a tenth of a millimetre later, and is found at most a step late, in
/// which a block at rest falls by g dt²; as much again is for what an iterative solver leaves over.
Judgement stack_keeps_its_height(const Adapter& adapter) {
  const Scene scene = at_rest(paper_scene(1).blocks, 1);
  const ObservedMotion motion = run(adapter, scene);
  double most = 0;
  for (std::size_t n = 0; n < motion.history.size(); ++n) {
    double below = 0;  // how far the face has moved on which a block stands
    for (std::size_t k = 0; k < scene.blocks.size(); ++k) {
      const double moved = motion.body(n, k).y - motion.body(0, k).y;
      most = std::max(most, std::abs(moved - below));
      below = moved;
    }
  }
  return {most, 2 * scene.gravity * usual_step * usual_step,
          "largest change of the distance between faces that touch, m"};
}

/// A squat block under 0.8 g, which its width carries twice over, does not move along the ground: the
/// friction asked for is far beyond 0.8. It may creep by what an iterative solver leaves of each step's push.
Judgement pushed_block_does_not_slide(const Adapter& adapter) {
  Scene scene = at_rest({make_block(1, 0.5, 2500)}, 0.5);
  scene.horizontal = constant(0.8 * scene.gravity);
  // Without friction it would be 0.98 m.
  return {std::abs(run(by_force(adapter), scene).bodies.back().x), 1e-3, "way along the ground, m"};
}

Judgement weak_push_does_not_rock(const Adapter& adapter) {
  Scene scene = at_rest({make_block(0.4, 2, 2500)}, 0.3);
  scene.horizontal = constant(0.95 * 0.2 * 9.81);
  return quiet(adapter, scene, 9.81 * usual_step * usual_step / 0.4);
}

Judgement strong_push_rocks(const Adapter& adapter) {
  const double share = 1.1 * 0.2;
  Scene scene = at_rest({make_block(0.4, 2, 2500)}, 0.3);
  scene.horizontal = constant(share * 9.81);
  const History history = run(adapter, scene, short_step(adapter)).history;
  // The next order is θ/2 of it, under 1 %; half a step ahead is dt/0.3 of it, as is the rounding at the
  // shorter step.
  const double exact = -pushed_angle(Housner{}, share, scene.duration);
  return {std::abs(history.angles.back() / exact - 1), 0.01 + short_step(adapter) / 0.3,
          "angle's deviation from the closed form, as a share of it"};
}

/// Half a step of the scheme, and half a step for an overlap that the pivot keeps.
Judgement quarter_period_is_housners(const Adapter& adapter) {
  double most = 0;
  for (const double dt : {2e-3, 1e-3, 5e-4, 1e-4})
    if (dt >= short_step(adapter)) most = std::max(most, quarter_period_error(adapter, dt) / dt);
  return {std::isnan(quarter_period_error(adapter, 1e-3)) ? HUGE_VAL : most, 1, "error, steps"};
}

/// A first-order error over an eighth of the step is an eighth; a quarter leaves room for the second order.
Judgement quarter_period_error_is_of_first_order(const Adapter& adapter) {
  const double factor = short_step(adapter) / 1e-4;
  const double ratio =
      quarter_period_error(adapter, factor * 2.5e-4) / quarter_period_error(adapter, factor * 2e-3);
  return {std::isnan(ratio) ? HUGE_VAL : ratio, 0.25, "error over that at eight times the step"};
}

/// Housner 1963: the angular velocity falls to 1 − 3/2 sin² α of it, here from start and peak by energy.
Judgement impact_loses_housners_share(const Adapter& adapter) {
  const double dt = short_step(adapter);
  const Scene scene = slender_block(1.1);
  const History history = run(adapter, scene, dt).history;
  const Housner block;
  const double peak = -*std::ranges::min_element(history.angles);
  const double start = block.speed_at_ground(scene.initial.angles[0]);
  const double sine = std::sin(block.slenderness);
  const double ratio = block.speed_at_ground(std::clamp(peak, 0.0, block.slenderness)) / start;
  // The velocity on either side of the impact is known to what one step changes in it.
  const double one_step = block.frequency * block.frequency * sine * dt / start;
  return {std::abs(ratio - (1 - 1.5 * sine * sine)), 2 * one_step, "deviation of the velocity ratio"};
}

/// The ground falls away for 0.2 s at 2 m/s² more than gravity, then stays; the block comes down flat. A
/// rocking block's impact shows no bounce: its hops end at the same pivot with the same angular momentum.
Judgement flat_landing_does_not_bounce(const Adapter& adapter) {
  Scene scene = at_rest({make_block(1, 0.5, 2500)}, 1);
  scene.vertical.interval = 0.2;
  scene.vertical.samples = {-scene.gravity - 2, -scene.gravity - 2, 0};
  const ObservedMotion motion = run(by_force(adapter), scene);
  double down = 0, up = 0;
  for (std::size_t n = 1; n < motion.history.size(); ++n) {
    const double velocity = motion.body(n, 0).velocity_y;
    down = std::max(down, -velocity);
    if (n > 401 && down > 0) up = std::max(up, velocity);
  }
  // Half of the bounce that is to be seen, one of 0.2.
  return {down > 0.5 ? up / down : HUGE_VAL, 0.1, "velocity up over that of the landing"};
}

/// Released 1 % inside its slenderness a block comes back, 1 % outside it topples.
Judgement topples_from_its_slenderness(const Adapter& adapter) {
  const double wrong = (topples(adapter, 0.99) ? 1 : 0) + (topples(adapter, 1.01) ? 0 : 1);
  return {wrong, 0, "wrong verdicts of two"};
}

/// Both blocks leave the ground, which falls away at 20 m/s² more than gravity, while the upper one turns
/// back onto the lower. What one then gains along the ground, the other loses: with the scene's masses, to
/// less than a fifth of the percent that a mass may be wrong by.
Judgement pair_keeps_its_momentum(const Adapter& adapter) {
  Scene scene = at_rest({make_block(1.25, 1.25, 2500), make_block(1, 2.5, 2500)}, 0.8);
  scene.initial = {{0, 0.3}, {0, -1.5}};
  scene.vertical = constant(-scene.gravity - 20);
  const ObservedMotion motion = run(adapter, scene);
  const auto momentum = [&](std::size_t sample, std::size_t block) {
    return scene.blocks[block].mass * motion.body(sample, block).velocity_x;
  };
  // 0.1 m up: out of reach of any contact with the ground that an engine may keep.
  const double base = momentum(100, 0), sum = base + momentum(100, 1);
  double change = 0, exchanged = 0;
  for (std::size_t n = 101; n < motion.history.size(); ++n) {
    change = std::max(change, std::abs(momentum(n, 0) + momentum(n, 1) - sum));
    exchanged = std::max(exchanged, std::abs(momentum(n, 0) - base));
  }
  if (!(exchanged > 100)) return {HUGE_VAL, 0, "the blocks never met, or hardly rubbed"};
  return {change / exchanged, 0.002, "change of the sum over what the blocks exchange"};
}

/// Spanos et al. 2001, free rocking: the first ground impact by the event-driven solution is at 0.60565 s.
Judgement pair_meets_the_ground_in_time(const Adapter& adapter) {
  const double dt = short_step(adapter);
  const double error = std::abs(first_ground_impact(run(adapter, paper_scene(0.65), dt).history) - 0.60565);
  return {std::isnan(error) ? HUGE_VAL : error / dt, 2, "error, steps"};
}

}  // namespace rockstack
