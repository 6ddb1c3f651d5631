#include "analytic/scene/ground/ground_motion.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace rockstack {
namespace {

/// A power of two as interval keeps times and fractions exact.
const GroundMotion sampled{0.25, {0.0, 4.0, -2.0, 6.0, 1.0}, "test"};

TEST(GroundMotion, IsLinearBetweenSamplesAndMeetsThem) {
  for (std::size_t k = 0; k < sampled.samples.size(); ++k) {
    EXPECT_EQ(acceleration(sampled, 0.25 * static_cast<double>(k)), sampled.samples[k]);
  }
  EXPECT_EQ(acceleration(sampled, 0.125), 2.0);
  EXPECT_EQ(acceleration(sampled, 0.3125), 2.5);
}

TEST(GroundMotion, IsZeroAfterItsEndAndWithoutSamples) {
  EXPECT_EQ(acceleration(sampled, std::nextafter(sampled.end(), 2.0)), 0.0);
  EXPECT_EQ(acceleration(sampled, 100.0), 0.0);
  EXPECT_EQ(mean_acceleration(sampled, 1.0, 2.0), 0.0);
  EXPECT_EQ(acceleration(GroundMotion{}, 0.0), 0.0);
  EXPECT_EQ(mean_acceleration(GroundMotion{}, 0.0, 1.0), 0.0);
  EXPECT_EQ(peak(GroundMotion{}), 0.0);
}

TEST(GroundMotion, MeanOverWholeIntervalsIsTheTrapezoidRule) {
  // Every number here is a small multiple of a power of two, so all sums are exact.
  for (std::size_t k = 0; k + 1 < sampled.samples.size(); ++k) {
    const double from = 0.25 * static_cast<double>(k);
    EXPECT_EQ(mean_acceleration(sampled, from, from + 0.25),
              0.5 * (sampled.samples[k] + sampled.samples[k + 1]));
  }
  EXPECT_EQ(mean_acceleration(sampled, 0.0, 1.0), (0.5 * 0.0 + 4.0 - 2.0 + 6.0 + 0.5 * 1.0) / 4);
}

TEST(GroundMotion, MeanAcrossTheEndCountsZeroThere) {
  EXPECT_EQ(mean_acceleration(sampled, 0.75, 1.25), 0.5 * 0.5 * (6.0 + 1.0));
}

TEST(GroundMotion, MeanEqualsFineQuadrature) {
  // The midpoint rule is exact on straight lines; each of the at most four cells with a corner errs by at
  // most (change of slope) × cell²/8. Slopes change by at most 56 m/s³ at the samples here; the jump to zero
  // at the end is not crossed.
  const int cells = 100000;
  for (const auto& [from, to] :
       std::vector<std::pair<double, double>>{{0.0, 1.0}, {0.1, 0.13}, {0.07, 0.91}}) {
    const double cell = (to - from) / cells;
    double sum = 0;
    for (int k = 0; k < cells; ++k) sum += acceleration(sampled, from + (k + 0.5) * cell);
    // Plus the rounding of a sum of `cells` terms not above 6.
    const double tolerance = 4 * 56 * cell * cell / 8 / (to - from) + cells * 6 * 2.3e-16;
    EXPECT_NEAR(mean_acceleration(sampled, from, to), sum / cells, tolerance);
  }
}

// Times and intervals as far apart as scenes and steps may be: a piece is looked for within the samples
// alone.
TEST(GroundMotion, IsZeroAtAnyTimeBeyondItsSamplesHoweverShortTheyAre) {
  const double most = std::numeric_limits<double>::max();
  for (const double interval : {1e-20, 1e-3, 1e20}) {
    const GroundMotion motion{interval, sampled.samples, "test"};
    for (const double share : {0.0, 0.5, 1 - 1e-15, 1.0}) {
      EXPECT_LE(std::abs(acceleration(motion, share * motion.end())), 6) << interval;
      EXPECT_LE(std::abs(mean_acceleration(motion, share * motion.end(), most)), 6) << interval;
    }
    for (const double time : {2 * motion.end(), 1e21, most, std::numeric_limits<double>::infinity()})
      EXPECT_EQ(acceleration(motion, time), 0) << interval;
    EXPECT_EQ(mean_acceleration(motion, 1e21, most), 0) << interval;
  }
}

TEST(GroundMotion, PeakIsTheLargestAbsoluteSample) {
  EXPECT_EQ(peak({0.1, {1.0, -7.0, 3.0}, ""}), 7.0);
}

}  // namespace
}  // namespace rockstack
