#include "comparisons/suite.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>

#include "analytic/scene/input_error.hpp"
#include "comparisons/compare.hpp"
#include "comparisons/impact_law_results.hpp"
#include "comparisons/stability/study.hpp"
#include "comparisons/table.hpp"
#include "tests/temporary_folder.hpp"

namespace rockstack {
namespace {

constexpr const char* block = R"(duration = 0.2
[[blocks]]
width = 0.5
height = 2
density = 2500
[initial]
angles = [0.05]
)";

/// The error of a suite of that text beside "block.toml", without the folder; empty where there is none.
std::string error_of(const std::string& text) {
  const TemporaryFolder folder;
  folder.write("block.toml", block);
  try {
    read_suite(folder.write("suite.toml", text), {});
  } catch (const InputError& error) {
    std::string line = error.what();
    const std::string before = folder.path().string() + "/";
    if (line.starts_with(before)) line.erase(0, before.size());
    return line;
  }
  return {};
}

TEST(Suites, ShippedOnesAreReadable) {
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(ROCKSTACK_SUITES)) {
    if (is_stability_study(entry.path())) {
      EXPECT_NO_THROW(read_stability_study(entry.path(), {})) << entry.path();
      continue;
    }
    if (is_study(entry.path())) {
      EXPECT_NO_THROW(read_impact_law_study(entry.path())) << entry.path();
      continue;
    }
    EXPECT_TRUE(is_suite(entry.path()));
    const Suite suite = read_suite(entry.path(), {});
    EXPECT_FALSE(suite.scenes.empty()) << entry.path();
    ++count;
  }
  EXPECT_GT(count, 0);
}

TEST(Suites, ErrorsNameLineKeyAndWhatIsAllowed) {
  const std::string head = "title = \"a\"\nscenes = [\"block.toml\"]\n";
  EXPECT_EQ(error_of(head), "");
  EXPECT_TRUE(
      error_of(head + "tolerance = 0\n").starts_with("suite.toml:3: tolerance = 0: must be a number > 0"));
  EXPECT_TRUE(
      error_of(head + "repeats = 1.5\n").starts_with("suite.toml:3: repeats = 1.5: must be a whole number"));
  EXPECT_TRUE(error_of(head + "colour = 1\n").starts_with("suite.toml:3: colour"));
  EXPECT_TRUE(error_of(head + "[[engines]]\nname = \"havok\"\n")
                  .starts_with("suite.toml:4: engine = havok: must be one of"));
  EXPECT_TRUE(error_of("title = \"a\"\nscenes = []\n").starts_with("suite.toml:2: scenes"));
}

TEST(Suites, OverridesReachEveryScene) {
  const TemporaryFolder folder;
  folder.write("block.toml", block);
  const auto file = folder.write("suite.toml", "title = \"a\"\nscenes = [\"block.toml\"]\n");
  EXPECT_EQ(read_suite(file, {"gravity=1.62"}).scenes.at(0).scene.gravity, 1.62);
}

TEST(Suites, ParametersAreChangedOneSeriesEachCombination) {
  if (engines().empty()) GTEST_SKIP() << "this build has no engine";
  const WorkerEngine& engine = engines().front();
  const TemporaryFolder folder;
  folder.write("block.toml", block);
  const std::string head = "title = \"a\"\nscenes = [\"block.toml\"]\n[[engines]]\nname = \"" +
                           engine.name() + "\"\nsettings = [\"tuned\"]\n[engines.parameters]\n";
  const std::string name = engine.settings().front().name;
  const Suite suite = read_suite(folder.write("suite.toml", head + name + " = [2, 3]\n"), {});
  ASSERT_EQ(suite.series.size(), 2U);
  Parameters expected = engine.tuned_parameters();
  expected[name] = 3;
  EXPECT_EQ(suite.series[1].parameters, expected);
  EXPECT_EQ(suite.series[1].settings, "tuned+" + name + "=3");
  EXPECT_TRUE(
      error_of(head + "wishes = 1\n").starts_with("suite.toml:7: " + engine.name() + ": wishes = 1: no"));
  EXPECT_TRUE(error_of(head + name + " = -1\n")
                  .starts_with("suite.toml:7: " + engine.name() + ": " + name + " = -1: must be"));
}

