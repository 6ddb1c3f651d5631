#include <gtest/gtest.h>

#include "tests/analytic/solver/stacks.hpp"

namespace rockstack {
namespace {

constexpr double gravity = 9.81;

Scene at_rest(std::vector<Block> blocks, double duration) {
  const std::size_t size = blocks.size();
  return testing::released(std::move(blocks), std::vector<double>(size, 0), duration);
}

GroundMotion ramp(double rate, double end) {
  return {end, {0, rate * end}, {}, {}};
}

TEST(GroundMotion, ABlockOpensWhenTheGroundCrossesItsSlenderness) {
  Scene scene = at_rest({testing::block(0.5, 2)}, 1);
  for (const double rate : {-7.0, 7.0}) {
    scene.horizontal = ramp(rate, 1);
    const History history = solve(scene);
    ASSERT_FALSE(history.events.empty());
    EXPECT_EQ(history.events[0].kind, EventKind::opening);
    EXPECT_NEAR(history.events[0].time, gravity * 0.25 / 7, 1e-14);
    EXPECT_EQ(history.events[0].to[0], rate > 0 ? Contact::left : Contact::right);
  }
}

// rate t = (g + rise t) b/h.
TEST(GroundMotion, VerticalMotionShiftsTheOpening) {
  Scene scene = at_rest({testing::block(0.5, 2)}, 1);
  scene.horizontal = ramp(7, 1);
  scene.vertical = ramp(3, 0.9);
  EXPECT_NEAR(solve(scene).events.at(0).time, gravity * 0.25 / (7 - 3 * 0.25), 1e-14);
}

TEST(GroundMotion, BelowTheThresholdNothingHappens) {
  Scene scene = at_rest({testing::block(1, 1), testing::block(0.5, 2)}, 2);
  testing::Draw draw(51);
  scene.horizontal.interval = 0.01;
  // The lesser of both ratios is the top's 1/4; the stack's own is that of its common centre, about 0.29.
  for (int i = 0; i < 150; ++i) scene.horizontal.samples.push_back(draw.between(-0.249, 0.249) * gravity);
  const History history = solve(scene, {.sample_times = regular_times(0.1, 2)});
  EXPECT_TRUE(history.events.empty());
  for (const double angle : history.angles) EXPECT_EQ(angle, 0);
}

// Spanos et al. 2001, Eqs. (1) and (2): the whole stack opens at the ratio of its common centre; Eqs. (4),
// (5): the top alone at its own.
TEST(GroundMotion, TwoBlocksOpenWhereTheirRatioIsLeast) {
  Scene scene = at_rest({testing::block(1, 1), testing::block(0.5, 2)}, 1);
  scene.horizontal = ramp(8, 1);
  const Event top = solve(scene).events.at(0);
  EXPECT_EQ(name(top.to), "4b");
  EXPECT_NEAR(top.time, gravity * 0.25 / 8, 1e-14);
  scene.blocks = {testing::block(0.5, 2), testing::block(0.5, 1)};
  const Event whole = solve(scene).events.at(0);
  EXPECT_EQ(name(whole.to), "3b");
  EXPECT_NEAR(whole.time, gravity * 0.25 / 1.5 / 8, 1e-14);  // common centre at 1.5 m
}

TEST(GroundMotion, AJumpAtTheStartOpensAtOnce) {
  Scene scene = at_rest({testing::block(0.5, 2)}, 0.5);
  scene.horizontal = {0.1, {-4, -4, -4}, {}, {}};
  const Event event = solve(scene).events.at(0);
  EXPECT_EQ(event.time, 0);
  EXPECT_EQ(event.kind, EventKind::opening);
  EXPECT_EQ(event.to[0], Contact::right);
}

// West, Ishiyama: a constant a ≤ g tan α from t = 0 to the end topples no block; above it the slender block
// opens.
TEST(GroundMotion, ASteepRiseOpensWithinIt) {
  Scene scene = at_rest({testing::block(0.5, 2)}, 0.5);
  scene.horizontal = {1e-6, std::vector<double>(4, 0), {}, {}};
  scene.horizontal.samples = {0, 0, 5, 5};
  const Event event = solve(scene).events.at(0);
  EXPECT_NEAR(event.time, 1e-6 + 1e-6 * gravity * 0.25 / 5, 1e-20);
}

TEST(GroundMotion, ComponentsOfDifferentIntervalsAreFollowedExactly) {
  Scene scene = at_rest({testing::block(0.5, 2)}, 1);
  scene.horizontal = {0.3, {0, 1.2, 2.4, 3.6}, {}, {}};  // 4 t
  scene.vertical = {0.07, {}, {}, {}};
  for (int i = 0; i < 12; ++i) scene.vertical.samples.push_back(-0.35 * i);  // −5 t, to 0.77 s
  EXPECT_NEAR(solve(scene).events.at(0).time, gravity * 0.25 / (4 + 5 * 0.25), 1e-14);
}

TEST(GroundMotion, FinerSamplesOfTheSameLinesGiveTheSameMotion) {
  Scene scene = testing::released({testing::block(0.5, 2)}, {0.1}, 0.6);
  scene.horizontal = {0.25, {1, -3, 2}, {}, {}};
  const SolveOptions options{.sample_times = regular_times(0.037, 0.6)};
  const History coarse = solve(scene, options);
  scene.horizontal = {0.0625, {1, 0, -1, -2, -3, -1.75, -0.5, 0.75, 2}, {}, {}};
  const History fine = solve(scene, options);
  ASSERT_EQ(coarse.size(), fine.size());
  // The rk4 error of steps of 2e-4 s on different grids, h⁴ = 2e-15, and rounding of 3000 steps.
  for (std::size_t i = 0; i < coarse.size(); ++i) {
    EXPECT_NEAR(coarse.angles[i], fine.angles[i], 1e-12) << coarse.times[i];
  }
}

TEST(GroundMotion, AStrongPushTopplesAndEndsTheHistory) {
  Scene scene = at_rest({testing::block(0.5, 2)}, 20);
  scene.horizontal = {10, {-4, -4, -4}, {}, {}};
  const History history = solve(scene, {.sample_times = regular_times(0.05, 20)});
  const Event& last = history.events.back();
  EXPECT_EQ(last.kind, EventKind::topple);
  EXPECT_EQ(last.interface, 1);
  EXPECT_NEAR(last.angles[0], toppling_angle(scene, 0), 1e-14);
  EXPECT_LT(history.times.back(), last.time);
  EXPECT_GT(history.times.back(), last.time - 0.0501);
}

TEST(GroundMotion, AToppleNamesTheBlockThatTopples) {
  Scene scene = at_rest({testing::block(4, 1), testing::block(0.3, 2)}, 20);
  scene.horizontal = {10, {-4, -4, -4}, {}, {}};
  const Event last = solve(scene).events.back();
  EXPECT_EQ(last.kind, EventKind::topple);
  EXPECT_EQ(last.interface, 2);
}

}  // namespace
}  // namespace rockstack
