#include "comparisons/studies/sweep/sweep.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <map>

#include "analytic/scene/messages/input_error.hpp"
#include "analytic/solve.hpp"
#include "comparisons/measures/metrics/run_outcome.hpp"
#include "comparisons/measures/results/csv.hpp"
#include "tests/comparisons/studies/sweep/sweep_folder.hpp"
#include "tests/stride.hpp"

namespace rockstack {
namespace {

/// 132 runs in 5 blocks, of which the last has 4: drawn heights over a grid of amplitudes, for drawn times in
/// s.
Ensemble small_ensemble(const std::string& seed = "4", const std::string& times = "[0.1, 0.2]") {
  return ensemble_from("samples = 11\nseed = " + seed + "\n" + ensemble_of_one_block(R"([[vary]]
key = "ground.horizontal.amplitude"
range = {from = 1, to = 12, count = 12}
[[vary]]
key = "blocks.1.height"
lognormal = {median = 1, beta = 0.2}
[[vary]]
key = "duration"
uniform = )" + times + R"(
[summary]
intensity = "ground.horizontal.amplitude"
)"));
}

TEST(Sweep, GivesTheSameBytesOnAnyNumberOfThreads) {
  const Ensemble ensemble = small_ensemble();
  const TemporaryFolder one, three;
  EXPECT_TRUE(sweep_into(one.path(), ensemble).finished());
  EXPECT_TRUE(sweep_into(three.path(), ensemble, {.threads = 3}).finished());
  for (const char* name : {"runs.csv", "sweep.json", "fragility.csv", "fragility-fit.csv"}) {
    EXPECT_FALSE(bytes_in(one.path() / name).empty()) << name;
    EXPECT_EQ(bytes_in(one.path() / name), bytes_in(three.path() / name)) << name;
  }
}

TEST(Sweep, GoesOnWhereItWasStoppedAndRepeatsNothing) {
  const Ensemble ensemble = small_ensemble();
  const TemporaryFolder whole, stopped;
  sweep_into(whole.path(), ensemble);
  const SweepResult first = sweep_into(stopped.path(), ensemble, {.blocks = 2});
  EXPECT_FALSE(first.finished());
  EXPECT_FALSE(std::filesystem::exists(stopped.path() / "runs.csv"));
  const SweepResult second = sweep_into(stopped.path(), ensemble, {.threads = 2});
  EXPECT_EQ(first.computed + second.computed, 132u);
  EXPECT_EQ(bytes_in(whole.path() / "runs.csv"), bytes_in(stopped.path() / "runs.csv"));
  const SweepResult third = sweep_into(stopped.path(), ensemble);
  EXPECT_TRUE(third.finished());
  EXPECT_EQ(third.computed, 0u);
}

// A kill may tear the journal's last entry anywhere; an entry is a line and its text.
TEST(Sweep, ATornJournalCostsItsLastBlockAlone) {
  const Ensemble ensemble = small_ensemble();
  const TemporaryFolder whole, torn;
  sweep_into(whole.path(), ensemble);
  const std::string runs = bytes_in(whole.path() / "runs.csv");
  const std::string journal = bytes_in(whole.path() / "runs.journal");
  const auto last = journal.rfind("part ");
  for (std::size_t length = last; length < journal.size(); length += testing::stride) {
    torn.write("runs.journal", journal.substr(0, length));
    EXPECT_EQ(sweep_into(torn.path(), ensemble).computed, 4u);
    ASSERT_EQ(bytes_in(torn.path() / "runs.csv"), runs) << "torn after " << length << " bytes";
  }
}

TEST(Sweep, AJournalThatEndsInItsHeadStartsAnew) {
  const Ensemble ensemble = small_ensemble();
  const TemporaryFolder folder;
  sweep_into(folder.path(), ensemble, {.blocks = 0});
  const std::string head = bytes_in(folder.path() / "runs.journal");
  for (const std::size_t length : {std::size_t{0}, std::size_t{5}, head.size() - 1}) {
    folder.write("runs.journal", head.substr(0, length));
    sweep_into(folder.path(), ensemble, {.blocks = 0});
    EXPECT_EQ(bytes_in(folder.path() / "runs.journal"), head);
  }
}

TEST(Sweep, ABlockWithOneWrongByteIsMadeAgain) {
  const Ensemble ensemble = small_ensemble();
  const TemporaryFolder folder;
  sweep_into(folder.path(), ensemble);
  const std::string runs = bytes_in(folder.path() / "runs.csv");
  std::string journal = bytes_in(folder.path() / "runs.journal");
  char& digit = journal[journal.size() - 30];
  digit = digit == '1' ? '2' : '1';
  folder.write("runs.journal", journal);
  EXPECT_EQ(sweep_into(folder.path(), ensemble).computed, 4u);
  EXPECT_EQ(bytes_in(folder.path() / "runs.csv"), runs);
}

TEST(Sweep, AFolderOfAnotherEnsembleIsRefusedAndLeftAsItWas) {
  const TemporaryFolder folder;
  sweep_into(folder.path(), small_ensemble("4"), {.blocks = 3});
  const std::string journal = bytes_in(folder.path() / "runs.journal");
  EXPECT_THROW(sweep_into(folder.path(), small_ensemble("5")), InputError);
  EXPECT_EQ(bytes_in(folder.path() / "runs.journal"), journal);
}

TEST(Sweep, AValueThatReadsLikeAFailureIsNone) {
  const Ensemble ensemble = ensemble_from(ensemble_of_one_block(R"([[vary]]
key = "title"
group = "a"
values = ["one,failed,two", "failed"]
[[vary]]
key = "duration"
group = "a"
values = [0.1, 0.2]
)"));
  const TemporaryFolder folder;
  const SweepResult result = sweep_into(folder.path(), ensemble);
  EXPECT_EQ(result.done, 2U);
  EXPECT_EQ(result.failed, 0U);
}

TEST(Sweep, ARunThatFailsCostsItsOwnRowAlone) {
  const Ensemble ensemble = ensemble_from("samples = 20\nseed = 1\n" + ensemble_of_one_block(R"([[vary]]
key = "blocks.1.height"
normal = {mean = 1, deviation = 2}
[[vary]]
key = "duration"
values = [0.01]
)"));
  const TemporaryFolder folder;
  const SweepResult result = sweep_into(folder.path(), ensemble);
  EXPECT_TRUE(result.finished());
  std::map<std::string, int> count;
  for (CsvLine row(folder.path() / "runs.csv"); row.next();) {
    const bool tall = row.value("blocks.1.height") > 0;
    EXPECT_EQ(row.text("status"), tall ? "done" : "failed");
    EXPECT_EQ(row.text("reason").empty(), tall);
    ++count[row.text("status")];
  }
  EXPECT_GT(count["done"], 0);
  EXPECT_GT(count["failed"], 0);
  EXPECT_EQ(result.failed, static_cast<std::size_t>(count["failed"]));
}

TEST(Sweep, ARowSaysWhatTheSolverSaysOfItsScene) {
  const Ensemble ensemble = small_ensemble();
  const TemporaryFolder folder;
  sweep_into(folder.path(), ensemble);
  const auto columns = read_columns(folder.path() / "runs.csv",
                                    {"run", "ground.horizontal.amplitude", "blocks.1.height", "duration",
                                     "peak_1", "toppled", "impacts", "least_normal_force"});
  ASSERT_EQ(columns[0].size(), 132u);
  for (const std::size_t i : {0u, 70u, 131u}) {
    Scene scene;
    scene.duration = columns[3][i];
    const double mass = 1000, half_height = 0.5 * columns[2][i];
    scene.blocks = {{0.1, half_height, mass, rectangle_inertia(mass, 0.1, half_height)}};
    scene.initial = {{0}, {0}};
    scene.horizontal.pulse = Pulse{.shape = PulseShape::sine, .amplitude = columns[1][i], .period = 0.5};
    const RunOutcome outcome = run_outcome(scene, solve(scene, run_options()));
    EXPECT_EQ(columns[0][i], static_cast<double>(i));
    EXPECT_EQ(columns[4][i], outcome.peaks[0]);
    EXPECT_EQ(columns[5][i], outcome.toppled);
    EXPECT_EQ(columns[6][i], static_cast<double>(outcome.impacts));
    EXPECT_EQ(columns[7][i], outcome.force.least_normal);
  }
}

TEST(Sweep, ATolerancePeaksDifferByNoMoreThanItsAmplification) {
  // A mistake of one tolerance at each event grows along the motion; a pulse's few swings leave it below 1e3.
  Ensemble ensemble = small_ensemble();
  const TemporaryFolder exact, tolerant;
  sweep_into(exact.path(), ensemble);
  ensemble.tolerance = 1e-9;
  sweep_into(tolerant.path(), ensemble);
  const auto peaks = read_columns(exact.path() / "runs.csv", {"peak_1"})[0];
  const auto others = read_columns(tolerant.path() / "runs.csv", {"peak_1"})[0];
  double largest = 0;
  for (std::size_t i = 0; i < peaks.size(); ++i) largest = std::max(largest, std::abs(peaks[i] - others[i]));
  EXPECT_GT(largest, 0);
  EXPECT_LT(largest, 1e3 * ensemble.tolerance);
}

TEST(Sweep, FragilityAgreesWithCountingRows) {
  const TemporaryFolder folder;
  sweep_into(folder.path(), small_ensemble("4", "[1.2, 1.6]"));
  const auto runs = read_columns(folder.path() / "runs.csv", {"ground.horizontal.amplitude", "toppled"});
  std::map<double, std::pair<double, double>> counted;
  for (std::size_t i = 0; i < runs[0].size(); ++i) {
    counted[runs[0][i]].first += 1;
    counted[runs[0][i]].second += runs[1][i] > 0 ? 1 : 0;
  }
  const auto levels = read_columns(folder.path() / "fragility.csv",
                                   {"intensity", "runs", "toppled", "fraction", "lower", "upper"});
  ASSERT_EQ(levels[0].size(), counted.size());
  double all = 0;
  for (std::size_t i = 0; i < levels[0].size(); ++i) {
    const auto [number_of_runs, toppled] = counted.at(levels[0][i]);
    EXPECT_EQ(levels[1][i], number_of_runs);
    EXPECT_EQ(levels[2][i], toppled);
    EXPECT_EQ(levels[3][i], toppled / number_of_runs);
    EXPECT_LE(levels[4][i], levels[3][i]);
    EXPECT_GE(levels[5][i], levels[3][i]);
    all += toppled;
  }
  EXPECT_GT(all, 0);
  EXPECT_LT(all, 132);
}

}  // namespace
}  // namespace rockstack
