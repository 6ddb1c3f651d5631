#include "comparisons/measures/statistics/draws.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace rockstack {
namespace {

// Known answers that the authors of Philox give with their own code (Random123, kat_vectors).
TEST(Draws, PhiloxGivesTheAnswersOfItsAuthors) {
  using Counter = std::array<std::uint32_t, 4>;
  EXPECT_EQ(philox({0, 0, 0, 0}, {0, 0}), (Counter{0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8}));
  constexpr std::uint32_t ones = 0xffffffff;
  EXPECT_EQ(philox({ones, ones, ones, ones}, {ones, ones}),
            (Counter{0x408f276d, 0x41c83b0e, 0xa20bc7c6, 0x6d5451fd}));
  EXPECT_EQ(philox({0x243f6a88, 0x85a308d3, 0x13198a2e, 0x03707344}, {0xa4093822, 0x299f31d0}),
            (Counter{0xd16cfe09, 0x94fdcceb, 0x5001e420, 0x24126ea1}));
}

TEST(Draws, DifferWithSeedRunAndKey) {
  const Distribution uniform{Distribution::Kind::uniform, 0, 1};
  std::set<double> values;
  for (const std::uint64_t seed : {0UL, 1UL, 1UL << 40U}) {
    for (const std::uint64_t run : {0UL, 1UL, 1UL << 40U}) {
      for (const std::uint32_t key : {0U, 1U, 2U}) values.insert(draw(uniform, {seed, run, key}));
    }
  }
  EXPECT_EQ(values.size(), 27u);
}

// The mean of n draws scatters by deviation/√n about that of the distribution, the mean square likewise: five
// of these deviations fail a right generator once in a million, and these draws are always the same.
TEST(Draws, HaveTheMomentsOfTheirDistributions) {
  constexpr int n = 20000;
  const auto mean_and_deviation = [](const Distribution& distribution, bool logarithm) {
    double sum = 0, squares = 0;
    for (std::uint64_t run = 0; run < n; ++run) {
      const double raw = draw(distribution, {3, run, 1});
      const double value = logarithm ? std::log(raw) : raw;
      sum += value;
      squares += value * value;
    }
    return std::pair(sum / n, std::sqrt(squares / n - sum / n * (sum / n)));
  };
  const double scatter = 5 / std::sqrt(static_cast<double>(n));
  const auto [uniform, uniform_deviation] = mean_and_deviation({Distribution::Kind::uniform, 2, 5}, false);
  EXPECT_NEAR(uniform, 3.5, scatter * 3 / std::sqrt(12.0));
  EXPECT_NEAR(uniform_deviation, 3 / std::sqrt(12.0), scatter);
  const auto [normal, normal_deviation] = mean_and_deviation({Distribution::Kind::normal, -1, 0.5}, false);
  EXPECT_NEAR(normal, -1, scatter * 0.5);
  EXPECT_NEAR(normal_deviation, 0.5, scatter * 0.5);
  const auto [log, log_deviation] = mean_and_deviation({Distribution::Kind::lognormal, 4, 0.3}, true);
  EXPECT_NEAR(log, std::log(4.0), scatter * 0.3);
  EXPECT_NEAR(log_deviation, 0.3, scatter * 0.3);
}

TEST(Draws, HalfOfAllStayBelowTheMedian) {
  constexpr int n = 10000;
  for (const Distribution& distribution :
       {Distribution{Distribution::Kind::uniform, 2, 5}, Distribution{Distribution::Kind::normal, -1, 0.5},
        Distribution{Distribution::Kind::lognormal, 4, 0.3}}) {
    int below = 0;
    for (std::uint64_t run = 0; run < n; ++run) {
      if (draw(distribution, {5, run, 0}) < median(distribution)) ++below;
    }
    EXPECT_NEAR(below, n / 2.0, 5 * std::sqrt(n / 4.0));
  }
}

}  // namespace
}  // namespace rockstack
