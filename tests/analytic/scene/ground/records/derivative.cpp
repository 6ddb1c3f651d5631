#include "analytic/scene/ground/records/format.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "analytic/scene/ground/records/record_file.hpp"
#include "tests/analytic/scene/ground/records/layouts.hpp"
#include "tests/analytic/scene/ground/records/refusals.hpp"

namespace rockstack::records {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double epsilon = std::numeric_limits<double>::epsilon();

/// Velocities and displacements at the samples of straight lines of acceleration, from rest.
struct Path {
  std::vector<double> velocities{0}, displacements{0};
};

Path integrated(const Record& motion) {
  Path path;
  const double h = motion.interval;
  for (std::size_t k = 0; k + 1 < motion.samples.size(); ++k) {
    const double a = motion.samples[k], b = motion.samples[k + 1], v = path.velocities.back();
    path.velocities.push_back(v + h * (a + b) / 2);
    path.displacements.push_back(path.displacements.back() + h * v + h * h * (2 * a + b) / 6);
  }
  return path;
}

TEST(AccelerationOfVelocity, PassesThroughEverySample) {
  for (const std::size_t count : {2U, 3U, 4U, 50U}) {
    const std::vector<double> velocities = made_up_samples(count);
    const Record motion = acceleration_of_velocity(0.02, velocities);
    EXPECT_EQ(motion.interval, 0.01);
    ASSERT_EQ(motion.samples.size(), 2 * count - 1);
    const Path path = integrated(motion);
    // Each piece adds roundings of accelerations up to 4δ/h times h, δ < 1 the largest sample.
    for (std::size_t k = 0; k < count; ++k)
      EXPECT_NEAR(path.velocities[2 * k], velocities[k] - velocities[0],
                  16.0 * static_cast<double>(count) * epsilon);
  }
}

TEST(AccelerationOfVelocity, IsExactForAConstantAcceleration) {
  const Record motion = acceleration_of_velocity(0.25, {1, 1.5, 2, 2.5, 3});
  for (const double sample : motion.samples) EXPECT_NEAR(sample, 2, 8 * epsilon);
}

TEST(AccelerationOfDisplacement, PassesThroughEverySampleAndRestsAtBothEnds) {
  for (const std::size_t count : {2U, 3U, 50U}) {
    const std::vector<double> displacements = made_up_samples(count);
    const Record motion = acceleration_of_displacement(0.02, displacements);
    ASSERT_EQ(motion.samples.size(), count);
    const Path path = integrated(motion);
    // A rounding of the velocity, 12 ε/h of an acceleration times h, goes on as a drift over all that follow.
    const double n = static_cast<double>(count);
    for (std::size_t k = 0; k < count; ++k)
      EXPECT_NEAR(path.displacements[k], displacements[k] - displacements[0], 24 * n * n * epsilon);
    EXPECT_NEAR(path.velocities.back(), 0, 24 * n * epsilon / 0.02);
  }
}

/// Largest error of the acceleration of cos 2πt over a second, from its displacement or velocity at 1/n s.
double largest_error(int n, bool displacement) {
  std::vector<double> samples;
  for (int k = 0; k <= n; ++k)
    samples.push_back(displacement ? -std::cos(2 * pi * k / n) / (4 * pi * pi)
                                   : std::sin(2 * pi * k / n) / (2 * pi));
  const Record motion = displacement ? acceleration_of_displacement(1.0 / n, samples)
                                     : acceleration_of_velocity(1.0 / n, samples);
  double largest = 0;
  for (std::size_t k = 0; k < motion.samples.size(); ++k)
    largest = std::max(
        largest, std::abs(motion.samples[k] - std::cos(2 * pi * motion.interval * static_cast<double>(k))));
  return largest;
}

TEST(Derivatives, ErrorsFallWithTheSquareOfTheInterval) {
  // The next term falls with the fourth power: at 40 samples a period it moves the ratio by less than a
  // hundredth.
  for (const bool displacement : {false, true})
    EXPECT_NEAR(largest_error(40, displacement) / largest_error(80, displacement), 4, 0.04);
}

TEST(Derivatives, EnlargeErrorsOfTheSamplesByWhatIsStated) {
  // The worst errors are those that change sign from sample to sample; far from the ends they reach the
  // bound.
  constexpr double h = 0.02, delta = 1e-3;
  std::vector<double> worst;
  for (int k = 0; k < 101; ++k) worst.push_back(k % 2 == 0 ? delta : -delta);
  const auto largest = [](const Record& motion) {
    return std::abs(*std::max_element(motion.samples.begin(), motion.samples.end(),
                                      [](double a, double b) { return std::abs(a) < std::abs(b); }));
  };
  EXPECT_NEAR(largest(acceleration_of_velocity(h, worst)), 4 * delta / h, 1e-12);
  EXPECT_NEAR(largest(acceleration_of_displacement(h, worst)), 12 * delta / (h * h), 1e-10);
}

TEST(TextColumns, OfVelocityAndDisplacementAreDifferentiated) {
  const std::string rows = "0.00, 0\n0.01, 1\n0.02, 3\n0.03, 6\n";
  const std::vector<double> read{0, 1e-2, 3e-2, 6e-2};
  for (const char* head : {"# units: cm/s\n", "t [s], v [cm/s]\n", "# velocity, units = cm/sec\n"}) {
    const Record record = read_text(head + rows);
    EXPECT_EQ(record.format, "text columns of velocity");
    EXPECT_DOUBLE_EQ(record.interval, 0.005);
    const auto expected = acceleration_of_velocity(0.01, read).samples;
    ASSERT_EQ(record.samples.size(), expected.size());
    // The step is a mean of times as they are read.
    for (std::size_t k = 0; k < expected.size(); ++k) EXPECT_NEAR(record.samples[k], expected[k], 1e-14);
  }
  const Record record = read_text("Time (s), x (cm)\n0.00, 0\n0.01, 0\n0.02, 1\n0.03, 2\n0.04, 2\n");
  EXPECT_EQ(record.format, "text columns of displacement");
  EXPECT_DOUBLE_EQ(record.interval, 0.01);
  EXPECT_EQ(record.samples.size(), 5U);
  expect_error("Time (s), x (cm)\n" + rows, "begins in motion");
  expect_error("Time (s), x (cm)\n0.00, 0\n0.01, 0\n0.02, 1\n0.03, 2\n", "ends in motion");
  expect_error("Time (s), v (cm/s)\n0.00, 1\n0.01, 2\n", "begins in motion");
}

TEST(TextColumns, LengthsOfAHeaderAreNoUnitWhereAnAccelerationIsNamed) {
  const std::string rows = "0.00, 0\n0.01, 1\n";
  EXPECT_EQ(read_text("# PGV 3 in units of cm/s, depth (m) 10\n# units: cm/s2\n" + rows).format,
            "text columns");
  EXPECT_NE(error_of_text("# elevation (m) 10\n" + rows).find("names no unit of acceleration"),
            std::string::npos);
  EXPECT_EQ(error_of_text("# units: mm\n# units: cm\n" + rows),
            "file:2: names another unit of velocity or displacement than line 1");
  EXPECT_EQ(error_of_text("# units: mm, dt = 0.1\n5\n"),
            "file:2: one sample of a velocity or displacement gives no acceleration");
}

}  // namespace
}  // namespace rockstack::records
