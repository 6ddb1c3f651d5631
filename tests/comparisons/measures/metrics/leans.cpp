#include "comparisons/measures/metrics/leans.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "analytic/solve.hpp"
#include "comparisons/measures/metrics/motion_verdict.hpp"

namespace rockstack {
namespace {

/// So many cubes of a metre, which lean as one by an angle.
Scene cubes(std::size_t count, double angle) {
  Scene scene;
  scene.duration = 1;
  scene.blocks.assign(count, make_block(1, 1, 2500));
  scene.initial = {std::vector<double>(count, angle), std::vector<double>(count, 0.0)};
  return scene;
}

/// One sample of blocks with these angles.
History one_sample(std::vector<double> angles) {
  History history;
  history.blocks = static_cast<int>(angles.size());
  history.times = {0};
  history.angles = std::move(angles);
  return history;
}

History followed(const Scene& scene) {
  return solve(scene, {.sample_times = regular_times(1e-2, scene.duration), .peaks = true});
}

// A mass 0.1 m to the right of the middle: to the right the block balances at atan(0.2/1.5), to the left at
// atan(0.4/1.5).
TEST(Leans, ABlockLeansByTheBalanceOfTheSideThatItLeansTo) {
  for (const double angle : {0.125, -0.125}) {
    Scene scene;
    scene.duration = 1;
    scene.blocks = {make_block(0.6, 2.4, 2500)};
    scene.blocks[0].offset_x = 0.1;
    scene.blocks[0].offset_y = 0.3;
    scene.initial = {{angle}, {0}};
    const History history = solve(scene, {.sample_times = {0, 0.1}, .peaks = true});
    EXPECT_DOUBLE_EQ(largest_lean(scene, history).ratio, 0.125 / std::atan2(angle > 0 ? 0.2 : 0.4, 1.5));
  }
}

// Further to the left than to the right, but less so of what each side bears: the time is that of the right.
TEST(Leans, ALeanHasTheTimeOfItsSide) {
  Scene scene;
  scene.blocks = {make_block(0.6, 2.4, 2500)};
  scene.blocks[0].offset_x = 0.1;
  History history;
  history.blocks = 1;
  history.times = {0, 1, 2};
  history.angles = {0, -0.15, 0.14};
  const Lean lean = largest_lean(scene, history);
  EXPECT_DOUBLE_EQ(lean.ratio, 0.14 / std::atan2(0.2, 1.2));
  EXPECT_EQ(lean.time, 2);
}

// A column of three balances at atan(1/3), each of its cubes at atan(1).
TEST(Leans, AColumnThatLeansAsOneHasTheBalanceOfOneBlockOfItsHeight) {
  const double balance = std::atan(1.0 / 3);
  for (const double angle : {0.3 * balance, -0.3 * balance}) {
    const Scene scene = cubes(3, angle);
    const History history = one_sample(scene.initial.angles);
    const Lean common = largest_common_lean(scene, history);
    EXPECT_EQ(common.block, 0U);
    EXPECT_NEAR(common.ratio, 0.3, 1e-14);
    EXPECT_NEAR(largest_lean(scene, history).ratio, std::abs(angle) / std::atan(1.0), 1e-14);
  }
}

// As one body and as one block, of the same mass in the same place.
TEST(Leans, AnOffsetMassOfOneBlockIsThatOfTwo) {
  Scene two = cubes(2, 0.1);
  two.blocks[1].offset_x = 0.2;
  const History history = one_sample({0.1, 0.1});
  Scene one = cubes(1, 0.1);
  one.blocks[0] = make_block(1, 2, 2500);
  one.blocks[0].offset_x = 0.1;
  EXPECT_NEAR(largest_common_lean(two, history).ratio, 0.1 / balance_angle(one, 0, 1), 1e-14);
}

// The middle of a face that slipped by 0.3 m to the right is on the lower block's right corner 0.2 m on.
TEST(Leans, ASlippedBlockLeansOnTheEndOfWhatIsBelow) {
  Scene scene = cubes(2, 0);
  scene.law = Law::unilateral;
  History history = one_sample({0, 0});
  history.velocities = {0, 0.1};
  history.slips = {0, 0.3};
  const auto falls = [&](double angle) {
    history.angles = {0, angle};
    // About the corner (0.5, 1), the block's own centre is 0.2 m to the left of it and 0.5 m above, turned.
    const double x = -0.2 * std::cos(angle) + 0.5 * std::sin(angle);
    const double y = 0.2 * std::sin(angle) + 0.5 * std::cos(angle);
    history.centres = {0, 0.5, 0.5 + x, 1 + y};
    return falling_block(scene, history, 0);
  };
  EXPECT_FALSE(falls(std::atan(0.4) - 1e-9));
  ASSERT_TRUE(falls(std::atan(0.4) + 1e-9));
  EXPECT_EQ(falls(std::atan(0.4) + 1e-9)->block, 1U);
  EXPECT_FALSE(falls(std::atan(0.4) + 1e-9)->past_edge);
}

// Its middle is 0.05 m past the right corner of the lower block: upright it would not stand either.
TEST(Leans, ABlockThatHasSlidPastTheEdgeFallsHoweverLittleItLeans) {
  Scene scene = cubes(2, 0);
  scene.law = Law::unilateral;
  History history = one_sample({0, 1e-3});
  history.velocities = {0, 0.1};
  history.slips = {0, 0.55};
  history.gaps = {0, 0};
  history.centres = {0, 0.5, 0.55 + 0.5e-3, 1.5 - 0.05e-3};
  const auto falling = falling_block(scene, history, 0);
  ASSERT_TRUE(falling);
  EXPECT_EQ(falling->block, 1U);
  EXPECT_TRUE(falling->past_edge);
  const std::string verdict = motion_verdict(scene, history);
  EXPECT_EQ(verdict.find("block 2 has slid past the edge and falls at the end, 0 s"), 0U) << verdict;
  EXPECT_EQ(verdict.find("slenderness"), std::string::npos) << verdict;
}

TEST(Leans, WhatIsPastTheBalanceOfTheWholeDoesNotStand) {
  const double balance = std::atan(1.0 / 3);
  for (const Law law : {Law::consistent, Law::unilateral}) {
    Scene scene = cubes(3, 1.01 * balance);
    scene.law = law;
    const History history = followed(scene);
    ASSERT_EQ(history.size(), 101U) << "not toppled yet";
    EXPECT_FALSE(falling_block(scene, history, 0)) << "it does not move yet";
    ASSERT_TRUE(falling_block(scene, history, 100));
    EXPECT_EQ(falling_block(scene, history, 100)->block, 0U);
    EXPECT_EQ(motion_verdict(scene, history)
                  .find("blocks 1 to 3 lean past balance and on at the end, 1 s; blocks 1 to 3 together "),
              0U)
        << motion_verdict(scene, history);
    scene = cubes(3, 0.99 * balance);
    scene.law = law;
    EXPECT_EQ(
        motion_verdict(scene, followed(scene))
            .find(
                "stands so far, still rocking at the end, 1 s; blocks 1 to 3 together come to 0.99 of their balance at 0 s"),
        0U)
        << motion_verdict(scene, followed(scene));
  }
}

// On ground that falls to the right a block balances uphill further, and downhill less far.
TEST(Leans, BalanceIsByGravity) {
  Scene scene = cubes(1, 0);
  scene.inclination = 0.1;
  History history = one_sample({0});
  for (const int side : {1, -1}) {
    const double balance = std::atan(1.0) - side * scene.inclination;
    for (const double share : {0.999, 1.001}) {
      history.angles = {side * share * balance};
      history.velocities = {0.1 * side};
      const auto falling = falling_block(scene, history, 0);
      EXPECT_EQ(falling.has_value(), share > 1);
      if (falling) {
        EXPECT_FALSE(falling->past_edge) << "the slope is what makes it fall";
      }
    }
  }
}

// Upright on a slope it has come no way yet; where its mass is over the corner by gravity, all of it.
TEST(Leans, OnASlopeItIsHowFarGravityHasToTurnIt) {
  Scene scene = cubes(1, 0);
  scene.inclination = 0.1;
  History history = one_sample({0});
  for (const int side : {1, -1})
    for (const double share : {0.001, 0.5, 1.0}) {
      history.angles = {side * share * (std::atan(1.0) - side * scene.inclination)};
      const Lean lean = largest_common_lean(scene, history);
      EXPECT_EQ(lean.block, 0U);
      EXPECT_NEAR(lean.ratio, share, 1e-14);
    }
}

// Two blocks that stand 0.2 m off the middle of the first, upright, have come no way to their balance.
TEST(Leans, UprightBlocksThatHaveSlippedHaveNotLeaned) {
  Scene scene = cubes(3, 0);
  scene.law = Law::unilateral;
  const double angle = 1e-9;
  History history = one_sample({0, angle, angle});
  history.slips = {0, 0.2, 0.1};
  // Turned about the corner (0.5, 1), 0.3 m to the right of the second one's middle.
  const double up = 1 + 0.3 * angle;
  history.centres = {0, 0.5, 0.2 + 0.5 * angle, up + 0.5, 0.3 + 1.5 * angle, up + 1.5 - 0.1 * angle};
  // Their common centre is 0.25 m to the left of that corner and 1 m up.
  // A rounding of places is 1e-7 of the angle.
  EXPECT_NEAR(largest_common_lean(scene, history).ratio / (angle / std::atan(0.25)), 1, 1e-6);
}

}  // namespace
}  // namespace rockstack
