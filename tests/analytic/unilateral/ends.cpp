// Where a motion ends: beside a face, on the ground, or on a block that is not next in the stack.

#include <gtest/gtest.h>

#include <cmath>

#include "analytic/solve.hpp"
#include "tests/analytic/unilateral/scenes.hpp"

namespace rockstack {
namespace {

using testing::released;
using testing::round_off;
using testing::with_friction;

/// A plank of half length 1.5 m on a brick of half width 0.25 m and height 0.3 m, 0.4 m off its middle: it
/// tips over the brick's edge.
constexpr double brick = 0.25, thickness = 0.3, plank = 1.5, off = 0.4;

Scene tipping(const std::vector<Block>& below) {
  std::vector<Block> blocks = below;
  blocks.push_back(testing::block(2 * brick, thickness));
  blocks.push_back(testing::block(2 * plank, 0.1));
  Scene scene = with_friction(released(blocks, std::vector<double>(blocks.size(), 0), 2), 5);
  scene.initial.offsets.assign(blocks.size(), 0);
  scene.initial.offsets.back() = off;
  return scene;
}

// Its lower face goes through the brick's edge, so that its end is down where sin θ is the brick's height
// over what it overhangs by. With as much friction nothing slips until then.
TEST(Ends, APlankThatTipsStrikesWhatIsBesideTheBrick) {
  for (const std::vector<Block>& below : {std::vector<Block>{}, {testing::block(8, 0.5)}}) {
    const Scene scene = tipping(below);
    const History history = solve_unilateral(scene);
    ASSERT_FALSE(history.events.empty());
    const Event& last = history.events.back();
    EXPECT_EQ(last.kind, EventKind::strike);
    EXPECT_EQ(last.interface, static_cast<int>(scene.blocks.size()));
    EXPECT_NEAR(last.angles[scene.blocks.size() - 1], std::asin(thickness / (off + plank - brick)),
                100 * round_off);
  }
}

TEST(Ends, WhatStartsInTheGroundEndsAtOnce) {
  Scene scene = tipping({});
  scene.initial = {{0, 0.3}, {0, 0}};
  const History history = solve_unilateral(scene);
  ASSERT_EQ(history.events.size(), 1U);
  EXPECT_EQ(history.events[0].kind, EventKind::strike);
  EXPECT_EQ(history.events[0].time, 0);
}

/// A block that starts 5 m above another and moves off it at a speed; both without turning.
Scene flying(double speed) {
  Scene scene = with_friction(released({testing::block(1, 0.2), testing::block(1, 0.2)}, {0, 0}, 1.5), 0.5);
  scene.initial.gaps = {0, 5};
  scene.initial.slip_velocities = {0, speed};
  return scene;
}

// It is beside the block below after 1/speed, and falls off where it comes down to its face.
TEST(Ends, ABlockFallsOffWhereItIsNoLongerAbove) {
  for (const Law law : {Law::unilateral, Law::compliant}) {
    for (const double speed : {-2.0, 2.0}) {
      Scene scene = flying(speed);
      scene.law = law;
      if (law == Law::compliant) scene.springs.stiffness = {INFINITY, 1e8}, scene.initial.preloaded = false;
      const History history = solve_unilateral(scene);
      ASSERT_FALSE(history.events.empty());
      EXPECT_EQ(history.events.back().kind, EventKind::fall);
      EXPECT_EQ(history.events.back().interface, 2);
      EXPECT_NEAR(history.events.back().time, std::sqrt(2 * 5 / scene.gravity), 10 * round_off);
    }
  }
}

// The ground carries the lower block out by A T²/2π², 1.2 m, and back after T: meanwhile nothing is under the
// upper one, which lands where it started from.
TEST(Ends, ABlockLandsOnWhatHasComeBackUnderIt) {
  Scene scene = flying(0);
  scene.friction = {5, 5};
  scene.horizontal.pulse = Pulse{PulseShape::cosine, 23.7, 1, 0};
  const History history = solve_unilateral(scene);
  ASSERT_FALSE(history.events.empty());
  EXPECT_EQ(history.events[0].kind, EventKind::impact);
  EXPECT_EQ(name(history.events[0].to), "rest");
  EXPECT_NEAR(history.events[0].time, std::sqrt(2 * 5 / scene.gravity), 10 * round_off);
}

}  // namespace
}  // namespace rockstack
