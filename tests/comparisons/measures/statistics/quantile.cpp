#include "comparisons/measures/statistics/quantile.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <random>

namespace rockstack {
namespace {

// What numpy.quantile([15, 20, 35, 40, 50], …) and R's quantile(c(15, 20, 35, 40, 50)) give.
TEST(Quantile, IsWhatOtherProgramsGiveByDefault) {
  const std::vector<double> values{35, 15, 50, 20, 40};
  EXPECT_EQ(quantile(values, 0), 15);
  EXPECT_NEAR(quantile(values, 0.05), 16, 1e-14);
  EXPECT_NEAR(quantile(values, 0.4), 29, 1e-14);
  EXPECT_EQ(quantile(values, 0.25), 20);
  EXPECT_EQ(median(values), 35);
  EXPECT_EQ(quantile(values, 1), 50);
}

TEST(Quantile, TheMedianOfAnEvenNumberLiesHalfWayBetweenTheMiddleTwo) {
  EXPECT_EQ(median({1, 2, 3, 4}), 2.5);
  EXPECT_EQ(median({7}), 7);
}

TEST(Quantile, InfiniteValuesLieBeyondAllOthers) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(quantile({1, 2, infinity}, 0.5), 2);
  EXPECT_EQ(quantile({1, 2, infinity}, 0.51), infinity);
  EXPECT_EQ(quantile({1, infinity, infinity}, 0.75), infinity);
}

// Equal values give themselves, whatever the share; order, a shift and a positive factor of all values carry
// over.
TEST(Quantile, RisesWithTheShareAndMovesWithTheValues) {
  std::mt19937 generator(3);
  std::uniform_real_distribution<double> value(-1, 1);
  std::vector<double> values(10), moved(10);
  for (std::size_t i = 0; i < values.size(); ++i) moved[i] = 4 * (values[i] = value(generator)) + 8;
  double before = quantile(values, 0);
  for (double share = 0.01; share <= 1; share += 0.01) {
    EXPECT_EQ(quantile({0.1, 0.1, 0.1}, share), 0.1);
    EXPECT_GE(quantile(values, share), before);
    EXPECT_NEAR(quantile(moved, share), 4 * quantile(values, share) + 8, 1e-14);
    before = quantile(values, share);
  }
}

}  // namespace
}  // namespace rockstack
