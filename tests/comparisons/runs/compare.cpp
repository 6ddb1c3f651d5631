#include "comparisons/runs/compare.hpp"

#include <gtest/gtest.h>

#include <map>
#include <nlohmann/json.hpp>

#include "analytic/scene/messages/input_error.hpp"
#include "analytic/solve.hpp"
#include "comparisons/measures/results/csv.hpp"
#include "comparisons/measures/results/provenance.hpp"
#include "comparisons/measures/statistics/distributions.hpp"
#include "comparisons/runs/job.hpp"
#include "tests/comparisons/block_text.hpp"
#include "tests/native_engines.hpp"
#include "tests/temporary_folder.hpp"

namespace rockstack {
namespace {

TEST(Compare, AFailingRunCostsItsOwnRow) {
  const TemporaryFolder folder;
  Suite suite = suite_for(read_named_scene(folder.write("block.toml", block_text), {}));
  suite.repeats = 1;
  suite.limits.time = 5;
  for (EngineSeries& series : suite.series) series.steps = {1e-2};
  const std::vector<WorkerEngine> faulty = engines_of(FAULTY_WORKER);
  const std::map<std::string, std::string> expected{
      {"fine", "done"},     {"throw", "failed"},          {"abort", "signal"},
      {"killed", "signal"}, {"not-finite", "not finite"}, {"loop", "time limit"}};
  for (const WorkerEngine& engine : faulty) {
    if (expected.count(engine.solver) == 0) continue;
    suite.series.insert(suite.series.begin(), make_series(engine, "default", {1e-2}));
  }
  const auto rows = compare({suite}, folder.path(), *make_threads(1), {}).rows;
  ASSERT_EQ(rows.size(), suite.series.size() + 1);
  for (const RunMetrics& row : rows) {
    EXPECT_EQ(name(row.status), row.engine == "faulty" ? expected.at(row.solver) : "done")
        << row.run << row.reason;
    EXPECT_EQ(row.reason.empty(), row.status == RunStatus::done) << row.run;
    EXPECT_EQ(row.rms_angle_difference.has_value(), row.status == RunStatus::done && row.engine != "exact")
        << row.run;
    EXPECT_TRUE(std::filesystem::exists(folder.path() / "runs" / row.run / "summary.json"));
  }
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "comparison.csv"));
}

TEST(Compare, WhatATestHasMeasuredIsARowOfItsOwn) {
  const TemporaryFolder folder;
  const NamedScene exact = read_named_scene(folder.write("block.toml", block_text), {});
  CsvWriter csv;
  csv.line("time", "angle");
  const History motion = solve(exact.scene, {.sample_times = regular_times(1e-2, 0.2)});
  for (std::size_t i = 0; i < motion.size(); ++i) csv.line(motion.times[i], motion.angles[i] + 1e-3);
  folder.write("test.csv", csv.text());
  const std::string table = "[measured]\nfile = \"test.csv\"\ncolumn = \"angle\"\n";
  Suite suite = suite_for(read_named_scene(folder.write("tested.toml", block_text + table), {}));
  suite.series.clear();
  suite.repeats = 1;
  const auto rows = compare({suite}, folder.path(), *make_threads(1), {}).rows;
  ASSERT_EQ(rows.size(), 2U);
  const RunMetrics& row = rows.back();
  EXPECT_EQ(row.run, "tested.measured");
  EXPECT_EQ(row.status, RunStatus::done) << row.reason;
  // Angles read back to the bit; a sum of 0.05 and 0.001 is rounded once.
  EXPECT_NEAR(row.largest_angle_difference.value(), 1e-3, 1e-15);
  EXPECT_NEAR(row.rms_angle_difference.value(), 1e-3, 1e-15);
  EXPECT_EQ(row.steps, 20);
  EXPECT_FALSE(row.stepping_time_minimum);
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "runs/tested.measured/history.csv"));
}

TEST(Compare, EnginesRunWithoutARatioOfRestitutionWhichTheResultsHave) {
  const TemporaryFolder folder;
  const std::string ratio = std::string("restitution = [0.75]\n") + block_text;
  Suite suite = suite_for(read_named_scene(folder.write("ratio.toml", ratio), {}));
  suite.repeats = 1;
  suite.series.resize(1);
  suite.series.front().steps = {1e-2};
  for (const RunMetrics& row : compare({suite}, folder.path(), *make_threads(1), {}).rows)
    EXPECT_EQ(row.status, RunStatus::done) << row.reason;
  const auto json = nlohmann::ordered_json::parse(bytes_of(folder.path() / "comparison.json"));
  EXPECT_EQ(recorded_scene(json.at("scenes").at(0), "", "comparison.json").restitution, std::vector{0.75});
}

