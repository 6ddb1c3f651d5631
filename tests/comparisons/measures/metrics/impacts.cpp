#include "comparisons/measures/metrics/impacts.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "analytic/solve.hpp"
#include "tests/free_rocking.hpp"

namespace rockstack {
namespace {

TEST(Impacts, ObservedInSamplesOfTheExactSolutionAreTheReportedOnes) {
  const Scene scene = free_rocking(3);
  const double interval = 1e-4;
  const History history = solve(scene, {.sample_times = regular_times(interval, scene.duration)});
  const double slowest = chatter_speed(scene);
  const auto reported = reported_impacts(history, slowest);
  const auto observed = observed_impacts(history, slowest);
  ASSERT_EQ(observed.size(), reported.size());
  ASSERT_GT(reported.size(), 5u);
  for (std::size_t i = 0; i < reported.size(); ++i) {
    EXPECT_EQ(observed[i].interface, reported[i].interface);
    // Two samples later gravity has changed the speed by less than a hundredth of the chatter speed.
    EXPECT_GE(sign(observed[i].side) * sign(reported[i].side), 0);
    // Interpolation cannot leave the interval that holds the impact.
    EXPECT_NEAR(observed[i].time, reported[i].time, interval);
  }
}

/// One block whose angle and velocity are given at times 0, 1, 2, … s.
History samples(const std::vector<double>& angles, const std::vector<double>& velocities) {
  History history;
  history.blocks = 1;
  for (std::size_t i = 0; i < angles.size(); ++i) history.times.push_back(static_cast<double>(i));
  history.angles = angles;
  history.velocities = velocities;
  return history;
}

TEST(Impacts, PassingZeroIsTimedByInterpolation) {
  const auto impacts = observed_impacts(samples({0.3, 0.1, -0.1}, {-0.2, -0.2, -0.1}), 0.05);
  ASSERT_EQ(impacts.size(), 1u);
  EXPECT_NEAR(impacts[0].time, 1.5, 1e-15);
}

TEST(Impacts, StoppingShortOfZeroWithinAStepIsAnImpactToo) {
  const auto impacts = observed_impacts(samples({0.25, 0.05, 0.001}, {-0.2, -0.2, 0}), 0.05);
  ASSERT_EQ(impacts.size(), 1u);
  EXPECT_NEAR(impacts[0].time, 1.25, 1e-15);
}

TEST(Impacts, SideIsThatToWhichTheInterfaceLeavesOrClosedWhereItIsSlow) {
  const auto side = [](double velocity) {
    return observed_impacts(samples({0.3, 0.1, -0.1, -0.2}, {-0.2, -0.2, velocity, velocity}), 0.05)
        .at(0)
        .side;
  };
  EXPECT_EQ(side(-0.1), Contact::left);
  EXPECT_EQ(side(0.1), Contact::right);
  EXPECT_EQ(side(-0.01), Contact::closed);
}

TEST(Impacts, TurningBackAwayFromZeroIsNone) {
  EXPECT_TRUE(observed_impacts(samples({0.5, 0.3, 0.3, 0.5}, {-0.2, -0.1, 0.1, 0.2}), 0.05).empty());
}

TEST(Impacts, JitterBelowTheChatterSpeedIsNone) {
  EXPECT_TRUE(observed_impacts(samples({1e-3, -1e-3, 1e-3}, {-2e-3, 2e-3, -2e-3}), 0.05).empty());
}

}  // namespace
}  // namespace rockstack
