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

std::string told(const std::vector<RunMetrics>& runs) {
  std::string text;
  for (const RowEvent& event : events_of(runs, scale)) text += event.text;
  return text;
}

TEST(Outcome, SaysUntilWhenARunAgrees) {
  RunMetrics row = moving();
  EXPECT_EQ(outcome({row}, scale), "agrees to the end");
  row.horizon = 3;
  EXPECT_EQ(outcome({row}, scale), "agrees to the horizon");
  row.largest_angle_difference = 0.02;
  row.agreement_time = 1.234;
  EXPECT_EQ(outcome({row}, scale), "agrees until 1.23 s");
  row.relative_position_difference = 0.02;
  row.position_agreement_time = 0.5;
  EXPECT_EQ(outcome({row}, scale), "agrees until 500 ms") << "centres part before angles";
}

TEST(Outcome, WhatGoesElsewhereInMotionIsTold) {
  RunMetrics row = moving();
  row.relative_position_difference = 10;
  row.position_agreement_time = 0.07;
  row.largest_position_difference = 4.24;
  EXPECT_EQ(outcome({row}, scale), "agrees until 70 ms, then up to 4.2 m off");
  row.largest_position_difference = 0.1;
  EXPECT_EQ(outcome({row}, scale), "agrees until 70 ms");
}

// Blocks of 0.4 m that fall in both motions.
TEST(Outcome, WhatFallsAsItShouldMayHaveBeenThrownUpBefore) {
  RunMetrics row = moving();
  row.toppling_verdict = TopplingVerdict::both;
  row.rise = 0.03;
  EXPECT_EQ(told({row}), "");
  row.rise = 0.46;
  EXPECT_EQ(told({row}), "is thrown up by 460 mm");
}

// Two cubes at rest, the upper a thousand times the lower: its angles stay as they are in either engine.
TEST(Outcome, WhatRestsButSinksIsTold) {
  RunMetrics row = resting();
  EXPECT_EQ(outcome({row}, scale), "rests");
  row.sinking = 0.0864;
  row.largest_position_difference = 0.13;
  row.relative_position_difference = 0.13 / 0.4;
  EXPECT_EQ(outcome({row}, scale), "rests, but sinks in by 86 mm");
}

// Blocks of 0.4 m: 4 mm is the tolerance, 0.4 mm what is told where it stays.
TEST(Outcome, WhatSinksForAMomentOrRisesHigherThanExactlyIsTold) {
  RunMetrics row = moving();
  row.largest_position_difference = 0.3;
  row.sinking = 3e-4;
  row.penetration = 3.9e-3;
  EXPECT_EQ(told({row}), "");
  row.penetration = 0.104;
  EXPECT_EQ(told({row}), "sinks in by 100 mm for a moment");
  row.sinking = 0.06;
  EXPECT_EQ(told({row}), "sinks in by 60 mm");
  row.sinking = row.penetration = 0;
  row.rise = 0.003;
  EXPECT_EQ(told({row}), "");
  row.rise = 0.02;
  EXPECT_EQ(told({row}), "is thrown up by 20 mm");
}

// A tilt of 0.02 moves the end of 0.4 m by 8 mm; 4 mm is the tolerance.
TEST(Outcome, WhatLeavesThePlaneIsTold) {
  RunMetrics row = moving();
  row.out_of_plane = 0.003;
  row.out_of_plane_tilt = 0.005;
  EXPECT_EQ(told({row}), "");
  row.out_of_plane_tilt = 0.02;
  EXPECT_EQ(told({row}), "leaves the plane by 8 mm");
  row.out_of_plane = 0.05;
  EXPECT_EQ(told({row}), "leaves the plane by 50 mm");
  row.toppling_verdict = TopplingVerdict::both;
  EXPECT_EQ(told({row}), "leaves the plane by 50 mm") << "as it falls";
}

TEST(Outcome, ABlockThatTopplesWhereTheExactOneWouldLaterIsTold) {
  RunMetrics row = moving();
  row.largest_angle_difference = 0.12;
  row.agreement_time = 0.919;
  row.toppled = "block 1 at 1.367 s";
  row.turn = 1;
  EXPECT_EQ(outcome({row}, scale), "agrees until 919 ms; block 1 topples at 1.37 s");
}

