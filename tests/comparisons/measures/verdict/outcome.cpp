#include "comparisons/measures/verdict/verdict.hpp"

#include <gtest/gtest.h>

namespace rockstack {
namespace {

const JudgedScene scale{.least_height = 0.4, .duration = 5, .tolerance = 0.01};

RunMetrics moving() {
  RunMetrics row;
  row.motion = 0.3;
  row.horizon = 5;
  row.error = row.largest_angle_difference = 1e-3;
  row.relative_position_difference = row.largest_position_difference = 0;
  return row;
}

RunMetrics resting() {
  RunMetrics row = moving();
  row.motion = 0;
  row.error = row.largest_angle_difference = 1e-17;
  return row;
}

TEST(Outcome, SaysUntilWhenARunAgrees) {
  RunMetrics row = moving();
  EXPECT_EQ(outcome(row, scale), "agrees to the end");
  row.horizon = 3;
  EXPECT_EQ(outcome(row, scale), "agrees to the horizon");
  row.largest_angle_difference = 0.02;
  row.agreement_time = 1.234;
  EXPECT_EQ(outcome(row, scale), "agrees until 1.23 s");
  row.relative_position_difference = 0.02;
  row.position_agreement_time = 0.5;
  EXPECT_EQ(outcome(row, scale), "agrees until 500 ms") << "centres part before angles";
}

// Two cubes at rest, the upper a thousand times the lower: its angles stay as they are in either engine.
TEST(Outcome, WhatRestsButSinksIsTold) {
  RunMetrics row = resting();
  EXPECT_EQ(outcome(row, scale), "rests");
  row.sinking = 0.0864;
  row.largest_position_difference = 0.13;
  row.relative_position_difference = 0.13 / 0.4;
  EXPECT_EQ(outcome(row, scale), "rests, but sinks in by 86 mm");
}

// Blocks of 0.4 m: 4 mm is the tolerance, 0.4 mm what is told where it stays.
TEST(Outcome, WhatSinksForAMomentOrRisesUnderALawOfPivotsIsTold) {
  RunMetrics row = moving();
  row.largest_position_difference = 0.3;
  row.sinking = 3e-4;
  row.penetration = 3.9e-3;
  EXPECT_EQ(event_of(row, scale), "");
  row.penetration = 0.104;
  EXPECT_EQ(event_of(row, scale), "sinks in by 100 mm for a moment");
  row.sinking = 0.06;
  EXPECT_EQ(event_of(row, scale), "sinks in by 60 mm");
  row.sinking = row.penetration = 0;
  row.gap = 0.02;
  row.law = "unilateral";
  EXPECT_EQ(event_of(row, scale), "") << "there blocks lift off in the exact motion as well";
  row.law = "paper";
  EXPECT_EQ(event_of(row, scale), "rises by 20 mm");
}

TEST(Outcome, ABlockThatLiesBesideItsBaseHasFallenOff) {
  RunMetrics row = resting();
  row.fallen = "block 2 at 1.25 s";
  row.toppling_verdict = TopplingVerdict::engine_alone;
  row.relative_position_difference = 1;
  EXPECT_EQ(outcome(row, scale), "block 2 has fallen off at 1.25 s");
}

TEST(Outcome, WhatSlidesAwayDoesNotRest) {
  RunMetrics row = resting();
  row.largest_position_difference = 0.02;
  row.relative_position_difference = 0.05;
  EXPECT_EQ(outcome(row, scale), "rests, but is 20 mm off");
}

TEST(Outcome, WhatIsThrownUpDoesNotRest) {
  RunMetrics row = resting();
  row.largest_position_difference = 1;
  row.relative_position_difference = 0.5;
  row.gap = 1;
  EXPECT_EQ(outcome(row, scale), "does not rest: rises by 1 m");
}

TEST(Outcome, ReplicatesThatToppleOtherwiseAreCounted) {
  RunMetrics row = moving();
  row.toppling_verdict = TopplingVerdict::both;
  row.draws = 21;
  row.draws_other_verdict = 3;
  EXPECT_EQ(outcome(row, scale), "agrees to the end; topples otherwise in 3 of 21 replicates");
}

TEST(Outcome, AFailureSaysWhy) {
  RunMetrics row;
  row.status = RunStatus::time_limit;
  row.reason = "60 s have passed";
  EXPECT_EQ(outcome(row, scale), "time limit: 60 s have passed");
}

}  // namespace
}  // namespace rockstack
