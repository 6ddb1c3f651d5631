// Blocks that start above what is below them, or off its middle.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "analytic/solve.hpp"
#include "tests/analytic/unilateral/scenes.hpp"

namespace rockstack {
namespace {

using testing::released;
using testing::round_off;
using testing::single;
using testing::with_friction;

TEST(Starts, ADroppedBlockFallsLandsFlatAndRests) {
  Scene scene = with_friction(single(0.5, 0.5, 1), 0.5);
  const double height = 0.3, g = scene.gravity;
  scene.initial.gaps = {height};
  const History history = solve_unilateral(scene, {.sample_times = {0, 0.1, 0.2}});
  ASSERT_EQ(history.events.size(), 1U);
  EXPECT_EQ(history.events[0].kind, EventKind::impact);
  EXPECT_EQ(name(history.events[0].to), "C");
  EXPECT_NEAR(history.events[0].time, std::sqrt(2 * height / g), round_off);
  EXPECT_NEAR(bodies_before(history.events[0]).velocity[0].y, -std::sqrt(2 * g * height), 10 * round_off);
  for (const auto& sample : samples_of(history))
    EXPECT_NEAR(sample.gaps[0], height - g * sample.time * sample.time / 2, round_off);
}

// It leans to the right by φ and lands on its right corner, which sticks: ω = −m v d/(I + m R²), with d the
// lever of its centre about that corner.
TEST(Starts, ATiltedBlockLandsOnItsCorner) {
  Scene scene = with_friction(single(0.5, 0.8, 1), 10);
  const double angle = 0.2, height = 0.3, g = scene.gravity;
  scene.initial = {{angle}, {0}};
  scene.initial.gaps = {height};
  const History history = solve_unilateral(scene);
  ASSERT_FALSE(history.events.empty());
  const Event& landing = history.events.front();
  EXPECT_EQ(name(landing.from), "-");
  EXPECT_EQ(name(landing.to), "R");
  EXPECT_NEAR(landing.time, std::sqrt(2 * height / g), round_off);
  const Block& block = scene.blocks[0];
  const double lever = 0.5 * std::cos(angle) - 0.8 * std::sin(angle);
  const double about_corner = block.inertia + block.mass * (0.5 * 0.5 + 0.8 * 0.8);
  EXPECT_NEAR(landing.after[0], -block.mass * std::sqrt(2 * g * height) * lever / about_corner,
              10 * round_off);
}

TEST(Starts, AThrownBlockFliesAndTurns) {
  Scene scene = with_friction(single(0.5, 0.5, 0.5), 0.5);
  const double g = scene.gravity, along = 1.5, up = 4, turning = 0.7;
  scene.initial = {{0}, {turning}};
  scene.initial.gaps = {1};
  scene.initial.slip_velocities = {along};
  scene.initial.gap_velocities = {up};
  const History history = solve_unilateral(scene, {.sample_times = {0.1, 0.3, 0.5}});
  EXPECT_TRUE(history.events.empty());
  for (const auto& sample : samples_of(history)) {
    const double t = sample.time;
    EXPECT_NEAR(sample.bodies.pose[0].x, along * t, round_off);
    EXPECT_NEAR(sample.bodies.pose[0].y, 1.5 + up * t - g * t * t / 2, 10 * round_off);
    EXPECT_NEAR(sample.bodies.pose[0].angle, turning * t, round_off);
  }
}

// What lies on a block that falls stays on it, and bears nothing until both land.
TEST(Starts, AStackThatIsDroppedFallsAsOne) {
  Scene scene = with_friction(released({testing::block(1, 1), testing::block(0.6, 0.4)}, {0, 0}, 1), 0.5);
  scene.initial.gaps = {0.2, 0};
  const History history = solve_unilateral(scene, {.sample_times = {0.1}});
  ASSERT_EQ(history.events.size(), 1U);
  EXPECT_EQ(name(history.events[0].to), "rest");
  EXPECT_NEAR(history.events[0].time, std::sqrt(0.4 / scene.gravity), round_off);
  EXPECT_EQ(history.gaps[1], 0);
}

// Equal blocks of length L overhang by L/(2j), j from the top, in balance (the tower of Lire); by a little
// more they fall, by a little less they stand.
TEST(Starts, ATowerStandsUpToTheHarmonicOverhang) {
  for (int size = 2; size <= 6; ++size) {
    for (const double share : {-1 - 1e-10, -1 + 1e-10, 1 - 1e-10, 1 + 1e-10}) {
      const auto blocks = static_cast<std::size_t>(size);
      Scene scene =
          released(std::vector<Block>(blocks, testing::block(1, 0.2)), std::vector<double>(blocks, 0), 0.1);
      scene = with_friction(scene, 0.5);
      scene.initial.offsets.assign(blocks, 0);
      for (int j = 1; j < size; ++j)
        scene.initial.offsets[blocks - static_cast<std::size_t>(j)] = share / (2 * j);
      EXPECT_EQ(solve_unilateral(scene).events.empty(), std::abs(share) < 1) << size << " at " << share;
    }
  }
}

// A block of mass m lies off the middle of a slab M that slides without friction on the ground at v: friction
// μ m g between them ends the slip after v²/(2 μ g (1 + m/M)).
TEST(Starts, ATableclothThatIsPulledLeavesWhatLiesOnIt) {
  const Block slab = testing::block(4, 0.1), cup = testing::block(0.2, 0.2);
  Scene scene = released({slab, cup}, {0, 0}, 2);
  scene.law = Law::unilateral;
  const double friction = 0.3, speed = 2;
  scene.friction = {0, friction};
  scene.initial.offsets = {0, 0.5};
  scene.initial.slip_velocities = {speed, -speed};
  const History history = solve_unilateral(scene);
  const double slipped = speed * speed / (2 * friction * scene.gravity * (1 + cup.mass / slab.mass));
  ASSERT_FALSE(history.events.empty());
  EXPECT_EQ(history.events.back().kind, EventKind::stick);
  EXPECT_NEAR(history.slips[1], 0.5 - slipped, round_off);
}

// Without dashpots a spring gives back what fell on it: the block is back at its height after two falls t₁
// and the contact between them, (π + 2 atan(g/(v ω)))/ω, ω² = 2k/m.
TEST(Starts, ABlockThatFallsOnSpringsComesBackToItsHeight) {
  Scene scene = single(0.5, 0.5, 2);
  scene.law = Law::compliant;
  const double height = 0.2, g = scene.gravity, stiffness = 1e6;
  scene.springs.stiffness = {stiffness};
  scene.initial.gaps = {height};
  scene.initial.preloaded = false;
  const double fall = std::sqrt(2 * height / g), rate = std::sqrt(2 * stiffness / scene.blocks[0].mass);
  const double contact = (std::numbers::pi + 2 * std::atan(1 / (fall * rate))) / rate;
  const double back = 2 * fall + contact;
  const History history = solve(scene, {.sample_times = {0, back}});
  EXPECT_NEAR(history.gaps[0], height, round_off);
  EXPECT_NEAR(history.gaps[1], height, 1e-11);
  EXPECT_NEAR(history.centre_velocities[3], 0, 1e-10);
}

}  // namespace
}  // namespace rockstack