TEST(Outcome, ABlockThatLiesBesideItsBaseHasFallenOff) {
  RunMetrics row = resting();
  row.fallen = "block 2 at 1.25 s";
  row.toppling_verdict = TopplingVerdict::engine_alone;
  row.relative_position_difference = 1;
  EXPECT_EQ(outcome({row}, scale), "block 2 has fallen off at 1.25 s");
}

TEST(Outcome, WhatSlidesAwayDoesNotRest) {
  RunMetrics row = resting();
  row.largest_position_difference = 0.02;
  row.relative_position_difference = 0.05;
  row.offset = 0.001;
  EXPECT_EQ(outcome({row}, scale), "moves by 20 mm for a while");
  row.offset = 0.02;
  EXPECT_EQ(outcome({row}, scale), "rests, but is 20 mm off at the end");
  row.creep = 7.1e-3;
  EXPECT_EQ(outcome({row}, scale), "creeps at 7.1 mm/s to the end");
}

// Where the block is at the end is graver than how fast it still goes.
TEST(Outcome, WhatEndsFarOffIsToldBeforeItsCreep) {
  RunMetrics row = resting();
  row.largest_position_difference = row.offset = 0.34;
  row.relative_position_difference = 0.34 / 0.4;
  row.sinking = 4e-4;
  row.creep = 5.2e-4;
  EXPECT_EQ(outcome({row}, scale), "is 340 mm off at the end; creeps at 0.52 mm/s to the end");
}

// Places are compared up to the horizon alone, and no motion lies in what it stands on.
TEST(Outcome, WhatSinksInBeyondTheHorizonIsTold) {
  RunMetrics row = moving();
  row.horizon = 0.144;
  row.sinking = 0.026;
  EXPECT_EQ(outcome({row}, scale), "agrees to the horizon; sinks in by 26 mm");
}

TEST(Outcome, WhatIsThrownUpDoesNotRest) {
  RunMetrics row = resting();
  row.largest_position_difference = 1;
  row.relative_position_difference = 0.5;
  row.rise = 1;
  row.sinking = 0.017;
  EXPECT_EQ(outcome({row}, scale), "is thrown up by 1 m; sinks in by 17 mm");
}

TEST(Outcome, WhatStaysAboveItsBaseHovers) {
  RunMetrics row = resting();
  row.largest_position_difference = row.offset = row.rise = row.hover = 0.015;
  row.relative_position_difference = 0.015 / 0.4;
  EXPECT_EQ(outcome({row}, scale), "rests, but hovers 15 mm high");
}

// A median of five says nothing of two, and may be that of none.
TEST(Outcome, WhatHappensInSomeReplicatesIsCounted) {
  std::vector<RunMetrics> runs(5, resting());
  for (std::size_t i = 1; i < 5; ++i) {
    runs[i].rise = 0.25 * static_cast<double>(i);
    runs[i].largest_position_difference = runs[i].rise;
  }
  EXPECT_EQ(outcome(runs, scale), "is thrown up by 250 mm to 1 m in 4 of 5 replicates");
  runs.assign(5, moving());
  for (std::size_t i = 0; i < 2; ++i) {
    runs[i].largest_angle_difference = 0.02;
    runs[i].agreement_time = 0.35;
  }
  EXPECT_EQ(outcome(runs, scale), "agrees to the end in 3 of 5 replicates");
  runs[2] = runs[1];
  EXPECT_EQ(outcome(runs, scale), "agrees until 350 ms, to the end in 2 of 5 replicates");
}

TEST(Outcome, ReplicatesThatToppleOtherwiseAreCounted) {
  RunMetrics row = moving();
  row.toppling_verdict = TopplingVerdict::both;
  std::vector<RunMetrics> runs(21, row);
  for (std::size_t i = 1; i < 4; ++i) {
    runs[i].toppling_verdict = TopplingVerdict::engine_alone;
    runs[i].toppled = "block 1 at 1.25 s";
  }
  EXPECT_EQ(outcome(runs, scale), "agrees to the end; block 1 topples at 1.25 s in 3 of 21 replicates");
  runs[4].status = RunStatus::failed;
  EXPECT_EQ(
      outcome(runs, scale),
      "agrees to the end in 20 of 21 replicates; fails in 1 of 21 replicates; block 1 topples at 1.25 s in 3 of 21 replicates");
}

TEST(Outcome, AFailureSaysWhy) {
  RunMetrics row;
  row.status = RunStatus::time_limit;
  row.reason = "60 s have passed";
  EXPECT_EQ(outcome({row}, scale), "time limit: 60 s have passed");
}

}  // namespace
}  // namespace rockstack
