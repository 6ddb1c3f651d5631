#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/analytic/unilateral/scenes.hpp"
#include "tests/analytic/unilateral/two_laws.hpp"
#include "tests/stride.hpp"

namespace rockstack {
namespace {

// Ten thousand by the program without_slip_scenes.
TEST(UnilateralWithoutSlip, MotionsAreThoseOfLawConsistentUntilThatOneReportsWhyNot) {
  testing::LawTally tally;
  for (std::uint64_t seed = 0; seed < 300; seed += testing::stride)
    EXPECT_EQ(tally.add(seed, testing::gripping_scene(seed)), "");
  const auto count = [&](testing::Parting parting) {
    return tally.scenes[static_cast<std::size_t>(parting)];
  };
  EXPECT_GT(testing::stride * count(testing::Parting::none), 100U);
  EXPECT_GT(testing::stride * count(testing::Parting::friction), 50U);
  EXPECT_GT(testing::stride * tally.compared, 4000U);
  EXPECT_LT(tally.beyond, tally.compared / 100);
}

// Ground is inclined, and centres of mass are off the middle of blocks.
TEST(UnilateralWithoutSlip, SoTheyAreWhereWeightIsAskew) {
  testing::LawTally tally;
  for (std::uint64_t seed = 0; seed < 150; seed += testing::stride) {
    Scene scene = testing::gripping_scene(seed);
    testing::Draw draw(seed + 70000);
    scene.inclination = draw.between(-0.05, 0.05);
    for (Block& block : scene.blocks) {
      block.offset_x = draw.between(-0.3, 0.3) * block.half_width;
      block.offset_y = draw.between(-0.5, 0.5) * block.half_height;
    }
    EXPECT_EQ(tally.add(seed, scene), "");
  }
  EXPECT_GT(testing::stride * tally.compared, 2000U);
}

/// Whether all that the pivots of a motion ask for is had with this friction.
bool stays_within(const std::vector<Demand>& demands, double friction) {
  return std::all_of(demands.begin(), demands.end(), [&](const Demand& demand) {
    return demand.least_normal > 0 && demand.friction < friction;
  });
}

void expect_same_demands(const std::vector<Demand>& one, const std::vector<Demand>& other,
                         std::uint64_t seed) {
  for (std::size_t k = 0; k < one.size(); ++k) {
    // Infinite where an interface bears no impact.
    if (one[k].least_normal != other[k].least_normal) {
      EXPECT_NEAR(one[k].least_normal, other[k].least_normal, 1e-8 * one[k].least_normal) << seed;
    }
    EXPECT_NEAR(one[k].friction, other[k].friction, 1e-8) << seed;
    EXPECT_EQ(other[k].first_pull_time, std::numeric_limits<double>::infinity());
    EXPECT_EQ(other[k].first_slip_time, std::numeric_limits<double>::infinity());
  }
}

// What acts, and how far blocks lean, is then what the pivots' solver tells of its own motion.
TEST(UnilateralWithoutSlip, DemandsAndPeaksAreThoseOfLawConsistent) {
  constexpr double friction = 1.5;
  int scenes = 0;
  for (std::uint64_t seed = 0; seed < 300; seed += testing::stride) {
    Scene scene = testing::seeded_scene(seed);
    scene.law = Law::consistent;
    const History one = solve(scene, {.validity = true, .peaks = true});
    if (!stays_within(one.forces, friction) || !stays_within(one.impulses, friction)) continue;
    const History other =
        solve_unilateral(testing::with_friction(scene, friction), {.validity = true, .peaks = true});
    // Pivots know no ground but the lowest block's.
    if (!other.events.empty() && other.events.back().kind == EventKind::strike) continue;
    ++scenes;
    expect_same_demands(one.forces, other.forces, seed);
    expect_same_demands(one.impulses, other.impulses, seed);
    for (std::size_t k = 0; k < one.peaks.size(); ++k) {
      EXPECT_NEAR(one.peaks[k], other.peaks[k], 1e-8) << seed;
      // A face of twice the half-width turns by the difference of two such angles.
      EXPECT_NEAR(one.uplifts[k], other.uplifts[k], 4e-8 * scene.blocks[k].half_width) << seed;
    }
  }
  EXPECT_GT(testing::stride * scenes, 20);
}

// Shenton 1996: a block of height to width r = 2 that starts to rock on ground with 1 g needs a friction of
// [A(4 + r²) + 3r]/[1 + 4r² + 3Ar] = 14/23. Had it to stay as it was when the ground jumps, it would need 1.
TEST(UnilateralWithoutSlip, WhatAJumpOfTheGroundEndsAsksForNothing) {
  Scene scene = testing::with_friction(testing::single(0.5, 1, 0.1 + 1e-7), 0.7);
  scene.horizontal = testing::pulse_of(PulseShape::rectangle, scene.gravity, 0.1, 0.1);
  for (const Law law : {Law::consistent, Law::unilateral}) {
    scene.law = law;
    const History history = solve(scene, {.validity = true});
    ASSERT_EQ(history.events.size(), 1U);
    EXPECT_EQ(history.events.front().kind, EventKind::opening);
    EXPECT_NEAR(history.forces.front().friction, 14.0 / 23.0, 1e-10);
  }
}

}  // namespace
}  // namespace rockstack