TEST(Suites, PerturbationsAreRead) {
  const TemporaryFolder folder;
  folder.write("block.toml", block);
  const std::string head = "title = \"a\"\nscenes = [\"block.toml\"]\n";
  EXPECT_EQ(read_suite(folder.write("suite.toml", head), {}).perturbations.runs, 0);
  const auto file = folder.write("suite.toml", head + "[perturbations]\nruns = 50\nsize = 1e-4\nseed = 7\n");
  const Perturbations around = read_suite(file, {}).perturbations;
  EXPECT_EQ(around.runs, 50);
  EXPECT_EQ(around.size, 1e-4);
  EXPECT_EQ(around.seed, 7U);
  EXPECT_TRUE(error_of(head + "[perturbations]\nruns = 1\n")
                  .starts_with("suite.toml:4: perturbations.runs = 1: must be a whole number ≥ 2"));
  EXPECT_TRUE(error_of(head + "[perturbations]\nruns = 3\nsize = 0.5\n")
                  .starts_with("suite.toml:5: perturbations.size = 0.5: must be"));
}

TEST(Suites, ResultsThatAreAskedForAreRead) {
  const TemporaryFolder folder;
  folder.write("block.toml", block);
  const std::string head = "title = \"a\"\nscenes = [\"block.toml\"]\n";
  const Wanted all = read_suite(folder.write("suite.toml", head), {}).wanted;
  EXPECT_TRUE(all.angles && all.impacts && all.patterns && all.bodies && all.histories);
  const Wanted some = read_suite(folder.write("suite.toml", head + "results = [\"impacts\"]\n"), {}).wanted;
  EXPECT_TRUE(some.impacts && !some.angles && !some.patterns && !some.bodies && !some.histories);
  EXPECT_TRUE(error_of(head + "results = [\"looks\"]\n").starts_with("suite.toml:3: results"));
}

TEST(Suites, ChangesToScenesYieldToThoseOfTheCommandLine) {
  const TemporaryFolder folder;
  folder.write("block.toml", block);
  const auto file = folder.write(
      "suite.toml", "title = \"a\"\nscenes = [\"block.toml\"]\nset = [\"gravity=3\", \"duration=7\"]\n");
  const Scene scene = read_suite(file, {"gravity=1.62"}).scenes.at(0).scene;
  EXPECT_EQ(scene.gravity, 1.62);
  EXPECT_EQ(scene.duration, 7);
}

TEST(Suites, LimitsAreRead) {
  const TemporaryFolder folder;
  folder.write("block.toml", block);
  const std::string head = "title = \"a\"\nscenes = [\"block.toml\"]\n";
  const Suite suite =
      read_suite(folder.write("suite.toml", head + "time_limit = 7.5\nmemory_limit = 512\n"), {});
  EXPECT_EQ(suite.limits.time, 7.5);
  EXPECT_EQ(suite.limits.memory, std::uint64_t{512} << 20);
  EXPECT_TRUE(error_of(head + "memory_limit = 1\n").starts_with("suite.toml:3: memory_limit = 1: must be"));
}

TEST(Compare, AFailingRunCostsItsOwnRow) {
  const TemporaryFolder folder;
  Suite suite = suite_for(read_named_scene(folder.write("block.toml", block), {}));
  suite.repeats = 1;
  suite.limits.time = 5;
  for (EngineSeries& series : suite.series) series.steps = {1e-2};
  const std::vector<WorkerEngine> faulty = engines_of(FAULTY_WORKER);
  const std::map<std::string, std::string> expected{
      {"fine", "done"},     {"throw", "failed"},          {"abort", "signal"},
      {"killed", "signal"}, {"not-finite", "not finite"}, {"loop", "time limit"}};
  for (const WorkerEngine& engine : faulty) {
    if (expected.count(engine.solver()) == 0) continue;
    suite.series.insert(suite.series.begin(), make_series(engine, "default", {1e-2}));
  }
  const auto rows = compare({suite}, folder.path(), {}).rows;
  ASSERT_EQ(rows.size(), suite.series.size() + 1);
  for (const Row& row : rows) {
    EXPECT_EQ(row.status, row.engine == "faulty" ? expected.at(row.solver) : "done") << row.run << row.reason;
    EXPECT_EQ(row.reason.empty(), row.status == "done") << row.run;
    EXPECT_EQ(row.rms_angle_difference.has_value(), row.status == "done" && row.engine != "exact") << row.run;
    EXPECT_TRUE(std::filesystem::exists(folder.path() / "runs" / row.run / "summary.json"));
  }
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "comparison.csv"));
}

