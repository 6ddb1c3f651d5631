#include <gtest/gtest.h>

#include <cmath>

#include "comparisons/measures/statistics/fragility.hpp"
#include "comparisons/measures/statistics/samples.hpp"

namespace rockstack {
namespace {

constexpr double middle = 3.0, beta = 0.4;
constexpr Fragility curve{middle, beta};

/// As many topple as the curve says, to the nearest run of twenty.
std::vector<RunGroup> counts(std::size_t times) {
  std::vector<Level> list;
  for (const double x : {1.5, 2.0, 2.5, 3.0, 3.5, 4.5})
    list.push_back(
        {x, 20 * times, times * static_cast<std::size_t>(std::lround(20 * probability(curve, x)))});
  return single_runs(list);
}

/// How many standard errors, if from very many groups, an interval from so many reaches.
double reach(std::size_t groups) {
  const auto count = static_cast<double>(groups);
  return reach_of_interval(groups - 1) * std::sqrt(count / (count - 1));
}

TEST(FragilityBounds, PassesOneHalfAtItsMedianBetweenItsBounds) {
  const FragilityBounds bounds(curve, counts(1));
  EXPECT_NEAR(probability(curve, middle), 0.5, 1e-15);
  for (double x = 0.5; x < 8; x += 0.5) {
    EXPECT_LE(bounds.at(x).lower, probability(curve, x)) << x;
    EXPECT_GE(bounds.at(x).upper, probability(curve, x)) << x;
  }
  EXPECT_LT(bounds.of_median().lower, middle);
  EXPECT_GT(bounds.of_median().upper, middle);
}

// Standard errors fall as one over the square root of the number of runs.
TEST(FragilityBounds, FourTimesTheRunsHalveTheBounds) {
  const FragilityBounds few(curve, counts(1)), many(curve, counts(4));
  EXPECT_NEAR(std::log(few.of_median().upper / middle) / reach(120),
              2 * std::log(many.of_median().upper / middle) / reach(480), 1e-12);
}

// Levels at equal distances on both sides of the median leave its error free of β: each bears the information
// n φ²/(p (1 − p) β²). At counts that are the curve's own, here four fifths and one, the squares of slopes
// add up to the same.
TEST(FragilityBounds, TwoLevelsAtEqualDistancesFixTheMedianAlone) {
  constexpr double away = 0.8416212335729143, p = 0.8;  // Φ(away)
  const std::size_t n = 50;
  const double apart = away * beta;
  const FragilityBounds bounds(
      curve, single_runs({{middle * std::exp(apart), n, 40}, {middle / std::exp(apart), n, 10}}));
  const double density = std::exp(-away * away / 2) / std::sqrt(2 * std::acos(-1.0));
  const double error = beta * std::sqrt(p * (1 - p) / (2.0 * n)) / density;
  EXPECT_NEAR(std::log(bounds.of_median().upper / middle), reach(2 * n) * error, 1e-12);
}

TEST(FragilityBounds, CountsOfOneLevelBoundNothing) {
  const FragilityBounds bounds(curve, single_runs({{middle, 20, 10}}));
  EXPECT_EQ(bounds.at(2 * middle).lower, 0);
  EXPECT_EQ(bounds.at(2 * middle).upper, 1);
}

/// Twenty motions that topple each at an intensity of its own, each run as often as that.
std::vector<RunGroup> motions(std::size_t times) {
  std::vector<RunGroup> groups;
  for (int m = 0; m < 20; ++m) {
    RunGroup group;
    for (const double x : {1.0, 2.0, 3.0, 4.0, 5.0, 6.0})
      group.push_back({x, times, x > 2 + 0.15 * m ? times : 0});
    groups.push_back(group);
  }
  return groups;
}

std::vector<Level> levels_of(const std::vector<RunGroup>& groups) {
  std::vector<Level> all;
  for (const RunGroup& group : groups) all.insert(all.end(), group.begin(), group.end());
  return all;
}

TEST(FragilityBounds, RunsOfAMotionThatAreRepeatedTellNothingMore) {
  const Fragility fit = fit_fragility(levels_of(motions(1))).value();
  const auto [lower, upper] = FragilityBounds(fit, motions(1)).of_median();
  EXPECT_LT(lower, fit.median);
  const auto again = FragilityBounds(fit, motions(9)).of_median();
  EXPECT_NEAR(again.lower, lower, 1e-12);
  EXPECT_NEAR(again.upper, upper, 1e-12);
  const auto alone = FragilityBounds(fit, single_runs(levels_of(motions(9)))).of_median();
  EXPECT_LT(alone.upper / alone.lower, std::pow(upper / lower, 0.5)) << "as if they told more";
}

}  // namespace
}  // namespace rockstack
