#include "comparisons/measures/statistics/fragility.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace rockstack {
namespace {

constexpr double z = 1.959963984540054;

// Closed forms: for no hits the upper limit is z²/(n + z²); for half of them the interval is symmetric with
// half-width z/(2 √(n + z²)); and the limits are where (share − p)² = z² p (1 − p)/n.
TEST(Fragility, WilsonBoundsHaveTheirClosedForms) {
  EXPECT_EQ(wilson_bounds(0, 20).lower, 0);
  EXPECT_NEAR(wilson_bounds(0, 20).upper, z * z / (20 + z * z), 1e-15);
  EXPECT_EQ(wilson_bounds(20, 20).upper, 1);
  EXPECT_NEAR(wilson_bounds(20, 20).lower, 20 / (20 + z * z), 1e-15);
  EXPECT_NEAR(wilson_bounds(10, 20).upper, 0.5 + z / (2 * std::sqrt(20 + z * z)), 1e-15);
  EXPECT_NEAR(wilson_bounds(10, 20).lower, 0.5 - z / (2 * std::sqrt(20 + z * z)), 1e-15);
  const Bounds bounds = wilson_bounds(3, 17);
  for (const double p : {bounds.lower, bounds.upper}) {
    EXPECT_NEAR(std::pow(3.0 / 17 - p, 2), z * z * p * (1 - p) / 17, 1e-15);
  }
}

TEST(Fragility, NothingIsKnownWithoutRuns) {
  EXPECT_EQ(wilson_bounds(0, 0).lower, 0);
  EXPECT_EQ(wilson_bounds(0, 0).upper, 1);
}

// Two levels leave no freedom: the fitted curve goes through both shares, 1/4 and 3/4, whose quantiles are
// ∓0.6744897501960817; so the median is the geometric mean and beta = ln(4)/(2 × 0.6744897501960817).
TEST(Fragility, TheCurveOfTwoLevelsGoesThroughBoth) {
  const auto curve = fit_fragility({{1, 20, 5, 0}, {4, 20, 15, 0}});
  ASSERT_TRUE(curve);
  EXPECT_NEAR(curve->median, 2, 1e-12);
  EXPECT_NEAR(curve->beta, std::log(4.0) / (2 * 0.6744897501960817), 1e-12);
  EXPECT_NEAR(probability(*curve, 1), 0.25, 1e-12);
  EXPECT_NEAR(curve->log_likelihood, 2 * (5 * std::log(0.25) + 15 * std::log(0.75)), 1e-11);
  const auto from_zero = fit_fragility({{0, 20, 0, 0}, {1, 20, 5, 0}, {4, 20, 15, 0}});
  ASSERT_TRUE(from_zero);
  EXPECT_EQ(from_zero->median, curve->median);
  EXPECT_EQ(from_zero->log_likelihood, curve->log_likelihood);
  EXPECT_EQ(probability(*from_zero, 0), 0);
  EXPECT_FALSE(fit_fragility({{0, 20, 1, 0}, {1, 20, 5, 0}, {4, 20, 15, 0}}));
}

TEST(Fragility, TheCurveIsTheMostLikelyOne) {
  const std::vector<Level> levels{
      {2, 20, 0, 0}, {3, 20, 1, 0}, {4, 18, 8, 2}, {6, 20, 13, 0}, {9, 20, 20, 0}};
  const auto curve = fit_fragility(levels);
  ASSERT_TRUE(curve);
  const auto likelihood = [&](const Fragility& other) {
    double sum = 0;
    for (const Level& level : levels) {
      const double p = probability(other, level.intensity);
      sum += static_cast<double>(level.toppled) * std::log(p) +
             static_cast<double>(level.runs - level.toppled) * std::log1p(-p);
    }
    return sum;
  };
  EXPECT_NEAR(likelihood(*curve), curve->log_likelihood, 1e-10);
  for (const double factor : {0.99, 1.01}) {
    EXPECT_LT(likelihood({curve->median * factor, curve->beta, 0}), curve->log_likelihood);
    EXPECT_LT(likelihood({curve->median, curve->beta * factor, 0}), curve->log_likelihood);
  }
}

TEST(Fragility, RescaledIntensitiesRescaleTheMedianAlone) {
  const auto curve = fit_fragility({{2, 10, 1, 0}, {3, 10, 4, 0}, {5, 10, 8, 0}});
  const auto scaled = fit_fragility({{20, 10, 1, 0}, {30, 10, 4, 0}, {50, 10, 8, 0}});
  ASSERT_TRUE(curve && scaled);
  EXPECT_NEAR(scaled->median, 10 * curve->median, 1e-10);
  EXPECT_NEAR(scaled->beta, curve->beta, 1e-10);
}

TEST(Fragility, ThereIsNoCurveWhereTheLikelihoodHasNoMaximum) {
  EXPECT_FALSE(fit_fragility({{1, 10, 0, 0}, {2, 10, 10, 0}})) << "one intensity parts the runs";
  EXPECT_FALSE(fit_fragility({{1, 10, 0, 0}, {2, 10, 5, 0}, {3, 10, 10, 0}})) << "likewise, shared by both";
  EXPECT_FALSE(fit_fragility({{1, 10, 8, 0}, {2, 10, 2, 0}})) << "toppling falls with intensity";
  EXPECT_FALSE(fit_fragility({{1, 10, 0, 0}, {2, 10, 0, 0}})) << "nothing topples";
  EXPECT_FALSE(fit_fragility({{1, 10, 10, 0}, {2, 10, 10, 0}})) << "all topple";
  EXPECT_FALSE(fit_fragility({{0, 10, 1, 0}, {2, 10, 5, 0}})) << "no logarithm";
  EXPECT_FALSE(fit_fragility({{2, 10, 5, 0}})) << "one level";
}

}  // namespace
}  // namespace rockstack
