#include "comparisons/studies/diff/changes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <set>
#include <utility>

#include "analytic/scene/messages/input_error.hpp"

namespace rockstack {
namespace {

using Random = std::mt19937_64;

/// An engine's errors on one scene, as chance has them.
RunMetrics drawn_row(Random& random, double size) {
  std::lognormal_distribution<double> spread(std::log(size), 0.5);
  RunMetrics row;
  row.error = row.rms_angle_difference = spread(random);
  row.largest_angle_difference = 3 * *row.rms_angle_difference;
  row.agreement_time = spread(random);
  row.impacts_missed = std::poisson_distribution<int>(2)(random);
  row.warnings = 0;
  return row;
}

/// Two solvers on three scenes of unlike difficulty.
RecordedResults recorded(Random& random, std::size_t replicates) {
  RecordedResults results;
  results.folder = "recorded";
  for (const auto& [scene, size] : {std::pair{"easy", 1e-5}, {"fair", 1e-3}, {"hard", 1e-1}}) {
    for (const char* solver : {"first", "second"}) {
      RecordedRun run;
      for (std::size_t i = 0; i < replicates; ++i) run.replicates.push_back(drawn_row(random, size));
      run.row.scene = scene;
      run.row.engine = "engine";
      run.row.solver = solver;
      run.row.settings = "default";
      run.row.dt = 1e-3;
      run.row.steps = 1000;
      run.row.run = run.row.scene + "." + solver;
      results.runs.push_back(run);
    }
  }
  return results;
}

/// Results without draws.
RecordedResults single(Random& random) {
  RecordedResults results = recorded(random, 1);
  for (RecordedRun& run : results.runs) {
    run.row.rms_angle_difference = run.replicates.front().rms_angle_difference;
    run.replicates.clear();
  }
  return results;
}

std::vector<std::string> told(const ResultsChange& result) {
  std::vector<std::string> lines;
  for (const TurnedNumber& number : turned_numbers(result))
    lines.push_back(number.row->new_row.run + " " + number.change->quantity + " " +
                    name(number.change->trend));
  return lines;
}

// The exact tests are a little below the level, since chances are steps: of 200 results at most 10, that is
// 10 ± 3.1, have anything told.
TEST(Changes, OtherDrawsOfTheSameEngineAreToldNoMoreOftenThanTheLevelSays) {
  Random random(5);
  int alarms = 0;
  for (int trial = 0; trial < 200; ++trial)
    alarms += told(hold_against(recorded(random, 8), recorded(random, 8), {.level = 0.05})).empty() ? 0 : 1;
  EXPECT_LE(alarms, 19);
  EXPECT_GE(alarms, 1);
}

TEST(Changes, OneThatIsThereIsToldAndNothingElse) {
  Random random(6);
  const RecordedResults before = recorded(random, 11);
  RecordedResults now = recorded(random, 11);
  for (RunMetrics& replicate : now.runs[3].replicates) {
    *replicate.rms_angle_difference *= 10;
    *replicate.agreement_time *= 10;
  }
  const ResultsChange result = hold_against(before, now, {});
  EXPECT_EQ(told(result), (std::vector<std::string>{"fair.second rms_angle_difference worse",
                                                    "fair.second agreement_time better"}));
  EXPECT_TRUE(result.worse());
  EXPECT_FALSE(hold_against(now, now, {}).worse());
  EXPECT_EQ(result.tests, (6U + 2) * 5);  // of rows and sets; warnings never vary, and failures neither
}

TEST(Changes, ThatRoundingMakesOrThatAreLessThanAHundredthStayUntold) {
  Random random(6);
  RecordedResults before = recorded(random, 11), now = before;
  for (std::size_t i = 0; i < 11; ++i) {
    before.runs[0].replicates[i].energy_gain = 1e-16 * static_cast<double>(i);
    now.runs[0].replicates[i].energy_gain = 1e-14 * static_cast<double>(i + 1);
    before.runs[1].replicates[i].penetration = 1e-3 * (1 + 1e-6 * static_cast<double>(i));
    now.runs[1].replicates[i].penetration = 1.005e-3;
  }
  EXPECT_EQ(told(hold_against(before, now, {})), std::vector<std::string>());
  for (RunMetrics& replicate : now.runs[1].replicates) replicate.penetration = 1.02e-3;
  EXPECT_EQ(told(hold_against(before, now, {})), std::vector<std::string>{"easy.second penetration worse"});
}

TEST(Changes, DrawsThatFailAreAWorseNumberAndARowThatFailsIsWorseByItself) {
  Random random(8);
  const RecordedResults before = recorded(random, 11);
  RecordedResults now = before;
  for (std::size_t i = 1; i < 11; ++i) now.runs[0].replicates[i].status = RunStatus::not_finite;
  EXPECT_EQ(told(hold_against(before, now, {})), std::vector<std::string>{"easy.first failed worse"});
  now = before;
  now.runs[0].row.status = RunStatus::signal;
  now.runs[0].replicates.clear();
  EXPECT_EQ(told(hold_against(before, now, {})), std::vector<std::string>{"easy.first failed worse"});
  EXPECT_EQ(told(hold_against(now, before, {})), std::vector<std::string>{"easy.first failed better"});
}

TEST(Changes, OfSingleRunsAreToldByAFactorAlone) {
  Random random(9);
  const RecordedResults before = single(random);
  RecordedResults now = before;
  *now.runs[2].row.rms_angle_difference *= 3;
  const ResultsChange untold = hold_against(before, now, {});
  EXPECT_EQ(told(untold), std::vector<std::string>());
  EXPECT_EQ(untold.tests, 0U);
  EXPECT_EQ(untold.undecided.size(), 6U);
  EXPECT_TRUE(hold_against(before, now, {.single = 3.1}).undecided.empty());
  const auto by = [&](double factor) { return told(hold_against(before, now, {.single = factor})); };
  EXPECT_EQ(by(2.9), std::vector<std::string>{"fair.first rms_angle_difference worse"});
  EXPECT_EQ(by(3.1), std::vector<std::string>());
}

// Two samples of n values have 2/C(2n, n) at best: 1/126 for n = 5, 1/462 for n = 6. Errors of two rows share
// half of the level, 1/200.
TEST(Changes, TooFewReplicatesDecideNothingAndItIsSaidHowManyWould) {
  Random random(10);
  const auto one_scene = [&](std::size_t replicates) {
    RecordedResults results = recorded(random, replicates);
    results.runs = {results.runs[2], results.runs[3]};
    return results;
  };
  const ResultsChange few = hold_against(one_scene(5), one_scene(5), {});
  EXPECT_EQ(few.counted, 0U);
  EXPECT_EQ(few.undecided, (std::vector<std::string>{"fair.first", "fair.second"}));
  EXPECT_EQ(
      few.headline(),
      "Undecided: nothing is shown to be worse, but of 2 of 2 rows nothing can be said: 6 replicates in every row would do.");
  const ResultsChange enough = hold_against(one_scene(6), one_scene(6), {});
  EXPECT_TRUE(enough.undecided.empty());
  EXPECT_EQ(enough.headline(), "Nothing is worse.");
  RecordedResults same = one_scene(5);
  for (RecordedRun& run : same.runs) run.checksums["history.csv"] = "1";
  EXPECT_TRUE(hold_against(same, same, {}).undecided.empty()) << "bits say that nothing has changed";
}

// No row can show it: of three together the least chance is 2/252³.
TEST(Changes, FiveReplicatesInThreeRowsShowASetThatIsTenTimesAsFarOff) {
  Random random(14);
  const RecordedResults before = recorded(random, 5);
  RecordedResults now = recorded(random, 5);
  for (const std::size_t second : {1U, 3U, 5U})
    for (RunMetrics& replicate : now.runs[second].replicates) *replicate.error *= 10;
  const ResultsChange result = hold_against(before, now, {});
  EXPECT_EQ(told(result), std::vector<std::string>{" error worse"});
  EXPECT_TRUE(result.headline().ends_with("; over all rows together.")) << result.headline();
  EXPECT_TRUE(result.undecided.empty());
}

TEST(Changes, OfCostAreToldWhereTheRepeatsLieApart) {
  Random random(11);
  RecordedResults before = single(random);
  before.environment["processor"] = "one";
  for (RecordedRun& run : before.runs) {
    run.row.steps = 1000;
    run.row.stepping_time_minimum = 1;
    run.row.stepping_time_median = 1.1;
    run.row.stepping_time_spread = 0.3;
  }
  RecordedResults now = before;
  now.runs[1].row.stepping_time_minimum = 1.25;
  now.runs[1].row.stepping_time_median = 1.4;
  now.runs[4].row.steps = 500;
  const ChangeOptions options{.cost = 1.2};
  EXPECT_EQ(told(hold_against(before, now, options)), std::vector<std::string>{"hard.first step_time worse"});
  const ValueSpread ratio = cost_ratio(hold_against(before, now, {}));
  EXPECT_EQ(ratio.values, 6U);
  EXPECT_DOUBLE_EQ(ratio.lower, 1);
  EXPECT_DOUBLE_EQ(ratio.upper, 2);
  now.environment["processor"] = "another";
  EXPECT_EQ(cost_ratio(hold_against(before, now, options)).values, 0U);
}

TEST(Changes, RowsArePairedByWhatTheyAreOf) {
  Random random(12);
  RecordedResults before = single(random), now = before;
  now.runs[0].row.settings = now.runs[1].row.settings = "default+erp=0.2";
  const ResultsChange result = hold_against(before, now, {});
  EXPECT_EQ(result.rows.size(), 4U);
  EXPECT_EQ(result.only_old, (std::vector<std::string>{"easy.first", "easy.second"}));
  EXPECT_EQ(result.only_new, result.only_old);
  EXPECT_EQ(hold_against(before, now, {.across = {"settings"}}).rows.size(), 6U);
  EXPECT_THROW(hold_against(before, now, {.across = {"solver", "settings"}}), InputError);
  EXPECT_THROW(hold_against(before, {}, {}), InputError);

  before.scenes["fair"] = {{"gravity", "9.81"}, {"law", "\"paper\""}};
  now.scenes["fair"] = {{"gravity", "1.62"}};
  const ResultsChange other = hold_against(before, now, {.across = {"settings"}});
  EXPECT_EQ(other.rows.size(), 4U);
  EXPECT_EQ(other.other_questions, std::vector<std::string>{"scene fair: gravity"});
}

TEST(Changes, BitsAreThoseOfFilesThatBothKept) {
  Random random(13);
  RecordedResults before = single(random), now = before;
  before.runs[0].checksums = {{"history.csv", "1"}, {"events.csv", "2"}};
  now.runs[0].checksums = {{"history.csv", "1"}};
  before.runs[1].checksums = now.runs[1].checksums = {{"history.csv", "1"}};
  now.runs[1].checksums["history.csv"] = "3";
  const ResultsChange result = hold_against(before, now, {});
  EXPECT_EQ(result.rows[0].bits, "same");
  EXPECT_EQ(result.rows[1].bits, "different");
  EXPECT_EQ(result.rows[2].bits, "");
}

TEST(Changes, EveryDrawnColumnIsReportedOrFollowsFromOthers) {
  // The latter, and those that are of the exact motion alone.
  std::multiset<std::string> known{"relative_angle_difference",
                                   "relative_position_difference",
                                   "exact_peak_angle",
                                   "exact_peak_over_slenderness",
                                   "exact_peak_normal_force",
                                   "first_impact_time",
                                   "first_impact_speed",
                                   "impacts",
                                   "impacts_matched",
                                   "impacts_matched_null",
                                   "impacts_missed_null",
                                   "impacts_extra_null",
                                   "impacts_matched_random",
                                   "impacts_matched_shifted",
                                   "settlings_matched",
                                   "contact_impacts_matched",
                                   "model_share",
                                   "softness_share",
                                   "step_share",
                                   "parts_over_whole",
                                   "spring_factor"};
  for (const ReportedQuantity& quantity : reported_quantities()) known.insert(quantity.name);
  for (const Column& column : columns())
    EXPECT_EQ(known.count(column.name), column.replicated ? 1U : 0U) << column.name;
}

}  // namespace
}  // namespace rockstack