/// A column of a file of results.
std::vector<double> column_of(const std::filesystem::path& file, const char* name) {
  return read_columns(file, {name}).front();
}

TEST(Compare, EveryMotionIsHeldAgainstWhatATestHasMeasuredOfAPoint) {
  const TemporaryFolder folder;
  // Pushed off flat with 1 m/s, friction 0.5: x = t − 0.5 g t²/2 until it stops.
  CsvWriter csv;
  csv.line("t", "mm");
  for (const double time : regular_times(0.015, 0.19))
    csv.line(time, 1e3 * (time - 0.5 * 9.81 * time * time / 2 + 2e-3));
  folder.write("test.csv", csv.text());
  Suite suite = suite_for(read_named_scene(folder.write("pushed.toml", R"(duration = 0.19
law = "unilateral"
[[blocks]]
width = 0.5
height = 0.25
density = 2500
[initial]
slip_velocities = [1.0]
[contact]
friction = 0.5
[measured]
file = "test.csv"
time = "t"
column = "mm"
unit = "mm"
point = [-0.25, 0.125]
)"),
                                           {}));
  suite.repeats = 1;
  suite.series.resize(1);
  suite.series.front().steps = {1e-3};
  const auto rows = compare({suite}, folder.path(), *make_threads(1), {}).rows;
  ASSERT_EQ(rows.size(), 2U);  // no row of its own: a point tells no angles
  // Lines between samples of 1 ms leave out μg dt²/8 = 6e-7 m, and an engine's step is off by μg dt of speed.
  EXPECT_NEAR(rows[0].rms_test_difference.value(), 2e-3, 7e-7);
  EXPECT_NEAR(rows[1].rms_test_difference.value(), 2e-3, 0.5 * 9.81 * 1e-3 * 0.19);
  for (const RunMetrics& row : rows) {
    const auto file = folder.path() / "runs" / row.run / "readings.csv";
    EXPECT_EQ(column_of(file, "motion_1").size(), 13U) << row.run;
    EXPECT_NEAR(column_of(file, "measured_1")[2], 0.03 - 0.5 * 9.81 * 0.03 * 0.03 / 2 + 2e-3, 1e-15);
  }
}

TEST(Compare, ATestOfSomeBlocksIsHeldAgainstThose) {
  const TemporaryFolder folder;
  const std::string two = R"(duration = 0.2
[[blocks]]
width = 1
height = 0.5
density = 2500
[[blocks]]
width = 0.5
height = 2
density = 2500
[initial]
angles = [0, 0.05]
)";
  const NamedScene exact = read_named_scene(folder.write("two.toml", two), {});
  const History motion = solve(exact.scene, {.sample_times = regular_times(1e-2, 0.2)});
  CsvWriter csv;
  csv.line("time", "top");
  for (std::size_t i = 0; i < motion.size(); ++i) csv.line(motion.times[i], motion.angles[2 * i + 1] - 1e-3);
  folder.write("test.csv", csv.text());
  const std::string table = "[measured]\nfile = \"test.csv\"\ncolumn = \"top\"\nblock = 2\n";
  Suite suite = suite_for(read_named_scene(folder.write("tested.toml", two + table), {}));
  suite.series.clear();
  suite.repeats = 1;
  const auto rows = compare({suite}, folder.path(), *make_threads(1), {}).rows;
  ASSERT_EQ(rows.size(), 1U);
  EXPECT_NEAR(rows[0].rms_test_difference.value(), 1e-3, 1e-12);  // readings are at samples
}

/// Three blocks whose masses are so far apart that rounding would leave energies too few digits.
constexpr const char* far_apart = R"(duration = 0.2
[[blocks]]
width = 0.00476
height = 0.00952
mass = 1.71e-15
[[blocks]]
width = 3.83
height = 7.67
mass = 1.32e-13
[[blocks]]
width = 0.00624
height = 0.0125
mass = 0.0366
[initial]
angles = [0.1, 0.05, 0.02]
velocities = [1, -1, 1]
)";

TEST(Compare, ASceneWithoutAMotionCostsItsOwnRows) {
  const TemporaryFolder folder;
  Suite suite = suite_for(read_named_scene(folder.write("block.toml", block_text), {}));
  suite.scenes.push_back(read_named_scene(folder.write("far.toml", far_apart), {}));
  suite.repeats = 1;
  suite.series.resize(std::min<std::size_t>(suite.series.size(), 1));
  for (EngineSeries& series : suite.series) series.steps = {1e-2};
  for (const RunMetrics& row : compare({suite}, folder.path(), *make_threads(1), {}).rows) {
    const bool far = row.scene == "far";
    EXPECT_EQ(row.status, far ? RunStatus::failed : RunStatus::done) << row.run;
    EXPECT_EQ(row.reason.find(row.engine == "exact" ? "block masses or sizes" : "no exact motion"),
              far ? 0 : std::string::npos)
        << row.run << row.reason;
  }
}

