#include <gtest/gtest.h>

#include <cmath>

#include "comparisons/measures/statistics/fragility.hpp"

namespace rockstack {
namespace {

constexpr double middle = 3.0, beta = 0.4;
constexpr Fragility curve{middle, beta};

std::vector<Level> counts(std::size_t runs) {
  std::vector<Level> list;
  for (const double x : {1.5, 2.0, 2.5, 3.0, 3.5, 4.5}) list.push_back({x, runs});
  return list;
}

TEST(FragilityBounds, PassesOneHalfAtItsMedianBetweenItsBounds) {
  const FragilityBounds bounds(curve, counts(20));
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
  const FragilityBounds few(curve, counts(20)), many(curve, counts(80));
  EXPECT_NEAR(std::log(few.of_median().upper / middle), 2 * std::log(many.of_median().upper / middle), 1e-12);
}

// Levels at equal distances on both sides of the median leave its error free of β: each bears the information
// n φ²/(p (1 − p) β²).
TEST(FragilityBounds, TwoLevelsAtEqualDistancesFixTheMedianAlone) {
  const double apart = 0.3;
  const std::size_t n = 50;
  const FragilityBounds bounds(curve, {{middle * std::exp(apart), n}, {middle / std::exp(apart), n}});
  const double away = apart / beta, p = probability(curve, middle * std::exp(apart));
  const double density = std::exp(-away * away / 2) / std::sqrt(2 * std::acos(-1.0));
  const double error = beta * std::sqrt(p * (1 - p) / (2.0 * n)) / density;
  EXPECT_NEAR(std::log(bounds.of_median().upper / middle), 1.959963984540054 * error, 1e-12);
}

TEST(FragilityBounds, CountsOfOneLevelBoundNothing) {
  const FragilityBounds bounds(curve, {{middle, 20}});
  EXPECT_EQ(bounds.at(2 * middle).lower, 0);
  EXPECT_EQ(bounds.at(2 * middle).upper, 1);
}

}  // namespace
}  // namespace rockstack
