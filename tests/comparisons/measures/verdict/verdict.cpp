#include "comparisons/measures/verdict/verdict.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <regex>

namespace rockstack {
namespace {

constexpr double height = 0.4;  // m

JudgedScene scene(const std::string& name, double duration = 5) {
  return {.name = name, .least_height = height, .duration = duration, .tolerance = 0.01};
}

/// A row of a scene that moves, with replicates within a tenth of its error (rad).
ReplicatedRow row(const std::string& scene, const std::string& settings, double dt, double error) {
  ReplicatedRow one;
  RunMetrics& row = one;
  row.scene = scene;
  row.engine = "ode";
  row.solver = "step";
  row.settings = settings;
  row.dt = dt;
  row.horizon = 5;
  row.motion = 0.3;
  row.error = row.rms_angle_difference = error;
  row.largest_angle_difference = 3 * error;
  row.rms_position_difference = row.largest_position_difference = row.relative_position_difference = 0;
  row.agreement_time = 3 * error <= 0.01 ? 5 : 0.01 / error;
  row.position_agreement_time = 5;
  row.toppling_verdict = TopplingVerdict::neither;
  for (const double part : {0.9, 0.95, 1.0, 1.05, 1.1}) one.errors.push_back(part * error);
  return one;
}

ReplicatedRow row_at_rest(const std::string& settings, double sunk = 0) {
  ReplicatedRow one = row("rest", settings, 1e-3, 1e-18);
  one.motion = 0;
  one.sinking = one.largest_position_difference = sunk;
  one.relative_position_difference = sunk / height;
  return one;
}

std::vector<std::string> headline(std::vector<ReplicatedRow> rows, const std::vector<JudgedScene>& scenes) {
  for (ReplicatedRow& one : rows) one.events = events_of({one}, scenes.front());
  return verdict_of({rows, {}, {}}, scenes).headline;
}

TEST(Verdict, OfOneSceneSaysHowLateTheFirstImpactComes) {
  ReplicatedRow exact;
  exact.scene = "a";
  exact.engine = "exact";
  exact.status = RunStatus::done;
  exact.impacts = 3;
  exact.first_impact_time = 0.3193;
  std::vector<ReplicatedRow> rows{exact, row("a", "tuned", 1e-2, 4e-3), row("a", "default", 1e-3, 1e-3)};
  rows[1].first_impact_time_difference = -4.86e-3;
  rows[2].first_impact_time_difference = 5e-4;
  rows[1].impacts_missed = 0, rows[1].impacts_extra = 0;
  rows[2].impacts_missed = 1, rows[2].impacts_extra = 2;
  EXPECT_EQ(headline(rows, {scene("a")}).at(1),
            "Engines have the first impact, at 319 ms, by step: 10 ms: 4.9 ms early; 1 ms: 0.5 ms late.");
  rows.push_back(row("a", "default", 1e-2, 5e-3));
  rows.back().first_impact_time_difference = -5.2e-3;
  rows.push_back(row("a", "other", 1e-3, 5e-3));
  rows.back().first_impact_time_difference = -2e-6;
  EXPECT_EQ(headline(rows, {scene("a")}).at(1),
            "Engines have the first impact, at 319 ms, by step: 10 ms: 4.9 to 5.2 ms early; 1 ms: 2 µs early "
            "to 0.5 ms late.");
  rows.resize(3);
  const ComparisonEvidence evidence{rows, {}, {}};
  const std::vector<std::string> sentences =
      verdict_of(evidence, std::vector<JudgedScene>{scene("a")}).scenes.at(0);
  EXPECT_NE(std::ranges::find(
                sentences,
                "Of 2 engine rows 1 has the exact sequence of impacts; the others miss up to 1 and have "
                "up to 2 extra."),
            sentences.end());
}

TEST(Verdict, NamesAWinnerWithTheScenesInWhichItWins) {
  const std::vector<std::string> told =
      headline({row("a", "tuned", 1e-3, 1e-3), row("a", "default", 1e-3, 4e-3), row("b", "tuned", 1e-3, 2e-3),
                row("b", "default", 1e-3, 2.1e-3)},
               {scene("a"), scene("b")});
  ASSERT_EQ(told.size(), 2U);
  EXPECT_EQ(
      told[1],
      "In a ode:step (tuned) is nearest to the exact motion; in b 5 replicates cannot tell which set is nearest; over these 2 scenes ode:step (default) is furthest: 2 times the least error of a scene and step, in the geometric mean.");
  EXPECT_EQ(
      told[0],
      "Engines leave the exact motion at a time step of 1 ms after 2.5 s or not at all; to leave it is to be off by more than 10 mrad or 1 % of the least block height, in the median of replicates.");
}

// The ranking of a whole scene of 25 s went by what lay beyond 5.86 s.
TEST(Verdict, SaysHowFarHistoriesAreCompared) {
  std::vector<ReplicatedRow> rows{row("a", "tuned", 1e-3, 1e-3), row("a", "default", 1e-3, 1.5e-3)};
  for (ReplicatedRow& one : rows) one.horizon = 3;
  const auto told = headline(rows, {scene("a")});
  EXPECT_EQ(
      told[0],
      "Engines leave the exact motion at a time step of 1 ms not before the horizon (the horizon: 3 s in a); to leave it is to be off by more than 10 mrad or 1 % of the least block height, in the median of replicates.");
}

TEST(Verdict, ScenesAtRestAreToldByWhatHappensInThem) {
  const auto told = headline({row_at_rest("tuned"), row_at_rest("default", 0.086)}, {scene("rest")});
  ASSERT_EQ(told.size(), 2U);
  EXPECT_EQ(told[1], "Nothing moves in rest, where no set is ranked.");
  EXPECT_EQ(told[0], "With ode:step (default) in rest at 1 ms a block sinks in by 86 mm.");
  for (const std::string& sentence : told) EXPECT_EQ(sentence.find("nearest"), std::string::npos);
}

TEST(Verdict, ABlockThatFallsOffIsTold) {
  std::vector<ReplicatedRow> rows{row("a", "tuned", 1e-3, 1e-3), row("a", "default", 1e-3, 1.5e-3)};
  rows[0].toppling_verdict = TopplingVerdict::engine_alone;
  rows[0].fallen = "block 2 at 0.43 s";
  const auto told = headline(rows, {scene("a")});
  ASSERT_EQ(told.size(), 3U);
  EXPECT_EQ(told[1], "With ode:step (tuned) in a at 1 ms block 2 has fallen off at 430 ms.");
}

TEST(Verdict, ASetThatFailsIsNeitherNearestNorToldByItsErrors) {
  std::vector<ReplicatedRow> rows{row("a", "tuned", 1e-3, 1e-3), row("a", "default", 1e-3, 1.1e-3)};
  rows[0].status = RunStatus::failed;
  rows[0].error.reset();
  rows[0].errors = {INFINITY};
  EXPECT_EQ(headline(rows, {scene("a")})[1],
            "Ode:step (default) is nearest to the exact motion; ode:step (tuned) fails in 1 run.");
}

TEST(Verdict, OfSeveralExactMotionsItIsToldThatThereAre) {
  std::vector<ReplicatedRow> rows{row("a", "tuned", 1e-3, 1e-3), row("a", "default", 1e-3, 1.5e-3)};
  ReplicatedRow exact;
  exact.scene = "a";
  exact.engine = "exact";
  exact.outcome = "from 0 s on one of several motions that obey";
  rows.insert(rows.begin(), exact);
  EXPECT_NE(headline(rows, {scene("a")})[0].find(
                "In a the exact motion is from 0 s on one of several motions that obey"),
            std::string::npos);
}

TEST(Verdict, OfSpringsItIsToldThatEnginesDoNotHaveThem) {
  std::vector<ReplicatedRow> rows = {row("a", "one", 1e-3, 1e-3)};
  ReplicatedRow exact;
  exact.scene = "a";
  exact.engine = "exact";
  exact.law = "compliant";
  rows.insert(rows.begin(), exact);
  EXPECT_EQ(headline(rows, {scene("a")})[0].rfind(
                "In a the exact motion stands on springs that engines do not have; engines ", 0),
            0U)
      << headline(rows, {scene("a")})[0];
}

TEST(Verdict, SetsThatShareTheLastRankAreFurthestTogether) {
  EXPECT_EQ(
      headline({row("a", "best", 1e-3, 1e-3), row("a", "good", 1e-3, 1e-3), row("a", "bad", 1e-3, 1e-2),
                row("a", "poor", 1e-3, 1e-2)},
               {scene("a")})[1],
      "Ode:step (best) and ode:step (good) are nearest, which 5 replicates cannot tell apart; furthest are "
      "ode:step (bad) and ode:step (poor): 2 of the 3 other sets are nearer.");
}

TEST(Verdict, OfManySetsSaysInWhichBlocksSinkAndInWhichTheyFall) {
  std::vector<ReplicatedRow> rows;
  for (int i = 0; i < 4; ++i)
    rows.push_back(row_at_rest("set" + std::to_string(i), i < 3 ? 0.01 + 0.02 * i : 0));
  rows[3].toppling_verdict = TopplingVerdict::engine_alone;
  rows[3].fallen = "block 2 at 0.43 s";
  EXPECT_EQ(
      headline(rows, {scene("rest")})[0],
      "With ode:step (set3), blocks fall or topple that do not in the exact motion; with ode:step (set0) and 2 others, blocks sink in, by 50 mm at most.");
}

TEST(Verdict, OfASetTheGravestOfAnyRowIsToldAndTheMostOfAll) {
  std::vector<ReplicatedRow> rows;
  for (int i = 0; i < 4; ++i) rows.push_back(row("a", "set" + std::to_string(i), 1e-3, 1e-3));
  for (ReplicatedRow& one : rows) one.rise = 0.02;
  // At a larger step the first set is less near and hovers, and is thrown up higher at a smaller one.
  rows.push_back(row("a", "set0", 1e-2, 0.1));
  rows.back().hover = rows.back().largest_position_difference = 0.015;
  rows.push_back(row("a", "set1", 1e-4, 1e-4));
  rows.back().rise = 0.14;
  EXPECT_EQ(headline(rows, {scene("a")})[1],
            "With ode:step (set0) and 3 others, blocks are thrown up, by 140 mm at most.");
}

TEST(Verdict, SetsThatFailAreNotSaidToBeFurthest) {
  std::vector<ReplicatedRow> rows{row("a", "best", 1e-3, 1e-3), row("a", "other", 1e-3, 1e-2),
                                  row("a", "one", 1e-3, 1e-3), row("a", "two", 1e-3, 1e-3)};
  for (std::size_t i : {2U, 3U}) {
    rows[i].status = RunStatus::failed;
    rows[i].error.reset();
    rows[i].errors = {INFINITY};
  }
  const auto told = headline(rows, {scene("a")});
  EXPECT_NE(told.back().find("ode:step (one) and ode:step (two) fail in 2 runs"), std::string::npos)
      << told.back();
}

TEST(Verdict, WhatMovesWhereNothingShouldIsTold) {
  std::vector<ReplicatedRow> rows{row_at_rest("tuned"), row_at_rest("default")};
  rows[1].largest_position_difference = 0.5;
  rows[1].relative_position_difference = 0.5 / height;
  rows[1].offset = 0.5;
  const auto told = headline(rows, {scene("rest")});
  ASSERT_EQ(told.size(), 2U);
  EXPECT_EQ(told[0], "With ode:step (default) in rest at 1 ms a block is 500 mm off at the end.");
  EXPECT_EQ(told[1], "Nothing moves in rest, where no set is ranked.");
}

TEST(Verdict, SaysHowFewAndHowManyReplicatesThereAre) {
  std::vector<ReplicatedRow> rows{row("a", "tuned", 1e-2, 1e-3), row("a", "default", 1e-2, 1.1e-3),
                                  row("a", "tuned", 1e-3, 1e-3), row("a", "default", 1e-3, 1.1e-3)};
  for (std::size_t i : {2U, 3U}) rows[i].errors.resize(3);
  EXPECT_EQ(headline(rows, {scene("a")})[1],
            "Over all steps together 3 to 5 replicates cannot tell which set is nearest.");
}

// One set that parts at once says nothing of a dozen others.
TEST(Verdict, OfManySetsSaysHowManyLeaveAndByWhenHalfOfAllHave) {
  const auto said_where = [](int leave) {
    std::vector<ReplicatedRow> rows;
    for (int i = 0; i < 12; ++i)
      rows.push_back(row("a", "set" + std::to_string(i), 1e-2, i >= leave ? 0.001 : i == 0 ? 1 : 0.005));
    return headline(rows, {scene("a")})[0];
  };
  const std::string many = said_where(7), few = said_where(5);
  EXPECT_NE(many.find("at a time step of 10 ms in 7 of 12 runs, half of the 12 by 2 s; to leave"),
            std::string::npos)
      << many;
  EXPECT_NE(few.find("at a time step of 10 ms in 5 of 12 runs; to leave"), std::string::npos) << few;
}

// Replicates tell the sets apart at either step, but the other way about: over both they are as near.
TEST(Verdict, NamesWhoIsNearestAtEachStepWhereTheStepDecides) {
  const std::vector<ReplicatedRow> rows{row("a", "tuned", 1e-2, 4e-3), row("a", "default", 1e-2, 1e-3),
                                        row("a", "tuned", 1e-3, 1e-4), row("a", "default", 1e-3, 1e-3)};
  EXPECT_EQ(
      headline(rows, {scene("a")})[1],
      "Over all steps together 5 replicates cannot tell which set is nearest, but at 10 ms it is ode:step (default) and at 1 ms it is ode:step (tuned) alone.");
}

TEST(Verdict, SaysNothingByASingleRunWhereOthersHaveReplicates) {
  std::vector<ReplicatedRow> rows{row("a", "tuned", 1e-2, 1e-3), row("a", "default", 1e-2, 1.1e-3),
                                  row("a", "tuned", 1e-3, 1e-3), row("a", "default", 1e-3, 1)};
  for (std::size_t i : {2U, 3U}) rows[i].errors.resize(1);
  EXPECT_EQ(headline(rows, {scene("a")})[1], "5 replicates cannot tell which set is nearest.");
}

TEST(Verdict, OfOneRunEachNothingIsToldApart) {
  std::vector<ReplicatedRow> rows{row("a", "tuned", 1e-3, 1e-3), row("a", "default", 1e-3, 1)};
  for (ReplicatedRow& one : rows) one.errors.resize(1);
  EXPECT_EQ(headline(rows, {scene("a")})[1], "One run each cannot tell which set is nearest.");
}

/// Whether any sentence of a verdict calls a set nearer than others.
bool names_a_winner(const ComparisonVerdict& verdict) {
  const std::regex winner("\\) is (nearest|furthest)|are nearest|furthest (is|are)");
  const auto names = [&](const std::vector<std::string>& sentences) {
    return std::any_of(sentences.begin(), sentences.end(),
                       [&](const std::string& one) { return std::regex_search(one, winner); });
  };
  return names(verdict.headline) || std::any_of(verdict.scenes.begin(), verdict.scenes.end(), names);
}

/// Rows of four sets in two scenes at two steps, replicates drawn from distributions with these medians.
std::vector<ReplicatedRow> drawn_rows(std::mt19937_64& random, const std::vector<double>& medians) {
  std::lognormal_distribution<double> spread(0, 1);
  std::vector<ReplicatedRow> rows;
  for (const char* name : {"a", "b"})
    for (const double dt : {1e-2, 1e-3})
      for (std::size_t i = 0; i < medians.size(); ++i) {
        rows.push_back(row(name, "set " + std::to_string(i), dt, 1e-3));
        std::vector<double>& errors = rows.back().errors;
        errors.clear();
        for (int k = 0; k < 9; ++k) errors.push_back(medians[i] * spread(random));
        std::vector<double> sorted = errors;
        std::nth_element(sorted.begin(), sorted.begin() + 4, sorted.end());
        rows.back().error = sorted[4];
      }
  return rows;
}

// Three rankings, of either scene and of both, each at a level of 5 %: of 100 verdicts over sets that are
// alike 15 name a winner at most, and chance adds 2.5 deviations of 3.6. Sets that are ten times apart are
// ranked every time.
TEST(Verdict, NothingIsRankedApartFromSeparation) {
  std::mt19937_64 random(5);
  const std::vector<JudgedScene> scenes{scene("a"), scene("b")};
  int alike = 0;
  for (int trial = 0; trial < 100; ++trial)
    alike +=
        names_a_winner(verdict_of({drawn_rows(random, {1e-3, 1e-3, 1e-3, 1e-3}), {}, {}}, scenes)) ? 1 : 0;
  EXPECT_LE(alike, 24);
  for (int trial = 0; trial < 20; ++trial)
    EXPECT_TRUE(names_a_winner(verdict_of({drawn_rows(random, {1e-4, 1e-3, 1e-2, 1e-1}), {}, {}}, scenes)));
}

}  // namespace
}  // namespace rockstack
