// Two blocks, which show what one cannot: masses.

#include <algorithm>
#include <cmath>

#include "engines/conformance/scenes.hpp"

namespace rockstack {
namespace {

struct Momentum {
  double sum = 0;   ///< of both blocks, along the ground, kg m/s
  double base = 0;  ///< of the lower one alone
};

Momentum momentum(const Scene& scene, const ObservedMotion& motion, std::size_t sample) {
  const double base = scene.blocks[0].mass * motion.body(sample, 0).velocity_x;
  return {base + scene.blocks[1].mass * motion.body(sample, 1).velocity_x, base};
}

}  // namespace

/// Both blocks leave the ground, which falls away at 20 m/s² more than gravity, while the upper one turns
/// back onto the lower. What one then gains along the ground, the other loses: with the scene's masses, to
/// less than a fifth of the percent that a mass may be wrong by.
Judgement pair_keeps_its_momentum(const Adapter& adapter) {
  const double dt = 1e-3;
  Scene scene = at_rest({make_block(1.25, 1.25, 2500), make_block(1, 2.5, 2500)}, 0.8);
  scene.initial = {{0, 0.3}, {0, -1.5}};
  scene.vertical = constant(-scene.gravity - 20);
  const ObservedMotion motion = run(adapter, scene, dt);
  // 0.1 m up: out of reach of any contact with the ground that an engine may keep.
  const Momentum start = momentum(scene, motion, 100);
  double change = 0;
  double exchanged = 0;
  for (std::size_t n = 101; n < motion.history.size(); ++n) {
    const Momentum now = momentum(scene, motion, n);
    change = std::max(change, std::abs(now.sum - start.sum));
    exchanged = std::max(exchanged, std::abs(now.base - start.base));
  }
  if (!(exchanged > 100)) return {HUGE_VAL, 0, "the blocks never met"};
  return {change / exchanged, 0.002, "change of the sum over what the blocks exchange"};
}

/// Spanos et al. 2001, free rocking: the first ground impact by the event-driven solution is at 0.60565 s.
Judgement pair_meets_the_ground_in_time(const Adapter& adapter) {
  const double dt = short_step(adapter);
  const double error = std::abs(first_ground_impact(run(adapter, paper_scene(0.65), dt).history) - 0.60565);
  return {std::isnan(error) ? HUGE_VAL : error / dt, 2, "error, steps"};
}

}  // namespace rockstack
