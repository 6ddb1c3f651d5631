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

Scene one_block() {
  Scene scene;
  scene.blocks = {make_block(1, 9.81, 2500)};  // its matching window is 0.1 s
  return scene;
}

/// Angles of one block at 0, 10, 20, … ms, as the letters of its contacts.
std::string letters(const std::vector<double>& angles) {
  History history;
  history.blocks = 1;
  history.angles = angles;
  for (std::size_t i = 0; i < angles.size(); ++i) history.times.push_back(0.01 * static_cast<double>(i));
  std::string word;
  for (const Pattern& pattern : sampled_patterns(one_block(), history)) {
    word += pattern[0] == Contact::left ? 'L' : pattern[0] == Contact::right ? 'R' : 'C';
  }
  return word;
}

TEST(SampledPatterns, PassingThroughTheMiddleIsNeverClosed) {
  EXPECT_EQ(letters({0.01, 0.001, 1e-4, -1e-4, -0.001, -0.01}), "RRRLLL");
  EXPECT_EQ(letters({-0.01, -0.01, 0.001, 0.01}), "LLRR");
}

TEST(SampledPatterns, ABriefTouchIsNeverClosed) {
  EXPECT_EQ(letters({0.01, 0.001, -0.001, 0.001, 0.01}), "RRRRR");
}

TEST(SampledPatterns, StayingWithinTheBandIsClosed) {
  std::vector<double> angles(14, 0.001);
  angles.front() = angles.back() = 0.01;
  EXPECT_EQ(letters(angles), "RCCCCCCCCCCCCR");
}

TEST(SampledPatterns, EndsOfAHistoryThatLieWithinTheBandAreClosed) {
  EXPECT_EQ(letters({0, 0.001, 0.01, 0.001, 0}), "CCRCC");
}

// Outside the band the solver's own pattern and the one read from its samples are the same.
TEST(SampledPatterns, OfTheExactSolutionAreItsOwnWhereAllInterfacesAreWideOpen) {
  const Scene scene = free_rocking(3);
  const History history = solve(scene, {.sample_times = regular_times(1e-3, scene.duration)});
  const auto patterns = sampled_patterns(scene, history);
  int compared = 0;
  for (std::size_t i = 0; i < history.size(); ++i) {
    const double base = history.angles_at(i)[0], top = history.angles_at(i)[1];
    if (std::abs(base) < open_angle || std::abs(top - base) < open_angle) continue;
    EXPECT_EQ(name(patterns[i]), name(history.patterns[i])) << history.times[i];
    ++compared;
  }
  EXPECT_GT(compared, 100);
}

Pattern pattern(Contact contact) {
  Pattern one = closed_pattern(1);
  one[0] = contact;
  return one;
}

const Pattern left = pattern(Contact::left), right = pattern(Contact::right), shut = closed_pattern(1);

TEST(PatternShares, SumToOneAndAgreeWithThemselves) {
  const std::vector<double> times{0, 1, 2, 4};
  const auto shares = pattern_shares(times, {left, right, shut, shut}, {left, left, shut, shut});
  ASSERT_EQ(shares.size(), 3U);
  EXPECT_EQ(shares[0].share, 0.25);  // left and left from 0 to 1
  EXPECT_EQ(shares[1].share, 0.25);
  EXPECT_EQ(shares[2].share, 0.5);
  EXPECT_EQ(agreement(shares), 0.75);
}

TEST(PatternSequences, OnlyTheOrderCounts) {
  const std::vector<double> times{0, 1, 2, 3};
  EXPECT_EQ(sequence_time(times, {left, left, right, right}, {left, right, right, right}), 3);
}

TEST(PatternSequences, PartAtTheEarlierOfTheFirstPatternsThatDiffer) {
  const std::vector<double> times{0, 1, 2, 3};
  EXPECT_EQ(sequence_time(times, {left, left, right, right}, {left, shut, right, right}), 1);
  EXPECT_EQ(sequence_time(times, {left, left, left, right}, {left, left, left, left}), 3);
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
