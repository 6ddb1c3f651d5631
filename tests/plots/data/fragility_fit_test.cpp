#include "plots/data/fragility_fit.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace rockstack::plots {
namespace {

constexpr double median = 3.0, beta = 0.4;

std::vector<TestedLevel> counts(double runs) {
  std::vector<TestedLevel> list;
  for (const double x : {1.5, 2.0, 2.5, 3.0, 3.5, 4.5}) list.push_back({x, runs});
  return list;
}

TEST(FragilityFit, PassesOneHalfAtItsMedianBetweenItsBounds) {
  const FragilityFit fit(median, beta, counts(20));
  EXPECT_NEAR(fit.probability(median), 0.5, 1e-15);
  for (double x = 0.5; x < 8; x += 0.5) {
    EXPECT_LE(fit.lower(x), fit.probability(x)) << x;
    EXPECT_GE(fit.upper(x), fit.probability(x)) << x;
  }
  EXPECT_LT(fit.median_lower(), median);
  EXPECT_GT(fit.median_upper(), median);
}

// Standard errors fall as one over the square root of the number of runs.
TEST(FragilityFit, FourTimesTheRunsHalveTheBounds) {
  const FragilityFit few(median, beta, counts(20)), many(median, beta, counts(80));
  EXPECT_NEAR(std::log(few.median_upper() / median), 2 * std::log(many.median_upper() / median), 1e-12);
}

// Levels at equal distances on both sides of the median leave its error free of β: each bears the information
// n φ²/(p (1 − p) β²).
TEST(FragilityFit, TwoLevelsAtEqualDistancesFixTheMedianAlone) {
  const double apart = 0.3, n = 50;
  const FragilityFit fit(median, beta, {{median * std::exp(apart), n}, {median / std::exp(apart), n}});
  const double z = apart / beta, p = fit.probability(median * std::exp(apart));
  const double density = std::exp(-z * z / 2) / std::sqrt(2 * std::acos(-1.0));
  const double error = beta * std::sqrt(p * (1 - p) / (2 * n)) / density;
  EXPECT_NEAR(std::log(fit.median_upper() / median), 1.959964 * error, 1e-12);
}

TEST(FragilityFit, CountsOfOneLevelBoundNothing) {
  const FragilityFit fit(median, beta, {{median, 20}});
  EXPECT_EQ(fit.lower(2 * median), 0);
  EXPECT_EQ(fit.upper(2 * median), 1);
}

}  // namespace
}  // namespace rockstack::plots