/// Steps of Runge and Kutta as long as these run away where the ground falls.
TEST(Compare, AMotionThatIsGivenUpIsKeptUpToThere) {
  const TemporaryFolder folder;
  std::string falling = "duration = 1\n";
  for (int k = 0; k < 3; ++k) falling += "[[blocks]]\nwidth = 1\nheight = 2\ndensity = 2500\n";
  falling +=
      "[ground.vertical]\npulse = \"rectangle\"\namplitude = -500\nperiod = 0.9\nstart = 0.1\n"
      "[ground.horizontal]\npulse = \"sine\"\namplitude = 5\nperiod = 0.2\n";
  Suite suite = suite_for(read_named_scene(folder.write("falling.toml", falling), {}));
  suite.series.clear();
  suite.variants = {{Variant::Choice::rk4, 0.1}};
  const RunMetrics row = compare({suite}, folder.path(), *make_threads(1), {}).rows.at(1);
  EXPECT_EQ(row.status, RunStatus::failed);
  EXPECT_EQ(row.reason.find("angles or velocities"), 0U) << row.reason;
  for (const char* name : {"history.csv", "events.csv"})
    EXPECT_TRUE(std::filesystem::exists(folder.path() / "runs" / row.run / name)) << name;
}

TEST(Compare, ResultsNotAskedForAreNotComputed) {
  if (native_engines().empty()) GTEST_SKIP() << "this build has no engine";
  const TemporaryFolder folder;
  Suite suite = suite_for(read_named_scene(folder.write("block.toml", block_text), {}));
  suite.repeats = 1;
  suite.series.resize(1);
  suite.series[0].steps = {1e-2};
  suite.wanted = {false, false, false, false, false};
  const RunMetrics row = compare({suite}, folder.path(), *make_threads(1), {}).rows.at(1);
  EXPECT_EQ(row.status, RunStatus::done);
  for (const char* name : {"rms_angle_difference", "impacts_matched", "pattern_agreement", "slip"}) {
    EXPECT_TRUE(nlohmann::ordered_json(row).at(name).is_null()) << name;
  }
  for (const char* name : {"history.csv", "difference.csv", "impacts.csv", "patterns.csv", "energy.csv"}) {
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "runs" / row.run / name)) << name;
  }
}

TEST(Compare, ScenesThatWouldShareAFolderAreRefused) {
  const TemporaryFolder folder;
  const Suite suite = suite_for(read_named_scene(folder.write("block.toml", block_text), {}));
  EXPECT_THROW(compare({suite, suite}, folder.path(), *make_threads(1), {}), InputError);
}

/// A suite of one block, and of the first engine where there is one.
Suite small_suite(const TemporaryFolder& folder) {
  Suite suite = suite_for(read_named_scene(folder.write("block.toml", block_text), {}));
  suite.repeats = 1;
  suite.replicates.runs = 1;
  if (suite.series.size() > 2) suite.series.resize(2);
  for (EngineSeries& series : suite.series) series.steps = {1e-2, 1e-3};
  suite.variants = {{Variant::Choice::linear}};
  return suite;
}

/// The cells of a row that the machine's speed has no part in.
nlohmann::ordered_json lasting(const RunMetrics& row) {
  nlohmann::ordered_json cells = row;
  for (const Column& column : columns()) {
    if (column.measured) cells.erase(column.name);
  }
  return cells;
}

TEST(Compare, TheSameSuiteTwiceGivesTheSameNumbersButForTimesHoweverManyRunsAreMadeAtATime) {
  const TemporaryFolder first, second;
  const auto one = compare({small_suite(first)}, first.path(), *make_threads(1), {});
  const auto other = compare({small_suite(second)}, second.path(), *make_threads(3), {});
  EXPECT_EQ(one.reused + other.reused, 0U);
  ASSERT_EQ(one.rows.size(), other.rows.size());
  for (std::size_t i = 0; i < one.rows.size(); ++i) {
    EXPECT_EQ(lasting(one.rows[i]), lasting(other.rows[i])) << one.rows[i].run;
    EXPECT_EQ(one.rows[i].runs_at_a_time, 1);
    EXPECT_EQ(other.rows[i].runs_at_a_time, 3);
  }
}

