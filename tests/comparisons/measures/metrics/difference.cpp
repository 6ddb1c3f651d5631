#include "comparisons/measures/metrics/difference.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

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

/// Whole periods of a sine, `lag` of a period late.
History sine(double amplitude, double lag) {
  History history;
  history.blocks = 1;
  for (int i = 0; i < 4000; ++i) {
    history.times.push_back(i * 1e-3);
    history.angles.push_back(amplitude * std::sin(2 * std::numbers::pi * (i * 1e-3 - lag)));
  }
  return history;
}

// Sums of a few thousand squares: 1e-12 is far above their rounding.
constexpr double sum_rounding = 1e-12;

TEST(MagnitudePhase, IsZeroOfAHistoryWithItself) {
  const MagnitudePhase parts = magnitude_phase(sine(0.1, 0), sine(0.1, 0));
  EXPECT_EQ(parts.magnitude, 0);
  EXPECT_EQ(parts.phase, 0);
}

TEST(MagnitudePhase, AmplitudeIsMagnitudeAlone) {
  const MagnitudePhase parts = magnitude_phase(sine(0.1, 0), sine(0.12, 0));
  EXPECT_NEAR(parts.magnitude, 0.2, sum_rounding);
  EXPECT_NEAR(parts.phase, 0, sum_rounding);
}

TEST(MagnitudePhase, DelayIsPhaseAloneAndOppositionIsOne) {
  for (const double lag : {1e-6, 0.01, 0.25}) {
    const MagnitudePhase parts = magnitude_phase(sine(0.1, 0), sine(0.1, lag));
    EXPECT_NEAR(parts.magnitude, 0, sum_rounding) << lag;
    EXPECT_NEAR(parts.phase, 2 * lag, sum_rounding) << lag;
  }
  EXPECT_NEAR(magnitude_phase(sine(0.1, 0), sine(0.1, 0.5)).phase, 1, sum_rounding);
}

TEST(MagnitudePhase, EndsWithTheShorterHistory) {
  History shorter = sine(0.1, 0.1);
  shorter.times.resize(2000);
  shorter.angles.resize(2000);
  EXPECT_NEAR(magnitude_phase(sine(0.1, 0), shorter).phase, 0.2, sum_rounding);
}

}  // namespace
}  // namespace rockstack
