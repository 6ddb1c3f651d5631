#include "comparisons/studies/advise/advise.hpp"

#include <gtest/gtest.h>

namespace rockstack {
namespace {

Trial timed(int within, double seconds) {
  Trial trial;
  trial.row.stepping_time_minimum = seconds;
  trial.within = within;
  trial.replicates = 21;
  return trial;
}

// Nine of ten: 19 of 21.
TEST(Advice, IsTheCheapestOfThoseThatPassInNineDrawsOfTen) {
  EXPECT_EQ(cheapest({timed(18, 1), timed(19, 3), timed(21, 2), timed(20, 4)}), 2);
  EXPECT_EQ(cheapest({timed(18, 1)}), -1);
}

TEST(Advice, IsConfirmedByDrawsThatDidNotChooseIt) {
  Trial lucky = timed(20, 1), held = timed(19, 2);
  lucky.confirming = held.confirming = 20;
  lucky.confirmed = 17;
  held.confirmed = 18;
  EXPECT_EQ(cheapest({lucky, held}), 1);
}

TEST(Advice, ADrawThatSinksMissesTheErrorWhateverItsAngles) {
  RunMetrics row;
  row.largest_angle_difference = 0;
  row.toppling_verdict = TopplingVerdict::neither;
  row.relative_position_difference = 0.22;
  EXPECT_FALSE(meets(row, 1e-3));
  row.relative_position_difference = 1e-3;
  EXPECT_TRUE(meets(row, 1e-3));
}

TEST(Advice, ADrawMeetsTheErrorWhereItIsDoneNearAndTopplesLikewise) {
  RunMetrics row;
  row.largest_angle_difference = 1e-4;
  row.toppling_verdict = TopplingVerdict::engine_alone;
  EXPECT_FALSE(meets(row, 1e-3));
  row.toppling_verdict = TopplingVerdict::both;
  EXPECT_TRUE(meets(row, 1e-3));
  EXPECT_FALSE(meets(row, 1e-5));
  row.status = RunStatus::time_limit;
  EXPECT_FALSE(meets(row, 1e-3));
}

}  // namespace
}  // namespace rockstack
