#include "comparisons/measures/statistics/chance_matches.hpp"

#include <gtest/gtest.h>

namespace rockstack {
namespace {

/// An impact a second, for a hundred.
std::vector<ImpactTime> clockwork() {
  std::vector<ImpactTime> impacts(100);
  for (std::size_t i = 0; i < impacts.size(); ++i) impacts[i] = {static_cast<double>(i) + 0.5, 1};
  return impacts;
}

// Of a hundred times drawn from 100 s, none comes within ±0.05 s of an impact with a chance of
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

}  // namespace
}  // namespace rockstack
