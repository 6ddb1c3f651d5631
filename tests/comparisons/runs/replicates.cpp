#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "analytic/solve.hpp"
#include "comparisons/measures/metrics/impacts.hpp"
#include "comparisons/measures/metrics/motion_verdict.hpp"
#include "comparisons/measures/results/csv.hpp"
#include "comparisons/measures/statistics/samples.hpp"
#include "comparisons/runs/compare.hpp"
#include "comparisons/runs/job.hpp"
#include "tests/comparisons/block_text.hpp"
#include "tests/free_rocking.hpp"
#include "tests/native_engines.hpp"
#include "tests/temporary_folder.hpp"

namespace rockstack {
namespace {

Suite suite_of(const TemporaryFolder& folder, const WorkerEngine& engine) {
  Suite suite = suite_for(read_named_scene(folder.write("block.toml", block_text), {"duration=1"}));
  suite.repeats = 1;
  suite.replicates.runs = 5;
  suite.series = {make_series(engine, "default", {1e-2})};
  return suite;
}

TEST(Replicates, StepsLieEvenlyAroundTheNominalOne) {
  const Replicates replicates{.runs = 21, .steps = 0.03};
  double sum = 0;
  for (int i = 1; i < replicates.runs; ++i) {
    const double step = replicate_step(1e-3, replicates, i);
    EXPECT_LE(std::abs(step / 1e-3 - 1), 0.03);
    EXPECT_NE(step, 1e-3);
    sum += step;
  }
  EXPECT_EQ(replicate_step(1e-3, replicates, 0), 1e-3);
  EXPECT_NEAR(sum, 20 * 1e-3, 1e-15);
}

RunMetrics row_with(double difference) {
  RunMetrics row;
  row.rms_angle_difference = difference;
  row.impacts_matched = static_cast<int>(difference);
  return row;
}

// Quartiles of 1 … 21 are the values 5, 10 and 15 places behind the first. Those of 20 values lie 4.75 places
// and so on behind it; a count stays whole.
TEST(Replicates, ARowGetsMediansAndQuartiles) {
  RunMetrics nominal = row_with(21);
  std::vector<RunMetrics> replicates;
  for (int i = 1; i <= 20; ++i) replicates.push_back(row_with(i));
  replicates.push_back(row_with(0));
  replicates.back().status = RunStatus::failed;
  summarise(replicates, nominal);
  EXPECT_EQ(nominal.rms_angle_difference, 11);
  EXPECT_EQ(nominal.rms_angle_difference_lower, 6);
  EXPECT_EQ(nominal.rms_angle_difference_upper, 16);
  EXPECT_EQ(nominal.impacts_matched, 11);
  EXPECT_EQ(nominal.draws, 22);
  EXPECT_EQ(nominal.draws_failed, 1);
  replicates.pop_back();
  replicates.pop_back();
  nominal = row_with(21);
  summarise(replicates, nominal);
  EXPECT_EQ(nominal.rms_angle_difference, 10.5);
  EXPECT_EQ(nominal.rms_angle_difference_lower, 5.75);
  EXPECT_EQ(nominal.rms_angle_difference_upper, 15.25);
  EXPECT_EQ(nominal.impacts_matched, 11);
}

// Errors 1 to 4 and a failure, which has none: of four the median's rank is the second.
TEST(Replicates, TheOneOfTheMedianErrorStandsForTheRow) {
  const auto with_error = [](double error) {
    RunMetrics row;
    row.error = error;
    return row;
  };
  RunWithReplicates row{with_error(4), {with_error(1), with_error(3), with_error(2), with_error(0)}};
  row.replicates.back().status = RunStatus::failed;
  EXPECT_EQ(representative(row), 3);
  row.nominal.error = 2;
  EXPECT_EQ(representative(row), 0) << "the nominal run comes before others of the same error";
  EXPECT_EQ(representative({RunMetrics{}, {}}), 0);
}

// What figures show has the angle differences of the replicate whose error is the row's.
TEST(Replicates, FiguresShowTheOneOfTheMedianError) {
  if (native_engines().empty()) GTEST_SKIP() << "this build has no engine";
  const TemporaryFolder folder;
  Suite suite = suite_of(folder, native_engines().front());
  suite.history_interval = 0;
  const RunMetrics row = compare({suite}, folder.path(), *make_threads(1), {}).rows.at(1);
  const auto run = folder.path() / "runs" / row.run;
  const auto file = (*row.shown_replicate > 0 ? run / shown_name : run) / "difference.csv";
  double sum = 0;
  const auto differences = read_columns(file, {"difference_1"}).front();
  for (const double difference : differences) sum += difference * difference;
  const auto draws = read_columns(run / "draws.csv", {"error", "rms_angle_difference"});
  const auto shown = static_cast<std::size_t>(*row.shown_replicate);
  EXPECT_EQ(draws[0].at(shown), *row.error);
  EXPECT_NEAR(std::sqrt(sum / static_cast<double>(differences.size())) / draws[1].at(shown), 1, 1e-9);

  std::filesystem::remove_all(run / shown_name);
  EXPECT_EQ(compare({suite}, folder.path(), *make_threads(1), {}).reused, 2U);
  EXPECT_TRUE(std::filesystem::exists(file)) << "made again where it is gone";
}

TEST(Replicates, StandBehindARowAndAreNotMadeAgain) {
  if (native_engines().empty()) GTEST_SKIP() << "this build has no engine";
  const TemporaryFolder folder;
  Suite suite = suite_of(folder, native_engines().front());
  const RunMetrics row = compare({suite}, folder.path(), *make_threads(1), {}).rows.at(1);
  EXPECT_EQ(row.draws, 5);
  const auto file = folder.path() / "runs" / row.run / "draws.csv";
  const auto read = [&] { return read_columns(file, {"dt", "rms_angle_difference"}); };
  auto errors = read().at(1);
  ASSERT_EQ(errors.size(), 5U);
  std::sort(errors.begin(), errors.end());
  EXPECT_EQ(row.rms_angle_difference, errors[2]);
  EXPECT_LT(errors.front(), errors.back());
  EXPECT_EQ(read_table(folder.path() / "spread.csv").rows.front().front(), row.run);

  const auto written = std::filesystem::last_write_time(file);
  const CompareResult again = compare({suite}, folder.path(), *make_threads(1), {});
  EXPECT_EQ(again.reused, 2U);
  EXPECT_EQ(again.rows.at(1).rms_angle_difference, row.rms_angle_difference);
  EXPECT_EQ(std::filesystem::last_write_time(file), written);

  suite.replicates.runs = 7;
  EXPECT_EQ(compare({suite}, folder.path(), *make_threads(1), {}).reused, 2U);
  EXPECT_EQ(read().at(0).size(), 7U);
}

// The band's edges are quartiles of the replicates' angles, each made by itself, to the digits of the file.
TEST(Replicates, LeaveABandBetweenTheQuartilesOfTheirAngles) {
  if (native_engines().empty()) GTEST_SKIP() << "this build has no engine";
  const TemporaryFolder folder;
  const WorkerEngine& engine = native_engines().front();
  const Suite suite = suite_of(folder, engine);
  const Job job{suite, suite.scenes[0], 1e-2, suite.series.data()};
  folder.write("band.csv", make_replicates(job, 1).band);
  const auto band = read_columns(folder.path() / "band.csv", {"time", "lower_1", "upper_1"});
  std::vector<History> motions;
  for (int i = 1; i < suite.replicates.runs; ++i)
    motions.push_back(simulate(engine, replicate_scene(job.scene.scene, suite.replicates, i),
                               replicate_step(job.dt, suite.replicates, i), suite.series[0].parameters)
                          .history);
  ASSERT_GT(band[0].size(), 380U) << "steps do not end where the scene does";
  double widest = 0;
  for (std::size_t i = 0; i < band[0].size(); ++i) {
    std::vector<double> angles;
    for (const History& motion : motions) angles.push_back(angle_at(motion, 0, band[0][i]));
    EXPECT_NEAR(band[1][i], quantile(angles, 0.25), 1e-6);
    EXPECT_NEAR(band[2][i], quantile(angles, 0.75), 1e-6);
    widest = std::max(widest, band[2][i] - band[1][i]);
  }
  EXPECT_GT(widest, 1e-4) << "steps of 10 ms part";
  Suite lean = suite;
  lean.wanted.histories = false;
  EXPECT_EQ(make_replicates({lean, suite.scenes[0], 1e-2, suite.series.data()}, 1).band, "");
}

TEST(Replicates, ThatFailAreCountedAndOneThatRunsOutOfTimeEndsTheSet) {
  for (const WorkerEngine& engine : engines_of(FAULTY_WORKER)) {
    if (engine.solver != "throw" && engine.solver != "loop") continue;
    const TemporaryFolder folder;
    Suite suite = suite_of(folder, engine);
    suite.limits.time = 1;
    const Job job{suite, suite.scenes.front(), 1e-2, &suite.series.front()};
    const auto replicates = make_replicates(job, 1).rows;
    ASSERT_EQ(replicates.size(), 4U);
    for (const RunMetrics& row : replicates)
      EXPECT_EQ(row.status, engine.solver == "loop" ? RunStatus::time_limit : RunStatus::failed);
    const std::string names = replicates[0].run + " " + replicates[1].run;
    EXPECT_EQ(replicates[0].run == replicates[1].run, engine.solver == "loop") << names;
  }
}

// Free rocking is predictable: it dies away. One disturbance is 1e-6 of the motion, the tolerance 1e-2 rad.
TEST(Replicates, PredictableTimeIsTheDurationUnlessHistoriesPart) {
  const Scene scene = free_rocking(3);
  EXPECT_EQ(predictable_time(scene, {.runs = 5}, 1e-2), scene.duration);
  EXPECT_LT(predictable_time(scene, {.runs = 5, .scene = 1e-2}, 1e-6), 0.1);
}

// A block that falls flat stays as it lands, and one that is tilted by however little turns there.
TEST(Replicates, PredictableTimeOfAFlatDropEndsSoonAfterItsLanding) {
  Scene scene;
  scene.law = Law::unilateral;
  scene.duration = 0.5;
  scene.blocks = {make_block(0.5, 1, 2500)};
  scene.initial = {{0}, {0}};
  scene.initial.gaps = {0.3};
  scene.friction = {0.5};
  const double landing = std::sqrt(2 * 0.3 / scene.gravity),
               time = predictable_time(scene, {.runs = 5}, 1e-2);
  EXPECT_GT(time, landing);
  EXPECT_LT(time, landing + std::sqrt(1 / scene.gravity));
  EXPECT_EQ(flat_landing(solve(scene, {}), time).value(), solve(scene, {}).events.front().time);
}

// A block that rocks for a second; neighbours differ by a thousandth part and drift apart.
TEST(Replicates, RowsAreOfTheTimeUpToTheHorizonOfTheSceneHoweverManyDrawsThereAre) {
  if (native_engines().empty()) GTEST_SKIP() << "this build has no engine";
  std::vector<double> horizons;
  for (const int runs : {1, 3}) {
    const TemporaryFolder folder;
    Suite suite = suite_of(folder, native_engines().front());
    suite.replicates = {.runs = runs, .scene = 1e-3};
    suite.tolerance = 2e-4;
    const auto rows = compare({suite}, folder.path(), *make_threads(1), {}).rows;
    horizons.push_back(*rows.at(0).horizon);
    EXPECT_EQ(rows.at(1).horizon, rows.at(0).horizon);
    EXPECT_LE(*rows.at(1).agreement_time, *rows.at(1).horizon);
    if (runs > 1) continue;
    // The angles of difference.csv go on after the horizon, and are larger there.
    const auto columns =
        read_columns(folder.path() / "runs" / rows.at(1).run / "difference.csv", {"time", "difference_1"});
    double before = 0, after = 0;
    for (std::size_t i = 0; i < columns[0].size(); ++i) {
      double& largest = columns[0][i] <= horizons.front() ? before : after;
      largest = std::max(largest, std::abs(columns[1][i]));
    }
    EXPECT_EQ(rows.at(1).largest_angle_difference, before);
    EXPECT_GT(after, before);
  }
  EXPECT_EQ(horizons.front(), horizons.back());
  EXPECT_GT(horizons.front(), 0);
  EXPECT_LT(horizons.front(), 0.9);
}

}  // namespace
}  // namespace rockstack
