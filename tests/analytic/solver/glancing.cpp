#include <gtest/gtest.h>

#include "analytic/guards.hpp"
#include "analytic/solve.hpp"
#include "tests/analytic/solver/stacks.hpp"

namespace rockstack {
namespace {

/// The first event of a step in which a single block's angle is (s − a)(s − b) × 0.01 rad.
Next<double> first_in_step(double a, double b) {
  Flow<double> flow{};
  flow.length = 0.01;
  flow.start = {closed_pattern(1), Vector<double>{{0.01 * a * b}}, Vector<double>{{0.0}}};
  flow.start.pattern[0] = Contact::right;
  flow.angles[0] = {0.01 * a * b, -0.01 * (a + b), 0.01};
  std::array<double, max_blocks> toppling{};
  toppling.fill(1);
  return first_event(flow, toppling);
}

TEST(Glancing, AGapThatDipsBelowZeroWithinOneStepIsAnImpact) {
  for (const double depth : {1e-1, 1e-3, 1e-6}) {
    const Next<double> next = first_in_step(0.4 - depth, 0.4 + depth);
    EXPECT_TRUE(next.closing.test(0)) << depth;
    EXPECT_NEAR(next.s, 0.4 - depth, 1e-15 / depth);  // rounding over the slope
  }
}

TEST(Glancing, AGapThatTouchesZeroOrStaysAboveIsNone) {
  EXPECT_FALSE(first_in_step(0.5, 0.5).happens());
  EXPECT_FALSE(first_in_step(1.5, 2.0).happens());
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
