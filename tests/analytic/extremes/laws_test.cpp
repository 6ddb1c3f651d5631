#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "analytic/solve.hpp"
#include "analytic/solver/solver.hpp"
#include "analytic/solver/to_double.hpp"
#include "comparisons/measures/statistics/samples.hpp"
#include "tests/analytic/extremes/laws.hpp"
#include "tests/analytic/extremes/scenes.hpp"
#include "tests/analytic/reference/agreement.hpp"
#include "tests/analytic/solver/stacks.hpp"

namespace rockstack {
namespace {

using testing::extreme_scene;

// A hundred thousand by the program `extremes`. A velocity is what a dozen operations a block leave of it: at
// twenty blocks, some hundred roundings. Measured: at most 41 in an impact.
TEST(Extremes, NoMotionGainsEnergyOrHoldsNumbersThatAreNone) {
  constexpr double few = 1000;
  int solved = 0;
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    const Scene scene = extreme_scene(seed);
    if (scene.blocks.size() > 5) continue;
    try {
      const auto times = regular_times(scene.duration / 50, scene.duration);
      const testing::Breaches found = testing::breaches(scene, solve(scene, {.sample_times = times}));
      EXPECT_EQ(found.fault, "") << seed;
      EXPECT_LE(found.impact_gain, few) << seed;
      EXPECT_LE(found.flight_drift, few) << seed;
      ++solved;
    } catch (const std::exception&) {
      // The scene leaves the model or the numbers, and the text says where.
    }
  }
  EXPECT_GT(solved, 80);
}

// An opening within 1e-16 of a step's start would be taken back, and found again: the block topples after it.
TEST(Extremes, AnOpeningWithinRoundingOfAStepsStartIsNotTakenBackForEver) {
  EXPECT_EQ(solve(extreme_scene(2774)).events.size(), 13U);
}

// At its opening an interface's margin and, once it is open, its acceleration are zero to rounding: of forces
// on blocks whose masses differ by a million.
TEST(Extremes, AnOpeningWhoseAccelerationIsRoundingIsNoLiftingOff) {
  EXPECT_EQ(solve(extreme_scene(645)).events.size(), 6U);
  EXPECT_EQ(solve(extreme_scene(8461)).events.back().kind, EventKind::topple);
}

// Ten million times lighter than what it stands on, a block rebounds all the same: four impacts of its
// chatter have impulses below a rounding of the stack's momentum.
TEST(Extremes, ALightBlockChattersToItsEndOnHeavyOnes) {
  const Scene scene = extreme_scene(690);
  const History history = solve(scene);
  const auto agreement = testing::compare(history, testing::reference(scene));
  EXPECT_FALSE(agreement.parts.has_value());
  EXPECT_EQ(history.events.size(), 110U);
}

// Twenty equal blocks, one of which hangs over: one at a time, 8202 changes of a pattern would be needed.
TEST(Extremes, APatternOfTwentyInterfacesIsFound) {
  Scene scene = extreme_scene(6380);
  scene.duration = 1e-3;
  EXPECT_FALSE(solve(scene).events.empty());
}

Scene small_below_large(double ratio) {
  return testing::released({testing::block(ratio, 2 * ratio), testing::block(1, 2)}, {0.1, 0.15}, 0.5);
}

// Ten thousand times smaller, a block's share of the mass matrix is below what double keeps nine digits of.
// The share is about 1e-8 here, so long double leaves 2⁻⁶⁴/1e-8 ≈ 5e-12.
TEST(Extremes, SizesTooFarApartForDoubleAreSolvedInLongDouble) {
  const Scene scene = small_below_large(1e-4);
  EXPECT_THROW((Solver<double, 2>(scene, {}).run()), IllConditioned);
  const auto agreement = testing::compare(solve(scene), testing::reference(scene));
  ASSERT_GE(agreement.events.size(), 5U);
  for (std::size_t i = 0; i < 5; ++i) EXPECT_LT(agreement.events[i].state, 1e-11);
}

TEST(Extremes, SizesTooFarApartForLongDoubleAreSaidToBe) {
  EXPECT_THROW(solve(small_below_large(1e-6)), IllConditioned);
}

// More than ten thousand events within a thousandth of √(H/g), and then the column topples.
TEST(Extremes, ChatterInsideChatterComesToAnEnd) {
  const History history = solve(extreme_scene(4995));
  EXPECT_GT(history.events.size(), 10'000U);
  EXPECT_EQ(history.events.back().kind, EventKind::topple);
}

/// The time to which a number of steps brings a scene, s.
double reached(const Scene& scene, int steps) {
  const SolveOptions options;
  Solver<double> solver(scene, options);
  solver.start();
  while (!solver.finished() && steps-- > 0) solver.advance();
  return solver.time();
}

// At the instant at which the ground falls as fast as blocks do, all reactions vanish together: rounding
// finds openings, takes them back, and finds others, with no time between them. Both scenes rest on a ground
// whose record passes −g there, and need 752 and 10134 steps for all of their motion.
TEST(Extremes, AStackWithoutWeightForAnInstantGetsOn) {
  const Scene rests = extreme_scene(33281);
  EXPECT_GT(peak(rests.vertical), rests.gravity);
  EXPECT_GE(reached(rests, 3000), rests.duration * (1 - 1e-12));
  const Scene topples = extreme_scene(80430);
  EXPECT_GT(peak(topples.vertical), topples.gravity);
  EXPECT_GT(reached(topples, 30000), 0.2);
}

// Heavy blocks on light ones that make way are in free fall, whatever the ground does: their reactions are
// a few roundings, which open and close interfaces at one instant.
TEST(Extremes, BlocksInFreeFallOnLightOnesGetOn) {
  Scene scene = extreme_scene(1567);
  scene.duration = 0.01;  // s, beyond the second such instant
  EXPECT_FALSE(solve(scene).events.empty());
}

// With reactions that pull elsewhere, changing one interface at a time may go in circles, and so may changing
// all of them.
TEST(Extremes, APatternIsFoundWherePivotingGoesInCircles) {
  EXPECT_FALSE(solve(extreme_scene(9644)).events.empty());
}

/// How far an event of a history is from that of the reference at most, in shares of the sizes so far.
double largest_deviation(const testing::Agreement& agreement) {
  double largest = 0;
  for (const testing::Deviation& deviation : agreement.events) largest = std::max(largest, deviation.state);
  return largest;
}

// Events of unequal blocks in double may be off by 10⁴ times and more what 16 roundings of the scene's own
// numbers make of them at 113 bits. So that is not the scene's doing, but that of roundings of operations:
// those of long double, 2⁻¹¹ of double's, bring it down by as much. One scene's roundings are luck, by a
// decade to either side; what holds is the median of scenes that differ in the sixth digit.
TEST(Extremes, WhatUnequalBlocksAddIsRoundingOfOperations) {
  const SolveOptions options{.resolution = std::numeric_limits<double>::epsilon()};
  for (const std::uint64_t seed : {121U, 922U}) {
    std::vector<double> by_double, by_long_double, by_input;
    for (int draw = 0; draw < 7; ++draw) {
      Scene scene = extreme_scene(seed);
      for (Block& block : scene.blocks) block.half_height *= 1 + 1e-6 * draw;
      const testing::QuadHistory expected = testing::reference(scene);
      const History history = solve(scene);
      const History longer = to_double(Solver<long double>(scene, options).run());
      by_double.push_back(largest_deviation(testing::compare(history, expected)));
      by_long_double.push_back(largest_deviation(testing::compare(longer, expected)));
      by_input.push_back(largest_deviation(testing::response_to_rounding(scene, expected, 16, 8)));
      EXPECT_LT(by_double.back(), 16 * by_input.back() * testing::weight_of_rounding(scene, history)) << seed;
    }
    EXPECT_GT(median(by_double), 1e4 * median(by_input)) << seed;
    EXPECT_LT(median(by_long_double), median(by_double) / 200) << seed;
  }
}

}  // namespace
}  // namespace rockstack
