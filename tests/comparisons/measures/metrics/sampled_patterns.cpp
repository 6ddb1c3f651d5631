#include "comparisons/measures/metrics/sampled_patterns.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "analytic/solve.hpp"
#include "tests/free_rocking.hpp"

namespace rockstack {
namespace {

Scene sampled_block() {
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
  for (const Pattern& pattern : sampled_patterns(sampled_block(), history)) {
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

// A cube of 1 m is thrown up at 2 m/s from a gap of 0.1 m: it is apart but near the top, where no engine that
// hovers could be told from it, and closed once it has landed.
TEST(SampledPatterns, WhatFliesIsApart) {
  Scene scene;
  scene.blocks = {make_block(1, 1, 2500)};
  scene.duration = 1;
  scene.initial = {{0}, {0}};
  scene.law = Law::unilateral;
  scene.friction = {0.5};
  History history;
  history.blocks = 1;
  for (int i = 0; i <= 1000; ++i) {
    const double time = 1e-3 * i;
    history.times.push_back(time);
    history.angles.push_back(0);
    history.velocities.push_back(0);
    history.gaps.push_back(std::max(0.0, 0.1 + 2 * time - 0.5 * scene.gravity * time * time));
  }
  const double top = 2 / scene.gravity, landing = top + std::sqrt(top * top + 0.2 / scene.gravity);
  const auto at = [&](double time) {
    return sampled_patterns(scene, history)[static_cast<std::size_t>(1e3 * time)][0];
  };
  EXPECT_EQ(at(0), Contact::apart);
  EXPECT_EQ(at(top - 0.05), Contact::apart);
  EXPECT_EQ(at(landing - 0.005), Contact::apart);
  EXPECT_EQ(at(landing + 0.005), Contact::closed);
  scene.law = Law::consistent;
  EXPECT_EQ(at(top - 0.05), Contact::closed);
}

}  // namespace
}  // namespace rockstack
