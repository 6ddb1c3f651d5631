#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "analytic/solve.hpp"
#include "analytic/unilateral/solve_contacts.hpp"
#include "tests/analytic/extremes/laws.hpp"
#include "tests/analytic/extremes/scenes.hpp"
#include "tests/analytic/unilateral/scenes.hpp"
#include "tests/stride.hpp"

namespace rockstack {
namespace {

using testing::slippery_extreme_scene;

/// Up to three blocks whose masses are within a factor of a thousand, and their heights within ten.
bool is_moderate(const Scene& scene) {
  const auto within = [&](double factor, auto value) {
    const auto less = [&](const Block& a, const Block& b) { return value(a) < value(b); };
    const auto [least, most] = std::minmax_element(scene.blocks.begin(), scene.blocks.end(), less);
    return value(*most) <= factor * value(*least);
  };
  return scene.blocks.size() <= 3 && within(1e3, [](const Block& block) { return block.mass; }) &&
         within(10, [](const Block& block) { return block.half_height; });
}

// More, and more extreme ones, by the program `extremes`.
TEST(SlipperyExtremes, NoMotionGainsEnergyOrSinksOrHoldsNumbersThatAreNone) {
  constexpr double few = 1000;
  int solved = 0;
  for (std::uint64_t seed = 0; seed < 80; seed += testing::stride) {
    const Scene scene = slippery_extreme_scene(seed);
    if (!is_moderate(scene)) continue;
    const auto times = regular_times(scene.duration / 50, scene.duration);
    const testing::Breaches found =
        testing::contact_breaches(scene, solve_unilateral(scene, {.sample_times = times}));
    EXPECT_EQ(found.fault, "") << seed;
    EXPECT_LE(found.impact_gain, few) << seed;
    EXPECT_LE(found.flight_drift, few) << seed;
    ++solved;
  }
  EXPECT_GT(testing::stride * solved, 20);
}

// Masses of 1:10⁶ and sizes of 1:10⁶, of which double keeps too few digits, and a dynamic jam.
TEST(SlipperyExtremes, NeitherFewDigitsNorAJamMakeEnergy) {
  constexpr double few = 1000;
  for (const std::uint64_t seed : {130, 201, 463}) {
    const Scene scene = slippery_extreme_scene(seed);
    const testing::Breaches found = testing::contact_breaches(scene, solve_unilateral(scene));
    EXPECT_EQ(found.fault, "") << seed;
    EXPECT_LE(found.impact_gain, few) << seed;
    EXPECT_LE(found.flight_drift, few) << seed;
  }
}

// Decisions in chatter are ended by impacts, so that none looks further ahead than another. Which way a heavy
// block on ice then slides is rounding, which these durations make go the rarer way.
TEST(SlipperyExtremes, DecisionsThatAnImpactEndsMakeNoEnergy) {
  constexpr double few = 1000;
  Scene scene = slippery_extreme_scene(343);
  for (const int i : {7, 12}) {
    scene.duration = 0.0003 * (1 + i * 0.037);
    EXPECT_LE(testing::contact_breaches(scene, solve_unilateral(scene)).flight_drift, few) << i;
  }
}

// A joint that comes back to what it parted from has not parted again. One of a stack that rests on ice was
// taken back to a pivot that it had left, and turned into the block below.
TEST(SlipperyExtremes, AJointThatClosesAgainHasNotParted) {
  constexpr double few = 1000;
  Scene scene = slippery_extreme_scene(426);
  scene.duration = 0.0125;
  EXPECT_LE(testing::contact_breaches(scene, solve_unilateral(scene)).flight_drift, few);
}

// A block under one of 10ⁿ times its mass takes n digits from the forces between them, of 16 in double and of
// 19 in long double, and some two more by its shape.
TEST(SlipperyExtremes, MassesTooFarApartForAnyDigitsAreSaidToBe) {
  struct Case {
    double ratio;
    bool in_double, solved;
  };
  for (const Case& one : {Case{1, true, true}, Case{1e6, false, true}, Case{1e11, false, false}}) {
    Scene scene = testing::with_friction(
        testing::released({testing::block(1, 2), testing::block(1, 2)}, {0.1, 0.1}, 0.1), 0.5);
    for (double* value : {&scene.blocks[1].mass, &scene.blocks[1].inertia}) *value *= one.ratio;
    EXPECT_EQ(double_does(scene), one.in_double) << one.ratio;
    if (one.solved)
      EXPECT_NO_THROW(solve_unilateral(scene));
    else
      EXPECT_THROW(solve_unilateral(scene), std::domain_error);
  }
}

// Four times the lengths at the same gravity take twice the time; both factors round nothing.
TEST(SlipperyExtremes, ALargerStackDoesTheSameMoreSlowly) {
  for (std::uint64_t seed = 0; seed < 25; seed += testing::stride) {
    const Scene scene = slippery_extreme_scene(seed);
    if (!is_moderate(scene)) continue;
    Scene large = scene;
    large.duration *= 2;
    for (Block& block : large.blocks) {
      block.half_width *= 4;
      block.half_height *= 4;
      block.inertia *= 16;
    }
    for (double& velocity : large.initial.velocities) velocity /= 2;
    for (GroundMotion* motion : {&large.horizontal, &large.vertical}) {
      motion->interval *= 2;
      if (!motion->pulse) continue;
      motion->pulse->period *= 2;
      motion->pulse->start *= 2;
    }
    const History one = solve_unilateral(scene);
    const History other = solve_unilateral(large);
    ASSERT_EQ(one.events.size(), other.events.size()) << seed;
    for (std::size_t i = 0; i < one.events.size(); ++i)
      EXPECT_EQ(2 * one.events[i].time, other.events[i].time) << seed;
  }
}

}  // namespace
}  // namespace rockstack
