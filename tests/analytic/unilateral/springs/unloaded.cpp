#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/analytic/unilateral/scenes.hpp"
#include "tests/analytic/unilateral/springs/random_springs.hpp"

namespace rockstack {
namespace {

/// Blocks of random sizes, all at one angle, on springs or beds that bear nothing yet, from soft to stiff and
/// from no dashpots to critical ones.
Scene set_down(testing::Draw& draw, int size, double angle, bool beds) {
  Scene scene;
  scene.law = Law::compliant;
  scene.duration = 0.2;
  double mass = 0;
  for (int k = 0; k < size; ++k) {
    scene.blocks.push_back(make_block(draw.between(0.5, 1.5), draw.between(0.4, 2), 1000));
    mass += scene.blocks.back().mass;
    scene.friction.push_back(draw.between(0.1, 1));
  }
  const auto blocks = static_cast<std::size_t>(size);
  scene.initial = {std::vector<double>(blocks, angle), std::vector<double>(blocks, 0), {}, false};
  for (int k = 0; k < size; ++k) {
    const double stiffness = mass * std::pow(10, draw.between(2.3, 4));
    const double ratio = draw.below(4) == 0 ? 0 : std::pow(10, draw.between(-2, 0));
    const double length = beds ? interface_half_width(scene, k) : 1;
    (beds ? scene.springs.bed_stiffness : scene.springs.stiffness).push_back(stiffness / length);
    (beds ? scene.springs.bed_damping : scene.springs.damping)
        .push_back(2 * ratio * std::sqrt(stiffness * mass) / length);
  }
  scene.springs.tangential = draw.between(0.2, 1);
  return scene;
}

/// Heights of masses in a column, from where they are set down, and their velocities.
struct Column {
  std::vector<double> height, velocity;
};

/// Each mass on the one below by a spring and a dashpot, which may pull too.
Column rates(const Scene& scene, const Column& now) {
  const std::size_t size = scene.blocks.size();
  const CornerSprings& springs = scene.springs;
  Column result{now.velocity, std::vector<double>(size, -scene.gravity)};
  for (std::size_t k = 0; k < size; ++k) {
    const bool beds = springs.stiffness.empty();
    const double points = beds ? 2 * interface_half_width(scene, static_cast<int>(k)) : 2;
    const double depth = (k == 0 ? 0 : now.height[k - 1]) - now.height[k];
    const double rate = (k == 0 ? 0 : now.velocity[k - 1]) - now.velocity[k];
    const double force = points * ((beds ? springs.bed_stiffness : springs.stiffness)[k] * depth +
                                   (beds ? springs.bed_damping : springs.damping)[k] * rate);
    result.velocity[k] += force / scene.blocks[k].mass;
    if (k > 0) result.velocity[k - 1] -= force / scene.blocks[k - 1].mass;
  }
  return result;
}

Column after(const Column& start, const Column& rate, double time) {
  Column result = start;
  for (std::size_t k = 0; k < start.height.size(); ++k) {
    result.height[k] += time * rate.height[k];
    result.velocity[k] += time * rate.velocity[k];
  }
  return result;
}

/// By the classical Runge–Kutta method.
Column column_at(const Scene& scene, double time, int steps) {
  const std::size_t size = scene.blocks.size();
  Column now{std::vector<double>(size, 0), std::vector<double>(size, 0)};
  const double step = time / steps;
  for (int i = 0; i < steps; ++i) {
    const Column first = rates(scene, now);
    const Column second = rates(scene, after(now, first, step / 2));
    const Column third = rates(scene, after(now, second, step / 2));
    const Column fourth = rates(scene, after(now, third, step));
    now =
        after(after(after(after(now, first, step / 6), second, step / 3), third, step / 3), fourth, step / 6);
  }
  return now;
}

class Unloaded : public ::testing::TestWithParam<bool> {};
INSTANTIATE_TEST_SUITE_P(OnSpringsOrBeds, Unloaded, ::testing::Bool());

// Masses in a column, set down without load: each comes to press the one above by an order of time later, and
// nothing rubs or turns. Up to the first event all press, so that springs and dashpots are linear, and the
// method is of order four: half the step leaves a sixteenth of the error, which is a fifteenth of the
// difference of both. Roundings of 16,000 steps of 0.2 m add to that, and those of a stack of some metres.
TEST_P(Unloaded, UprightColumnsStayUpright) {
  testing::Draw draw(3);
  for (int i = 0; i < 30; ++i) {
    Scene scene = set_down(draw, 3, 0, GetParam());
    const History whole = solve_unilateral(scene);
    for (const Event& event : whole.events)
      EXPECT_TRUE(event.kind == EventKind::part || event.kind == EventKind::touch) << i << name(event.kind);
    if (!whole.events.empty()) scene.duration = whole.events.front().time;
    const History history = solve_unilateral(scene);
    const Column coarse = column_at(scene, scene.duration, 8000);
    const Column fine = column_at(scene, scene.duration, 16000);
    double below = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const Pose<> at = bodies_at_end(history).pose[k];
      const double height = below + scene.blocks[k].half_height + fine.height[k];
      EXPECT_NEAR(at.y, height, std::abs(fine.height[k] - coarse.height[k]) / 15 + 1e-12) << i << ' ' << k;
      EXPECT_NEAR(at.x, 0, 1e-15) << i;
      EXPECT_NEAR(at.angle, 0, 1e-15) << i;
      below += 2 * scene.blocks[k].half_height;
    }
  }
}

// Blocks that lean together set off in free fall, all alike: what presses, parts and slides between them is
// rounding at first.
TEST_P(Unloaded, StacksThatLeanTogetherSetOff) {
  testing::Draw draw(41);
  int events = 0;
  for (int i = 0; i < 60; ++i) {
    const Scene scene = set_down(draw, 2 + i % 2, draw.between(-0.15, 0.15), GetParam());
    const History history = solve_unilateral(scene, {.sample_times = {0, scene.duration}});
    const double change = testing::energy_with_losses(scene, samples_of(history).back()) -
                          testing::energy_with_losses(scene, samples_of(history).front());
    EXPECT_NEAR(change, 0, 1e-11 * testing::weight_times_height(scene)) << i;
    events += static_cast<int>(history.events.size());
  }
  EXPECT_GT(events, 200);
}

// A corner of the upper block that goes on to lie on a bed by 3·10⁻¹⁵ m while both fly: N and T are below any
// rounding, and its slider stuck and slipped every 1.6·10⁻¹¹ s.
TEST(UnloadedBed, ASliderWithoutForceDoesNotStickAndSlipWithoutEnd) {
  Scene scene;
  scene.law = Law::compliant;
  scene.duration = 0.4;
  scene.blocks = {make_block(1.77, 0.754, 1000), make_block(1.53, 4.49, 1000), make_block(1.53, 1.36, 1000)};
  scene.initial = {{-0.152, 0.0221, -0.2556}, {0, 0, 0}, {}, false};
  scene.friction = {0.195, 0.144, 0.441};
  scene.springs.bed_stiffness = {2.86e6, 3.98e6, 2.13e6};
  scene.springs.bed_damping = {8.54e3, 7.13e4, 2.66e4};
  const History history = solve_unilateral(scene);
  EXPECT_FALSE(ends_early(history));
  EXPECT_LT(history.events.size(), 100U);
}

}  // namespace
}  // namespace rockstack