TEST(Compare, ResultsNotAskedForAreNotComputed) {
  if (engines().empty()) GTEST_SKIP() << "this build has no engine";
  const TemporaryFolder folder;
  Suite suite = suite_for(read_named_scene(folder.write("block.toml", block), {}));
  suite.repeats = 1;
  suite.series.resize(1);
  suite.series[0].steps = {1e-2};
  suite.wanted = {false, false, false, false, false};
  const Row row = compare({suite}, folder.path(), {}).rows.at(1);
  EXPECT_EQ(row.status, "done");
  for (const char* name : {"rms_angle_difference", "impacts_matched", "pattern_agreement", "slip"}) {
    EXPECT_TRUE(row_json(row).at(name).is_null()) << name;
  }
  for (const char* name : {"history.csv", "difference.csv", "impacts.csv", "patterns.csv", "energy.csv"}) {
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "runs" / row.run / name)) << name;
  }
}

TEST(Compare, ScenesThatWouldShareAFolderAreRefused) {
  const TemporaryFolder folder;
  const Suite suite = suite_for(read_named_scene(folder.write("block.toml", block), {}));
  EXPECT_THROW(compare({suite, suite}, folder.path(), {}), InputError);
}

/// A suite of one block, and of the first engine where there is one.
Suite small_suite(const TemporaryFolder& folder) {
  Suite suite = suite_for(read_named_scene(folder.write("block.toml", block), {}));
  suite.repeats = 1;
  if (suite.series.size() > 2) suite.series.resize(2);
  for (EngineSeries& series : suite.series) series.steps = {1e-2, 1e-3};
  suite.variants = {{"linear"}};
  return suite;
}

/// The cells of a row that the machine's speed has no part in.
nlohmann::ordered_json lasting(const Row& row) {
  auto cells = row_json(row);
  for (const Column& column : columns()) {
    if (column.measured) cells.erase(column.name);
  }
  return cells;
}

TEST(Compare, TheSameSuiteTwiceGivesTheSameNumbersButForTimesHoweverManyRunsAreMadeAtATime) {
  const TemporaryFolder first, second;
  const auto one = compare({small_suite(first)}, first.path(), {});
  const auto other = compare({small_suite(second)}, second.path(), {.jobs = 3});
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
  const auto rows = compare({suite}, folder.path(), {}).rows;
  for (const Row& row : rows)
    EXPECT_EQ(read_tallies(folder.path() / "runs" / row.run / "perturbed.csv").size(), 4U) << row.run;
  const Table table = read_table(folder.path() / "distributions.csv");
  EXPECT_EQ(table.rows.size(), 3 * (rows.size() - 1));  // peak_1, impacts and toppled
}

TEST(Compare, RunsThatAreDoneAreNotMadeAgain) {
  const TemporaryFolder folder;
  const Suite suite = small_suite(folder);
  const auto first = compare({suite}, folder.path(), {});
  std::size_t reports = 0;
  const auto again = compare({suite}, folder.path(), {.progress = [&](const Standing& now) {
                               EXPECT_EQ(now.done, reports++);
                               EXPECT_EQ(now.total, first.rows.size());
                             }});
  EXPECT_EQ(again.reused, first.rows.size());
  EXPECT_EQ(reports, first.rows.size() + 1);
  for (std::size_t i = 0; i < first.rows.size(); ++i)
    EXPECT_EQ(row_json(first.rows[i]), row_json(again.rows[i])) << first.rows[i].run;
}

TEST(Compare, RunsOfOtherInputsOrThatAreTornAreMadeAgain) {
  const TemporaryFolder folder;
  Suite suite = small_suite(folder);
  const auto rows = compare({suite}, folder.path(), {}).rows;
  std::filesystem::remove(folder.path() / "runs" / rows[0].run / "summary.json");
  EXPECT_EQ(compare({suite}, folder.path(), {}).reused, rows.size() - 1);
  if (!suite.series.empty()) {
    suite.series[0].parameters.begin()->second += 1;
    const std::size_t changed = suite.series[0].steps.size();
    EXPECT_EQ(compare({suite}, folder.path(), {}).reused, rows.size() - changed);
  }
  suite.scenes[0].scene.gravity *= 1.0 + 1e-15;
  EXPECT_EQ(compare({suite}, folder.path(), {}).reused, 0U);
}

}  // namespace
}  // namespace rockstack
