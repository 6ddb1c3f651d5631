#include "comparisons/measures/statistics/mann_whitney.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <random>

namespace rockstack {
namespace {

double choose(int n, int k) {
  return std::round(std::exp(std::lgamma(n + 1) - std::lgamma(k + 1) - std::lgamma(n - k + 1)));
}

/// The share of pairs that the second sample wins, ties half.
double share_won(const std::vector<double>& first, const std::vector<double>& second) {
  double won = 0;
  for (const double a : first)
    for (const double b : second) won += a < b ? 1 : a == b ? 0.5 : 0;
  return won / static_cast<double>(first.size() * second.size());
}

/// Of all ways to share the values out, those whose share is as low, and those whose share is as high.
double p_value_by_counting(std::vector<double> first, const std::vector<double>& second) {
  const double share = share_won(first, second);
  const std::size_t own = second.size();
  first.insert(first.end(), second.begin(), second.end());
  int low = 0, high = 0, all = 0;
  for (unsigned choice = 0; choice < 1U << first.size(); ++choice) {
    if (static_cast<std::size_t>(std::popcount(choice)) != own) continue;
    std::vector<double> in, out;
    for (std::size_t i = 0; i < first.size(); ++i) ((choice >> i & 1U) != 0 ? in : out).push_back(first[i]);
    const double other = share_won(out, in);
    low += other <= share + 1e-12 ? 1 : 0;
    high += other >= share - 1e-12 ? 1 : 0;
    ++all;
  }
  return std::min(1.0, 2.0 * std::min(low, high) / all);
}

TEST(MannWhitney, ChanceIsThatOfCountingAllWaysToShareTheValues) {
  std::mt19937_64 random(3);
  std::uniform_int_distribution<int> few(0, 4), many(0, 1000);
  for (int trial = 0; trial < 20; ++trial) {
    auto& from = trial % 2 == 0 ? few : many;  // with ties and without
    std::vector<double> first(5), second(6);
    for (double& value : first) value = from(random);
    const int apart = trial / 10;
    for (double& value : second) value = from(random) + apart;
    const MannWhitney test = mann_whitney(first, second);
    EXPECT_NEAR(test.p_value, p_value_by_counting(first, second), 1e-12);
    EXPECT_NEAR(test.superiority, share_won(first, second), 1e-12);
    EXPECT_LE(test.least_p_value, test.p_value);
  }
}

// Of all C(n + m, n) ways one alone has all of the second sample on top.
TEST(MannWhitney, SamplesThatLieApartHaveTheLeastChance) {
  const MannWhitney test = mann_whitney({1, 2, 3, 4, 5}, {6, 7, 8, 9, 10, 11, 12});
  EXPECT_NEAR(test.p_value, 2 / choose(12, 5), 1e-15);
  EXPECT_EQ(test.least_p_value, test.p_value);
  EXPECT_EQ(test.superiority, 1);
  EXPECT_NEAR(mann_whitney({1, 3, 5, 7, 9}, {2, 4, 6, 8, 10, 12, 0}).least_p_value, test.p_value, 1e-15);
}

TEST(MannWhitney, ValuesThatAreAllAlikeSayNothing) {
  for (const std::size_t size : {4U, 40U}) {
    const MannWhitney test = mann_whitney(std::vector<double>(size, 2.0), std::vector<double>(size, 2.0));
    EXPECT_EQ(test.superiority, 0.5);
    EXPECT_EQ(test.p_value, 1);
    EXPECT_EQ(test.least_p_value, 1);
  }
}

TEST(MannWhitney, IsTheSameInAnyScaleAndMirroredBetweenSamples) {
  const std::vector<double> first{0.3, 0.1, 0.7, 0.4}, second{0.2, 0.9, 0.5, 0.8};
  std::vector<double> grown, other;
  for (const double value : first) grown.push_back(std::exp(9 * value));
  for (const double value : second) other.push_back(std::exp(9 * value));
  const MannWhitney test = mann_whitney(first, second);
  EXPECT_EQ(mann_whitney(grown, other).p_value, test.p_value);
  EXPECT_EQ(mann_whitney(second, first).superiority, 1 - test.superiority);
  EXPECT_NEAR(mann_whitney(second, first).p_value, test.p_value, 1e-15);
}

// Of all ways to share the values out within every stratum, by counting, with ties.
TEST(MannWhitney, StrataAddUpTheRanksWithinEach) {
  std::mt19937_64 random(4);
  std::uniform_int_distribution<int> few(0, 5);
  const std::size_t size = 3;
  for (int trial = 0; trial < 10; ++trial) {
    std::vector<Stratum> strata(2);
    for (Stratum& stratum : strata)
      for (std::size_t i = 0; i < size; ++i) {
        stratum.first.push_back(few(random));
        const int shift = trial / 3;
        stratum.second.push_back(few(random) + shift);
      }
    std::vector<std::vector<double>> won;  // by each way to share a stratum out
    double own = 0;
    for (const Stratum& stratum : strata) {
      own += share_won(stratum.first, stratum.second);
      std::vector<double> all = stratum.first;
      all.insert(all.end(), stratum.second.begin(), stratum.second.end());
      won.emplace_back();
      for (unsigned choice = 0; choice < 1U << all.size(); ++choice) {
        if (static_cast<std::size_t>(std::popcount(choice)) != size) continue;
        std::vector<double> in, out;
        for (std::size_t i = 0; i < all.size(); ++i) ((choice >> i & 1U) != 0 ? in : out).push_back(all[i]);
        won.back().push_back(share_won(out, in));
      }
    }
    int low = 0, high = 0;
    for (const double one : won[0])
      for (const double other : won[1]) {
        low += one + other <= own + 1e-12 ? 1 : 0;
        high += one + other >= own - 1e-12 ? 1 : 0;
      }
    const auto ways = static_cast<double>(won[0].size() * won[1].size());
    const MannWhitney test = mann_whitney(strata);
    EXPECT_NEAR(test.p_value, std::min(1.0, 2 * std::min(low, high) / ways), 1e-12);
    EXPECT_NEAR(test.superiority, own / 2, 1e-12);
  }
  // Three replicates at two steps tell apart what three at one cannot: 2/20² against 2/20.
  const Stratum apart{{1, 2, 3}, {4, 5, 6}};
  EXPECT_NEAR(mann_whitney({apart}).p_value, 0.1, 1e-15);
  EXPECT_NEAR(mann_whitney({apart, apart}).p_value, 0.005, 1e-15);
}

// Of 400 pairs of equal samples, 5 % are shown to differ: 20 ± 4.4. Sizes on both sides of the exact limit.
TEST(MannWhitney, RejectsWhatIsEqualAsOftenAsItSays) {
  for (const std::size_t size : {12U, 40U}) {
    std::mt19937_64 random(7);
    std::normal_distribution<double> normal;
    int rejected = 0;
    for (int trial = 0; trial < 400; ++trial) {
      std::vector<double> first(size), second(size);
      for (double& value : first) value = normal(random);
      for (double& value : second) value = normal(random);
      rejected += mann_whitney(first, second).p_value <= 0.05 ? 1 : 0;
    }
    EXPECT_GE(rejected, 7) << size;
    EXPECT_LE(rejected, 33) << size;
  }
}

}  // namespace
}  // namespace rockstack
