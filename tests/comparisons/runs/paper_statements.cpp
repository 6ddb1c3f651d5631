#include "comparisons/runs/paper_statements.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>

#include "analytic/solve.hpp"
#include "comparisons/measures/metrics/motion_verdict.hpp"
#include "tests/free_rocking.hpp"

namespace rockstack {
namespace {

/// θ = 0.1 e^(−t) cos 2πt, sampled every millisecond for two seconds.
History decaying() {
  History history;
  history.blocks = 1;
  for (int i = 0; i <= 2000; ++i) {
    const double t = 1e-3 * i;
    history.times.push_back(t);
    history.angles.push_back(0.1 * std::exp(-t) * std::cos(2 * std::numbers::pi * t));
    history.velocities.push_back(0);
  }
  return history;
}

TEST(Swings, EndWhereTheSideChanges) {
  const auto list = swings(decaying(), 0);
  ASSERT_EQ(list.size(), 5u);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(list[i].end, 0.25 + 0.5 * static_cast<double>(i), 1.001e-3);
  // Extremes lie where tan 2πt = −1/2π.
  const double lead = std::atan(1 / (2 * std::numbers::pi)) / (2 * std::numbers::pi);
  EXPECT_NEAR(list[1].peak_time, 0.5 - lead, 1e-3);
  EXPECT_EQ(largest_swing(decaying(), 0).peak, 0.1);
}

TEST(Swings, AnglesBetweenSamplesLieOnStraightLines) {
  const History history = decaying();
  EXPECT_NEAR(angle_at(history, 0, 0.25), history.angles[250], 1e-17);
  EXPECT_NEAR(angle_at(history, 0, 0.2505), 0.5 * (history.angles[250] + history.angles[251]), 1e-17);
}

/// The paper's two examples without engines; the second under a strong half-sine in place of a record.
Evidence evidence() {
  const Scene free = free_rocking(5);
  Scene shaken = free;
  shaken.initial = {{0, 0}, {0, 0}};
  shaken.horizontal = {0.5, {0, 7.0, -7.0, 0}, "a zigzag", true};
  const auto answer = [](const Scene& scene) {
    return std::vector<Answer>{
        {"exact", solve(scene, {.sample_times = regular_times(1e-3, scene.duration)})}};
  };
  Scene linear = free;
  linear.equations = Equations::linear;
  return {free, answer(free), solve(linear, {.sample_times = regular_times(1e-3, free.duration)}), shaken,
          answer(shaken)};
}

TEST(Statements, OfTheFreeExampleAreDecidedByTheSolution) {
  std::map<std::string, Verdict> verdicts;
  for (const Statement& statement : judge(evidence())) {
    EXPECT_TRUE(verdicts.emplace(statement.claim, statement.verdict).second);
    EXPECT_FALSE(statement.criterion.empty());
    EXPECT_FALSE(statement.computed.empty());
  }
  ASSERT_EQ(verdicts.size(), 14u);
  EXPECT_EQ(verdicts.at("The stack turns as one body until the base meets the ground."), Verdict::fails);
  EXPECT_EQ(verdicts.at("In free rocking, patterns change by impact alone."), Verdict::fails);
  EXPECT_EQ(verdicts.at("The first impact increases the angular velocity of the top block."), Verdict::holds);
  EXPECT_EQ(verdicts.at("The top block's swings get smaller, except the second."), Verdict::holds);
}

TEST(Statements, OfTheRecordStayOpenUnderAMadeUpMotion) {
  Evidence made_up = evidence();
  for (const Statement& statement : judge(made_up)) {
    EXPECT_EQ(statement.verdict == Verdict::undecidable, statement.source == "Fig. 22") << statement.claim;
  }
  made_up.shaken.horizontal.made_up = false;
  for (const Statement& statement : judge(made_up)) EXPECT_NE(statement.verdict, Verdict::undecidable);
}

TEST(Statements, FollowTheMotionThatTheyAreAbout) {
  // A stack that never separates: the claim about turning as one body then holds.
  Evidence squat = evidence();
  squat.free.blocks = {make_block(1.25, 1.25, 2500), make_block(1.25, 0.1, 2500)};
  squat.free_answers.front().history = solve(squat.free, {.sample_times = regular_times(1e-3, 5)});
  squat.free_linear = squat.free_answers.front().history;
  const auto statements = judge(squat);
  EXPECT_EQ(statements.front().verdict, Verdict::holds) << statements.front().computed;
}

TEST(PaperStatements, AreNotHeldAgainstScenesThatDoSomethingElse) {
  const auto verdict_of = [](const Evidence& given) {
    const std::vector<Statement> told = judge(given);
    EXPECT_EQ(told.size(), 1U);
    EXPECT_EQ(told.front().verdict, Verdict::undecidable);
    return told.front().computed;
  };
  Evidence cut = evidence();
  cut.free.duration = 0.2;
  cut.free_answers[0].history = solve(cut.free, {.sample_times = regular_times(1e-3, cut.free.duration)});
  EXPECT_EQ(verdict_of(cut), "in the free scene no block lands on the ground");
  Evidence still = evidence();
  for (double& angle : still.shaken_answers[0].history.angles) angle = 0;
  EXPECT_EQ(verdict_of(still), "in the shaken scene not both blocks rock");
  Evidence pulse = evidence();
  pulse.shaken.horizontal.samples.clear();
  EXPECT_EQ(verdict_of(pulse), "the shaken scene has no record");
}

}  // namespace
}  // namespace rockstack
