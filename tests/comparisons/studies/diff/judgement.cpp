#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <random>

#include "comparisons/studies/diff/changes.hpp"

namespace rockstack {
namespace {

using Noise = std::mt19937_64;

/// A run of an engine with chance in every number that is reported.
RunMetrics noisy_row(Noise& noise) {
  std::lognormal_distribution<double> size(std::log(1e-3), 0.5);
  std::poisson_distribution<int> count(2);
  RunMetrics row;
  for (const Column& column : columns())
    if (column.replicated)
      column.set(row, std::holds_alternative<std::optional<int> RunMetrics::*>(column.field)
                          ? Json(count(noise))
                          : Json(size(noise)));
  row.toppling_verdict = TopplingVerdict::neither;
  return row;
}

/// An exact motion, and an engine beside it on so many scenes.
RecordedResults noisy(Noise& noise, std::size_t replicates, std::size_t scenes = 1) {
  RecordedResults results;
  results.folder = "noisy";
  RecordedRun exact;
  exact.row.engine = exact.row.run = "exact";
  results.runs.push_back(exact);
  for (std::size_t scene = 0; scene < scenes; ++scene) {
    RecordedRun run;
    for (std::size_t i = 0; i < replicates; ++i) run.replicates.push_back(noisy_row(noise));
    run.row = run.replicates.front();
    run.row.scene = "scene" + std::to_string(scene);
    run.row.engine = "engine";
    run.row.solver = "solver";
    run.row.settings = "default";
    run.row.dt = 1e-3;
    run.row.steps = 1000;
    run.row.run = run.row.scene + ".engine";
    results.runs.push_back(run);
  }
  return results;
}

ResultsChange held_with_sinking(std::size_t replicates, double factor) {
  Noise noise(3);
  const RecordedResults before = noisy(noise, replicates);
  RecordedResults now = noisy(noise, replicates);
  for (RunMetrics& replicate : now.runs[1].replicates) *replicate.sinking *= factor;
  return hold_against(before, now, {});
}

// By itself each of fifty numbers of six replicates has 2/924 at best, fifty times what is left of the level.
TEST(Judgement, SixReplicatesShowWhichOfFiftyNumbersIsAHundredTimesAsLarge) {
  const ResultsChange result = held_with_sinking(6, 100);
  ASSERT_EQ(turned_numbers(result).size(), 1U);
  EXPECT_EQ(turned_numbers(result).front().change->quantity, "sinking");
  const QuantityChange& sinking = *turned_numbers(result).front().change;
  EXPECT_EQ(result.headline(),
            "Worse: engine:solver (default): sinking " + change_text(sinking) + "; 1 of 1 row worse.");
  EXPECT_EQ(result.counted, result.tests);
}

TEST(Judgement, ANumberThatIsWorseInEveryReplicateOfTooFewIsUndecidedAndItIsSaidHowManyDecide) {
  const ResultsChange few = held_with_sinking(5, 100);
  EXPECT_FALSE(few.worse());
  EXPECT_EQ(few.in_doubt, std::vector<std::string>{"sinking of scene0.engine"});
  EXPECT_EQ(few.replicates_needed, 9);
  EXPECT_NE(few.headline().find("looks worse (sinking of scene0.engine): 9 replicates in every row would do"),
            std::string::npos)
      << few.headline();
  EXPECT_TRUE(held_with_sinking(9, 100).worse());

  Noise noise(4);
  RecordedResults before = noisy(noise, 6), now = noisy(noise, 6);
  for (std::size_t i = 0; i < 6; ++i) {
    before.runs[1].replicates[i].sinking = 1e-3 * static_cast<double>(20 + i);
    now.runs[1].replicates[i].sinking = 1e-3 * static_cast<double>(26 + i);
  }
  const ResultsChange barely = hold_against(before, now, {});
  EXPECT_FALSE(barely.worse());
  EXPECT_EQ(barely.in_doubt, std::vector<std::string>{"sinking of scene0.engine"});
  EXPECT_FALSE(barely.decided());
  EXPECT_TRUE(hold_against(now, before, {}).in_doubt.empty()) << "what looks better leaves nothing open";
}

TEST(Judgement, OneRowOfASetThatIsTenTimesWorseIsUndecidedWhereItsReplicatesAreTooFew) {
  Noise noise(5);
  const RecordedResults before = noisy(noise, 5, 4);
  RecordedResults now = noisy(noise, 5, 4);
  EXPECT_TRUE(hold_against(before, now, {}).decided());
  for (RunMetrics& replicate : now.runs[2].replicates) *replicate.hover *= 100;
  const ResultsChange result = hold_against(before, now, {});
  EXPECT_FALSE(result.worse());
  EXPECT_EQ(result.in_doubt, std::vector<std::string>{"hover of scene1.engine"});
}

TEST(Judgement, ANumberThatIsFarWorseInMostReplicatesIsUndecided) {
  Noise noise(6);
  const RecordedResults before = noisy(noise, 5, 4);
  RecordedResults now = before;
  for (std::size_t i = 0; i < 4; ++i) *now.runs[2].replicates[i].rms_angle_difference = 0.4;
  const ResultsChange result = hold_against(before, now, {});
  EXPECT_FALSE(result.worse());
  EXPECT_EQ(result.in_doubt, std::vector<std::string>{"rms_angle_difference of scene1.engine"});
  EXPECT_TRUE(hold_against(now, before, {}).decided()) << "what is better leaves nothing open";
}

TEST(Judgement, AQuantityThatNoRowHasAnyMoreLeavesItUndecided) {
  Noise noise(11);
  const RecordedResults before = noisy(noise, 6, 2);
  RecordedResults now = before;
  for (RecordedRun& run : now.runs) run.row.sinking.reset();
  EXPECT_EQ(hold_against(before, now, {}).headline(),
            "Undecided: nothing is shown to be worse, but what was judged before is judged no more "
            "(sinking of all rows).");
  EXPECT_TRUE(hold_against(before, now, {.common_alone = true}).decided());
  EXPECT_TRUE(hold_against(now, before, {}).decided());
}

// Chance gives at most 12.5 ± 3.4 of 250 pairs with anything told at the level 0.05, whether rows are judged
// together or not.
TEST(Judgement, OfResultsThatHaveNotChangedNoMoreAreWorseThanTheLevelSays) {
  using Sizes = std::pair<std::size_t, std::size_t>;  // replicates, scenes
  for (const Sizes& sizes : {Sizes(6, 1), Sizes(7, 2), Sizes(9, 1)}) {
    Noise noise(7);
    const auto drawn = [&] { return noisy(noise, sizes.first, sizes.second); };
    int alarms = 0;
    for (int trial = 0; trial < 250; ++trial)
      alarms += turned_numbers(hold_against(drawn(), drawn(), {.level = 0.05})).empty() ? 0 : 1;
    EXPECT_LE(alarms, 23) << sizes.first;
    EXPECT_GE(alarms, 1) << sizes.first;
  }
}

/// Results with numbers that only some replicates have, with a verdict that is chance, and with one number
/// spread over many powers of ten.
RecordedResults wild(Noise& noise) {
  std::bernoulli_distribution has_peak(0.3), topples(0.5);
  std::lognormal_distribution<double> size(std::log(1e-7), 4);
  RecordedResults results = noisy(noise, 11, 3);
  for (RecordedRun& run : results.runs)
    for (RunMetrics& replicate : run.replicates) {
      if (!has_peak(noise)) replicate.second_peak_difference.reset();
      if (topples(noise)) replicate.toppling_verdict = TopplingVerdict::engine_alone;
      replicate.creep = size(noise);
    }
  return results;
}

// By more topplings a row has half a per cent, by either number less.
TEST(Judgement, OfResultsThatHaveNotChangedHardlyAnyAreUndecided) {
  Noise noise(10);
  int open = 0;
  for (int trial = 0; trial < 100; ++trial)
    open += hold_against(wild(noise), wild(noise), {}).decided() ? 0 : 1;
  EXPECT_LE(open, 5);
}

TEST(Judgement, MoreReplicatesThatFailOrToppleOtherwiseAreAtLeastUndecided) {
  Noise noise(8);
  const RecordedResults before = noisy(noise, 6);
  RecordedResults now = before;
  now.runs[1].replicates[2].status = now.runs[1].replicates[4].status = RunStatus::failed;
  const ResultsChange failing = hold_against(before, now, {});
  EXPECT_EQ(failing.more_failures, std::vector<std::string>{"failed of scene0.engine"});
  EXPECT_FALSE(failing.decided());
  EXPECT_EQ(failing.headline(),
            "Undecided: nothing is shown to be worse, but more replicates fail or topple otherwise "
            "(failed of scene0.engine).");
  EXPECT_TRUE(hold_against(now, before, {}).more_failures.empty()) << "fewer do";
  RecordedResults one_more = now;
  one_more.runs[1].replicates[5].status = RunStatus::failed;
  EXPECT_TRUE(hold_against(now, one_more, {}).more_failures.empty()) << "three of six may be two by chance";

  now = before;
  now.runs[1].replicates[3].toppling_verdict = TopplingVerdict::engine_alone;
  EXPECT_EQ(hold_against(before, now, {}).more_failures,
            std::vector<std::string>{"other_verdict of scene0.engine"});
  for (RunMetrics& replicate : now.runs[1].replicates) replicate.status = RunStatus::failed;
  EXPECT_TRUE(hold_against(before, now, {}).worse());
}

TEST(Judgement, RowsThatTheOldResultsAloneHaveLeaveItUndecidedUnlessNothingIsAskedOfThem) {
  Noise noise(9);
  const RecordedResults before = noisy(noise, 6, 2);
  RecordedResults now = before;
  now.runs.pop_back();
  const ResultsChange result = hold_against(before, now, {});
  EXPECT_EQ(result.headline(),
            "Undecided: nothing is shown to be worse, but what was judged before is judged no more "
            "(scene1.engine).");
  EXPECT_TRUE(hold_against(before, now, {.common_alone = true}).decided());
  EXPECT_TRUE(hold_against(now, before, {}).decided()) << "what is new was not judged before";

  now.runs[1].row.settings = "default+erp=0.5";
  const ResultsChange nothing = hold_against(before, now, {.common_alone = true});
  EXPECT_EQ(nothing.headline(),
            "Undecided: nothing is shown to be worse, but no row of an engine is in both, and nothing was "
            "judged.");
}

TEST(Judgement, RowsAreTheSameToTheBitWhereAllNumbersAreBesidesTheFilesOfTheNominalRun) {
  Noise noise(10);
  RecordedResults before = noisy(noise, 6);
  before.runs[1].checksums["history.csv"] = "1";
  RecordedResults now = before;
  now.runs[1].row.stepping_time_minimum = now.runs[1].replicates[3].processor_time = 7;
  EXPECT_EQ(hold_against(before, now, {}).rows[1].bits, "same") << "times are not of the motion";
  *now.runs[1].replicates[3].sinking *= 1.1;
  EXPECT_EQ(hold_against(before, now, {}).rows[1].bits, "nominal");
  now.runs[1].checksums["history.csv"] = "2";
  EXPECT_EQ(hold_against(before, now, {}).rows[1].bits, "different");
}

}  // namespace
}  // namespace rockstack
