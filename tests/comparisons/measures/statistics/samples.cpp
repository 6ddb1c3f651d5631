#include "comparisons/measures/statistics/samples.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
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

/// An impact a second, for a hundred.
std::vector<ImpactTime> clockwork() {
  std::vector<ImpactTime> impacts(100);
  for (std::size_t i = 0; i < impacts.size(); ++i) impacts[i] = {static_cast<double>(i) + 0.5, 1};
  return impacts;
}

// None of a hundred times drawn from 100 s comes within ±0.05 s of an impact with a chance of
// (1 − 0.001)^100 = e^−0.1: 9.5 impacts are met on average, with a standard deviation near 3; the median of
// 101 has one near 0.4.
TEST(ChanceMatches, RandomTimesMeetAsManyImpactsAsTheirWindowsSay) {
  const auto impacts = clockwork();
  const std::vector<double> windows(impacts.size(), 0.05);
  const int matched = chance_matches(impacts, impacts, windows, 100).random;
  EXPECT_GE(matched, 8);
  EXPECT_LE(matched, 11);
}

// A shift of a clockwork meets all impacts or none: all of them in a tenth of the cases.
TEST(ChanceMatches, AShiftedClockworkMostlyMeetsNone) {
  const auto impacts = clockwork();
  EXPECT_EQ(chance_matches(impacts, impacts, std::vector<double>(impacts.size(), 0.05), 100).shifted, 0);
  // The one that starts over at the end may be half a second from the first.
  EXPECT_GE(chance_matches(impacts, impacts, std::vector<double>(impacts.size(), 0.5), 100).shifted, 98);
}

TEST(ChanceMatches, AreTheSameEachTime) {
  const auto impacts = clockwork();
  const std::vector<double> windows(impacts.size(), 0.2);
  EXPECT_EQ(chance_matches(impacts, impacts, windows, 100).random,
            chance_matches(impacts, impacts, windows, 100).random);
}

// The least of n is multiplied by n, the next by n − 1, …; none falls below one before it.
TEST(Holm, StepsDownFromTheLeastChance) {
  const AdjustedTests adjusted = adjust({{0.02, 0}, {0.01, 0}, {0.05, 0}, {0.04, 0}, {0.03, 0}}, 0.05);
  const std::vector<double> expected{0.08, 0.05, 0.09, 0.09, 0.09};
  EXPECT_EQ(adjusted.counted, 5U);
  for (std::size_t i = 0; i < expected.size(); ++i)
    EXPECT_NEAR(adjusted.p_values[i], expected[i], 1e-15) << i;
}

// Ninety tests of two values each, whose least chance is 1/3, take nothing from ten that can show something.
TEST(Holm, TestsThatCannotShowAnythingDoNotCount) {
  std::vector<TestChance> tests(10, {0.5, 1e-4});
  tests.front().p_value = 0.004;
  tests.resize(100, {1.0 / 3, 1.0 / 3});
  const AdjustedTests adjusted = adjust(tests, 0.05);
  EXPECT_EQ(adjusted.counted, 10U);
  EXPECT_NEAR(adjusted.p_values.front(), 0.04, 1e-15);
  EXPECT_EQ(adjusted.p_values.back(), 1);
}

// Twenty tests that reach 0.004 at best: a share of 0.05/12 is enough for all of them, 0.05/13 for none.
TEST(Holm, WhereTooManyCouldJustShowSomethingNoneCounts) {
  EXPECT_EQ(adjust(std::vector<TestChance>(20, {0.004, 0.004}), 0.05).counted, 0U);
  EXPECT_EQ(adjust(std::vector<TestChance>(12, {0.004, 0.004}), 0.05).counted, 12U);
  EXPECT_EQ(adjust({}, 0.05).counted, 0U);
}

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

// Five in a hundred of 400 pairs of samples of one distribution are further apart than the critical distance:
// 20 ± 4.4.
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

/// Counts all ways to share the values out whose share is as low, and those whose share is as high.
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

// One alone of all C(n + m, n) ways has all of the second sample on top.
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

// All ways to share the values out within every stratum are counted, with ties.
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

// Five in a hundred of 400 pairs of equal samples are shown to differ: 20 ± 4.4. Sizes on both sides of the
// exact limit.
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
