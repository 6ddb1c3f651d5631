#include "comparisons/measures/metrics/impacts.hpp"

#include <gtest/gtest.h>

#include <algorithm>
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
  const auto reported = reported_impacts(scene, history, slowest);
  const auto observed = observed_impacts(scene, history, slowest);
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

Scene one_block() {
  Scene scene;
  scene.blocks = {make_block(1, 9.81, 2500)};  // its matching window is 0.1 s
  return scene;
}

/// A cube of 0.4 m that falls flat by 1 m, and bounces.
Scene falling_cube(double restitution) {
  Scene scene;
  scene.law = Law::unilateral;
  scene.duration = 6;
  scene.blocks = {make_block(0.4, 0.4, 6.25)};
  scene.initial = {{0}, {0}};
  scene.initial.gaps = {1};
  scene.friction = {0.5};
  scene.point_restitution = restitution;
  return scene;
}

// It takes √(2h/g) to fall, and twice that between impacts; each is at √(2gh).
TEST(Impacts, OfACubeThatBouncesFlatHaveTheSpeedOfItsFall) {
  const Scene scene = falling_cube(1);
  const double interval = 1e-3, fall = std::sqrt(2 / scene.gravity);
  const History history = solve(scene, {.sample_times = regular_times(interval, scene.duration)});
  const auto reported = reported_impacts(scene, history, chatter_speed(scene));
  const auto observed = observed_impacts(scene, history, chatter_speed(scene));
  ASSERT_EQ(reported.size(), 7U);
  ASSERT_EQ(observed.size(), 7U);
  for (std::size_t i = 0; i < reported.size(); ++i) {
    EXPECT_TRUE(reported[i].lands && observed[i].lands);
    EXPECT_NEAR(reported[i].time, (2 * static_cast<double>(i) + 1) * fall, 1e-12 * scene.duration);
    EXPECT_NEAR(reported[i].approach, scene.gravity * fall, 1e-12 * scene.gravity * fall);
    // Samples tell the mean speed of the interval before that of the impact.
    EXPECT_NEAR(observed[i].approach, reported[i].approach, 2 * scene.gravity * interval);
    EXPECT_NEAR(observed[i].time, reported[i].time, interval);
  }
}

TEST(Impacts, AreOneWhereACubeLandsFlatAndStays) {
  const Scene scene = falling_cube(0);
  const History history = solve(scene, {.sample_times = regular_times(1e-2, scene.duration)});
  EXPECT_EQ(reported_impacts(scene, history, chatter_speed(scene)).size(), 1U);
  EXPECT_EQ(observed_impacts(scene, history, chatter_speed(scene)).size(), 1U);
}

// Engines keep blocks a little above what they stand on, and take two steps to stop one.
TEST(Impacts, OfALandingThatEndsAboveTheFloorAreOneWhereLinesMeet) {
  History history = solve(falling_cube(0), {.sample_times = regular_times(0.1, 1.2)});
  history.gaps = {0.5, 0.4, 0.3, 0.2, 0.1, 0.0004, 0.0003, 0.0003, 0.0003, 0.0003, 0.0003, 0.0003, 0.0003};
  const auto impacts = observed_impacts(falling_cube(0), history, 0.05);
  ASSERT_EQ(impacts.size(), 1U);
  EXPECT_NEAR(impacts[0].time, 0.5, 1e-3);
  EXPECT_NEAR(impacts[0].approach, 1, 1e-12);
}

TEST(Impacts, OfARockingBlockHaveTheSpeedOfItsFarCorner) {
  Scene scene = one_block();
  scene.initial = {{0.05}, {0}};
  scene.duration = 2;
  const History history = solve(scene, {});
  const ImpactTime first = reported_impacts(scene, history, chatter_speed(scene)).at(0);
  EXPECT_FALSE(first.lands);
  EXPECT_EQ(first.approach, std::abs(history.events[0].before[0]) * 1.0) << "1 m wide";
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
  const auto impacts = observed_impacts(one_block(), samples({0.3, 0.1, -0.1}, {-0.2, -0.2, -0.1}), 0.05);
  ASSERT_EQ(impacts.size(), 1u);
  EXPECT_NEAR(impacts[0].time, 1.5, 1e-15);
}

