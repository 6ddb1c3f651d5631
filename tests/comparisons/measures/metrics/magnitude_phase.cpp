#include "comparisons/measures/metrics/magnitude_phase.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace rockstack {
namespace {

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
