#include "comparisons/measures/metrics/difference.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace rockstack {
namespace {

/// Two blocks; the second history differs by `slope`·t at block 2 alone.
History ramp(double slope, int samples) {
  History history;
  history.blocks = 2;
  for (int i = 0; i < samples; ++i) {
    const double t = 0.5 * i;
    history.times.push_back(t);
    history.angles.insert(history.angles.end(), {0.1, slope * t});
    history.velocities.insert(history.velocities.end(), {0, slope});
  }
  return history;
}

TEST(Difference, IsSecondLessFirstOverTheCommonTime) {
  const Difference apart = difference(ramp(0, 5), ramp(0.5, 3));
  ASSERT_EQ(apart.times.size(), 3u);
  EXPECT_EQ(apart.values, (std::vector<double>{0, 0, 0, 0.25, 0, 0.5}));
}

TEST(Difference, MeasuresFollowTheirDefinitions) {
  const Difference apart = difference(ramp(0, 3), ramp(-0.5, 3));
  EXPECT_EQ(largest(apart), 0.5);
  EXPECT_EQ(root_mean_square(apart), std::sqrt((0.0625 + 0.25) / 6));
}

TEST(Difference, AgreementLastsUntilTheToleranceIsFirstPassed) {
  const Difference apart = difference(ramp(0, 5), ramp(0.5, 5));
  EXPECT_EQ(agreement_time(apart, 0.3), 1.0);   // 0.25 at 0.5 s is within, 0.5 at 1 s is not
  EXPECT_EQ(agreement_time(apart, 0.25), 1.0);  // the tolerance itself is within
  EXPECT_EQ(agreement_time(apart, 10), 2.0);    // never passed: the end
}

TEST(Difference, RefusesHistoriesAtDifferentTimes) {
  History other = ramp(0, 3);
  other.times[1] += 1e-9;
  EXPECT_THROW(difference(ramp(0, 3), other), std::invalid_argument);
}

TEST(Difference, SlipsAreComparedWhereTheFirstHistoryTouches) {
  History first = ramp(0, 3), second = first;
  EXPECT_FALSE(slip_difference(first, second));
  first.patterns.assign(3, closed_pattern(2));
  first.patterns[2][1] = Contact::apart;
  first.slips.assign(6, 0);
  second.slips = {0, 0, 0.25, -0.5, 0.125, 9};
  const SlipDifference apart = slip_difference(first, second).value();
  EXPECT_EQ(apart.largest, 0.5);
  EXPECT_EQ(apart.last, 0.125);
  first.patterns[2][0] = Contact::apart;
  EXPECT_FALSE(slip_difference(first, second)->last);
}

}  // namespace
}  // namespace rockstack
