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

/// A solver of one engine that is off by so much at a step of 1 ms.
Trial tried(const std::string& solver, double off) {
  Trial trial = timed(20, 1);
  trial.row.engine = "own";
  trial.row.solver = solver;
  trial.row.dt = 1e-3;
  trial.row.largest_angle_difference = off;
  trial.confirming = 20;
  trial.confirmed = 19;
  return trial;
}

TEST(Advice, SaysWhatToTakeHowSureItIsAndUntilWhenItHolds) {
  WorkerEngine engine;
  engine.name = "own";
  engine.solver = "two";
  const Advice advice{{tried("one", 2e-3)}, 0, {{&engine, 2e-3}}, 2.5, {}};
  const std::vector<std::string> told = advice_sentences({.error = 0.01}, advice, 5);
  ASSERT_EQ(told.size(), 4U);
  EXPECT_EQ(
      told[0],
      "Take own:one at 1 ms with tuned settings: of all that was tried the cheapest that stays within 10 mrad of the exact angles and 1 % of the least block height of the exact centres.");
  EXPECT_EQ(told[1], "39 of 41 replicates at nearby steps are within; nine of ten must be.");
  EXPECT_EQ(told[2], "This holds until 2.5 s, the horizon of predictability.");
  EXPECT_EQ(told[3], "In 60 s the search has not come to smaller steps of own:two; --within gives it more.");
  EXPECT_EQ(advice_sentences({.error = 0.01}, advice, 2.5).size(), 3U);
}

// 18 of 21 are turned down where 19 are not: chance makes that difference in two cases of three.
TEST(Advice, NamesTheCheaperTrialThatCannotBeToldFromThePick) {
  Trial pick = tried("one", 2e-3), other = tried("two", 3e-3);
  pick.row.stepping_time_minimum = 2;
  other.row.stepping_time_minimum = 1;
  other.replicates = 21, other.within = 18;
  other.confirming = other.confirmed = 0;
  const auto told = [&] { return advice_sentences({.error = 0.01}, {{other, pick}, 1, {}, 5, {}}, 5); };
  ASSERT_EQ(told().size(), 3U);
  EXPECT_EQ(
      told()[2],
      "Own:two at 1 ms is cheaper and was turned down, with 18 of 21 within: replicates cannot tell it from the one advised.");
  other.within = 9;
  EXPECT_EQ(told().size(), 2U) << "of 21 and 21 that is less than chance gives in one case of twenty";
  other.within = other.replicates = 1;
  other.row.stepping_time_minimum = 3;
  EXPECT_EQ(told().size(), 2U) << "it costs more";
}

TEST(Advice, NamesTheNearestWhereNoneHolds) {
  const Advice advice{{tried("one", 0.1), tried("two", 0.05)}, -1, {}, 5, {}};
  const std::vector<std::string> told = advice_sentences({.error = 0.01}, advice, 5);
  ASSERT_EQ(told.size(), 1U);
  EXPECT_NE(told[0].find("The nearest is own:two at 1 ms, off by 0.05."), std::string::npos) << told[0];
}

}  // namespace
}  // namespace rockstack
