#include <gtest/gtest.h>

#include "analytic/events/first_event.hpp"
#include "analytic/solve.hpp"
#include "tests/analytic/solver/stacks.hpp"

namespace rockstack {
namespace {

/// The first event of a step in which a single block's angle is (s − a)(s − b) × 0.01 rad.
FirstEvent<double> first_in_step(double a, double b) {
  DenseOutput<double> output{};
  output.length = 0.01;
  output.start = {closed_pattern(1), Vector<double>{{0.01 * a * b}}, Vector<double>{{0.0}}};
  output.start.pattern[0] = Contact::right;
  output.angles[0] = {0.01 * a * b, -0.01 * (a + b), 0.01};
  std::array<double, max_blocks> toppling{};
  toppling.fill(1);
  return first_event(output, angle_hulls(output), toppling);
}

// A depth d of the dip is 0.01 d² rad; rounding of coefficients up to 0.02 rad is 16 ε × 0.02 = 7e-17 rad, so
// that depths below 8e-8 are in doubt, whether the angle crosses or just misses.
TEST(Glancing, WhatRoundingDecidesIsReported) {
  for (const double depth : {0.0, 1e-9, 1e-8}) {
    const FirstEvent<double> event = first_in_step(0.4 - depth, 0.4 + depth);
    ASSERT_EQ(event.grazes.size(), 1U) << depth;
    EXPECT_EQ(event.grazes[0].kind, EventKind::impact);
    EXPECT_NEAR(event.grazes[0].time, 0.4, 1e-7);
  }
  for (const double depth : {1e-6, 1e-3, 0.1}) {
    EXPECT_TRUE(first_in_step(0.4 - depth, 0.4 + depth).grazes.empty()) << depth;
  }
  EXPECT_TRUE(first_in_step(1.5, 2.0).grazes.empty());
}

// Ground that pushes a block over stops it on its way back to upright; between the last speed that just
// misses and the next double, which hits, rounding decides.
TEST(Glancing, AHistoryTellsOfItsGrazes) {
  Scene scene = testing::released({testing::block(0.5, 2)}, {0.1}, 2);
  scene.horizontal = {2, {-4, -4}, {}, {}};
  const auto history = [&](double speed) {
    scene.initial.velocities = {-speed};
    return solve(scene);
  };
  const auto impacts = [&](double speed) { return history(speed).events.front().kind != EventKind::topple; };
  double misses = 0.1;  // the block topples in the end
  double hits = 2;
  ASSERT_FALSE(impacts(misses));
  ASSERT_TRUE(impacts(hits));
  for (double middle = 1; middle != misses && middle != hits; middle = (misses + hits) / 2)
    (impacts(middle) ? hits : misses) = middle;
  EXPECT_EQ(history(misses).grazes.size() + history(hits).grazes.size(), 2U);
  EXPECT_TRUE(history(misses * (1 - 1e-9)).grazes.empty());
  EXPECT_TRUE(history(hits * (1 + 1e-9)).grazes.empty());
}

// Without the impact the block would swing past upright and back, at about 0.07 and 0.14 s: a step of 0.2 s
// that holds both crossings sees the first one too.
TEST(Glancing, LargeStepsSeeTheEventsThatSmallStepsSee) {
  Scene scene = testing::released({testing::block(0.5, 2)}, {0.02}, 0.4);
  scene.initial.velocities = {-0.42};
  scene.horizontal = {0.2, {-8, -8, -8}, {}, {}};
  const History small = solve(scene);
  const History large = solve(scene, {.integrator = Integrator::rk4, .step = 0.2});
  ASSERT_FALSE(small.events.empty());
  EXPECT_EQ(small.events[0].kind, EventKind::impact);
  ASSERT_FALSE(large.events.empty());
  EXPECT_EQ(large.events[0].kind, EventKind::impact);
  EXPECT_NEAR(large.events[0].time, small.events[0].time, 1e-3);  // rk4 at 0.2 s
}

}  // namespace
}  // namespace rockstack
