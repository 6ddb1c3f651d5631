#include "comparisons/measures/statistics/kolmogorov_smirnov.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace rockstack {
namespace {

TEST(KolmogorovSmirnov, DistanceIsTheLargestDifferenceOfShares) {
  EXPECT_EQ(kolmogorov_smirnov({1, 2, 3, 4}, {1, 2, 3, 4}).distance, 0);
  EXPECT_EQ(kolmogorov_smirnov({1, 2, 3, 4}, {5, 6}).distance, 1);
  EXPECT_EQ(kolmogorov_smirnov({4, 1, 3, 2}, {2.5, 3.5, 4.5, 1.5}).distance, 0.25);
  EXPECT_EQ(kolmogorov_smirnov({1, 1, 1, 2}, {1, 2, 2, 2}).distance, 0.5);  // ties
}

TEST(KolmogorovSmirnov, DoesNotDependOnOrderScaleOrWhichSampleIsFirst) {
  const auto one = kolmogorov_smirnov({0.3, 0.1, 0.7}, {0.2, 0.4, 0.9, 0.5});
  const auto other = kolmogorov_smirnov({std::exp(0.5), std::exp(0.9), std::exp(0.2), std::exp(0.4)},
                                        {std::exp(0.1), std::exp(0.7), std::exp(0.3)});
  EXPECT_EQ(one.distance, other.distance);
  EXPECT_EQ(one.p_value, other.p_value);
}

// Kolmogorov's limit: λ = 1.3581 has 5 %, 1.6276 has 1 % (N. Smirnov, "Table for estimating the goodness of
// fit of empirical distributions", Ann. Math. Statist. 19, 1948).
TEST(KolmogorovSmirnov, ChancesAreThePublishedOnes) {
  const int n = 200000;
  std::vector<double> first(n), second(n);
  const auto chance_at = [&](double lambda) {
    // Shifted by a share d, two even grids are at the distance d.
    const double d = lambda / std::sqrt(n / 2.0);
    for (int i = 0; i < n; ++i) {
      first[static_cast<std::size_t>(i)] = i;
      second[static_cast<std::size_t>(i)] = i + std::floor(d * n) - 0.5;
    }
    return kolmogorov_smirnov(first, second).p_value;
  };
  EXPECT_NEAR(chance_at(1.3581), 0.05, 2e-3);
  EXPECT_NEAR(chance_at(1.6276), 0.01, 5e-4);
  EXPECT_EQ(chance_at(0), 1);
}

// Of 400 pairs of samples of one distribution, 5 % are further apart than the critical distance: 20 ± 4.4.
TEST(KolmogorovSmirnov, RejectsWhatIsEqualAsOftenAsItSays) {
  std::mt19937_64 random(11);
  std::normal_distribution<double> normal;
  int rejected = 0, unlikely = 0;
  for (int trial = 0; trial < 400; ++trial) {
    std::vector<double> first(50), second(70);
    for (double& value : first) value = normal(random);
    for (double& value : second) value = normal(random);
    const auto apart = kolmogorov_smirnov(first, second);
    rejected += apart.distance > apart.critical ? 1 : 0;
    unlikely += apart.p_value < 0.05 ? 1 : 0;
  }
  EXPECT_EQ(rejected, unlikely);
  EXPECT_GE(rejected, 4);  // four deviations
  EXPECT_LE(rejected, 38);
}

TEST(KolmogorovSmirnov, SeesAShiftOfOneDeviation) {
  std::mt19937_64 random(12);
  std::normal_distribution<double> normal;
  std::vector<double> first(50), second(50);
  for (double& value : first) value = normal(random);
  for (double& value : second) value = 1 + normal(random);
  EXPECT_LT(kolmogorov_smirnov(first, second).p_value, 0.01);
}

}  // namespace
}  // namespace rockstack