TEST(Impacts, StoppingShortOfZeroWithinAStepIsAnImpactToo) {
  const auto impacts = observed_impacts(one_block(), samples({0.25, 0.05, 0.001}, {-0.2, -0.2, 0}), 0.05);
  ASSERT_EQ(impacts.size(), 1u);
  EXPECT_NEAR(impacts[0].time, 1.25, 1e-15);
}

TEST(Impacts, SideIsThatToWhichTheInterfaceLeavesOrClosedWhereItIsSlow) {
  const auto side = [](double velocity) {
    return observed_impacts(one_block(), samples({0.3, 0.1, -0.1, -0.2}, {-0.2, -0.2, velocity, velocity}),
                            0.05)
        .at(0)
        .side;
  };
  EXPECT_EQ(side(-0.1), Contact::left);
  EXPECT_EQ(side(0.1), Contact::right);
  EXPECT_EQ(side(-0.01), Contact::closed);
}

TEST(Impacts, TurningBackAwayFromZeroIsNone) {
  EXPECT_TRUE(
      observed_impacts(one_block(), samples({0.5, 0.3, 0.3, 0.5}, {-0.2, -0.1, 0.1, 0.2}), 0.05).empty());
}

TEST(Impacts, JitterBelowTheChatterSpeedIsNone) {
  EXPECT_TRUE(
      observed_impacts(one_block(), samples({1e-3, -1e-3, 1e-3}, {-2e-3, 2e-3, -2e-3}), 0.05).empty());
}

Scene released_block() {
  Scene scene;
  scene.duration = 8;
  scene.blocks = {make_block(1, 3, 2500)};
  scene.initial = {{0.1}, {0}};
  return scene;
}

// A block that comes to rest has one settling, and its last chatter lies in it.
TEST(Settlings, AllChatterOfABlockIsOne) {
  const Scene scene = released_block();
  const History history = solve(scene, {.sample_times = regular_times(1e-3, scene.duration)});
  ASSERT_EQ(history.events.back().kind, EventKind::rest);
  const auto list = settlings(scene, history);
  ASSERT_EQ(list.size(), 1U);
  EXPECT_EQ(list[0].interface, 1);
  EXPECT_LT(list[0].time, history.events.back().time);
  const auto inside = std::count_if(history.events.begin(), history.events.end(), [&](const Event& event) {
    return event.kind == EventKind::impact && event.time > list[0].time;
  });
  EXPECT_GT(inside, 10);
}

TEST(Settlings, NoneOfAStackThatNeverMoves) {
  Scene scene = released_block();
  scene.initial.angles = {0};
  EXPECT_TRUE(settlings(scene, solve(scene, {.sample_times = regular_times(1e-2, scene.duration)})).empty());
}

/// Samples of one block every 0.1 s for 1 s.
History moving_at(double velocity, const Pattern& pattern) {
  History history;
  history.blocks = 1;
  for (int i = 0; i <= 10; ++i) history.times.push_back(0.1 * i);
  history.angles.assign(11, 0);
  history.velocities.assign(11, velocity);
  history.patterns.assign(11, pattern);
  return history;
}

TEST(ResidualMotion, IsTheEnginesSpeedWhereTheExactSolutionRests) {
  const History engine = moving_at(-3e-4, {});
  EXPECT_NEAR(residual_motion(moving_at(0, closed_pattern(1)), engine).value(), 3e-4, 1e-18);
}

TEST(ResidualMotion, IsNotGivenWhereTheExactSolutionMoves) {
  History exact = moving_at(0, closed_pattern(1));
  exact.patterns.back()[0] = Contact::left;
  EXPECT_FALSE(residual_motion(exact, moving_at(0, {})));
}

}  // namespace
}  // namespace rockstack