TEST(Compare, PerturbedScenesAreMadeOnEveryAnswerAndCompared) {
  const TemporaryFolder folder;
  Suite suite = small_suite(folder);
  suite.perturbations = {.runs = 4, .size = 1e-3, .seed = 1};
  const auto rows = compare({suite}, folder.path(), *make_threads(1), {}).rows;
  for (const RunMetrics& row : rows)
    EXPECT_EQ(read_tallies(folder.path() / "runs" / row.run / "perturbed.csv").size(), 4U) << row.run;
  const Table table = read_table(folder.path() / "distributions.csv");
  EXPECT_EQ(table.rows.size(), 3 * (rows.size() - 1));  // peak_1, impacts and toppled
}

TEST(Compare, RunsThatAreDoneAreNotMadeAgain) {
  const TemporaryFolder folder;
  const Suite suite = small_suite(folder);
  const auto first = compare({suite}, folder.path(), *make_threads(1), {});
  std::size_t reports = 0;
  const auto again = compare({suite}, folder.path(), *make_threads(1), {.progress = [&](const Progress& now) {
                               EXPECT_EQ(now.done, reports++);
                               EXPECT_EQ(now.total, first.rows.size());
                             }});
  EXPECT_EQ(again.reused, first.rows.size());
  EXPECT_EQ(reports, first.rows.size() + 1);
  for (std::size_t i = 0; i < first.rows.size(); ++i)
    EXPECT_EQ(nlohmann::ordered_json(first.rows[i]), nlohmann::ordered_json(again.rows[i]))
        << first.rows[i].run;
}

TEST(Compare, NamesOfRunsFitIntoAnyFileSystem) {
  if (native_engines().empty()) GTEST_SKIP() << "this build has no engine";
  const TemporaryFolder folder;
  const std::string stem(249, 's');
  const NamedScene scene = read_named_scene(folder.write(stem + ".toml", block_text), {});
  EXPECT_LE(scene.name.size(), 128U);
  Suite suite;
  suite.scenes = {scene};
  EngineSeries series = make_series(native_engines().front(), "tuned", {1e-2});
  series.settings = std::string(400, 'p');
  EXPECT_LE(describe({suite, suite.scenes[0], 1e-2, &series}).run.size(), 128U);
}

TEST(Compare, ScenesTooLongToBeSampledAreNamedByThePlaceOfTheirDuration) {
  const TemporaryFolder folder;
  const auto file = folder.write("block.toml", block_text);
  try {
    require_comparable({suite_for(read_named_scene(file, {"duration=2e4"}))});
    FAIL() << "no error";
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what()).find("--set duration=2e4: duration = 20000: must be at most 10000 s"),
              0U)
        << error.what();
  }
}

// As where a worker calls itself by an engine's name.
TEST(Compare, AnEngineIsInAComparisonOnce) {
  const TemporaryFolder folder;
  Suite suite = suite_for(read_named_scene(folder.write("block.toml", block_text), {}));
  const EngineSeries series = make_series(native_engines().front(), "tuned", {1e-2});
  suite.series = {series, make_series(native_engines().front(), "default", {1e-2})};
  EXPECT_NO_THROW(require_comparable({suite}));
  suite.series.push_back(series);
  try {
    require_comparable({suite});
    FAIL() << "no error";
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what()),
              "engine " + series.engine->full_name() +
                  ": must be in a comparison once; its results would share a folder");
  }
}

TEST(Compare, RunsOfOtherInputsOrThatAreTornAreMadeAgain) {
  const TemporaryFolder folder;
  Suite suite = small_suite(folder);
  const auto rows = compare({suite}, folder.path(), *make_threads(1), {}).rows;
  std::filesystem::remove(folder.path() / "runs" / rows[0].run / "summary.json");
  EXPECT_EQ(compare({suite}, folder.path(), *make_threads(1), {}).reused, rows.size() - 1);
  const auto history = folder.path() / "runs" / rows[0].run / "history.csv";
  std::filesystem::resize_file(history, std::filesystem::file_size(history) / 2);
  EXPECT_EQ(compare({suite}, folder.path(), *make_threads(1), {}).reused, rows.size() - 1);
  std::filesystem::remove(folder.path() / "runs" / rows[0].run / "reactions.csv");
  EXPECT_EQ(compare({suite}, folder.path(), *make_threads(1), {}).reused, rows.size() - 1);
  if (!suite.series.empty()) {
    suite.series[0].parameters.begin()->second += 1;
    const std::size_t changed = suite.series[0].steps.size();
    EXPECT_EQ(compare({suite}, folder.path(), *make_threads(1), {}).reused, rows.size() - changed);
  }
  suite.scenes[0].scene.gravity *= 1.0 + 1e-15;
  EXPECT_EQ(compare({suite}, folder.path(), *make_threads(1), {}).reused, 0U);
}

}  // namespace
}  // namespace rockstack
