#include "plots/data/results.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "analytic/scene/messages/input_error.hpp"
#include "plots/data/patterns.hpp"
#include "plots/data/run_files.hpp"
#include "plots/data/selection.hpp"
#include "tests/plots/sample.hpp"

namespace rockstack::plots {
namespace {

namespace fs = std::filesystem;

testing::Sample tuned_and_default() {
  testing::Sample sample;
  sample.engines = {{"bullet", "nncg", "default", 2e-3},
                    {"bullet", "nncg", "tuned", 1e-3},
                    {"ode", "step", "default", 2e-3}};
  sample.failed_row = true;
  return sample;
}

TEST(Results, ReadsRowsAndLeavesEmptyCellsWithoutValue) {
  const fs::path folder = testing::fresh_folder();
  testing::write_sample(folder, tuned_and_default());
  const Comparison comparison = read_comparison(folder);
  ASSERT_EQ(comparison.runs.size(), 8u);
  EXPECT_TRUE(comparison.runs[0].exact());
  EXPECT_FALSE(comparison.runs[0].rms_angle_difference);
  EXPECT_EQ(comparison.runs[1].dt, 0.01);
  EXPECT_EQ(comparison.tolerance, 0.01);
  EXPECT_FALSE(comparison.runs.back().done());
  EXPECT_EQ(comparison.runs.back().reason, "angle not finite, at t = 0.3 s <nan>");
}

TEST(Results, RunsThatDifferInTheirIterationsAloneAreOneLine) {
  const fs::path folder = testing::fresh_folder();
  testing::Sample sample;
  sample.engines = {{"ode", "quickstep", "tuned+quickStepNumIterations=20+quickStepW=1", 2e-3},
                    {"ode", "quickstep", "tuned+quickStepNumIterations=100+quickStepW=1", 2e-3},
                    {"ode", "quickstep", "tuned", 2e-3}};
  sample.steps = {1e-3};
  testing::write_sample(folder, sample);
  const auto lines = step_lines(read_comparison(folder), "sample");
  ASSERT_EQ(lines.size(), 2u);
  ASSERT_EQ(lines[0].size(), 2u);
  EXPECT_EQ(iterations_of(lines[0][0]), 100);
  EXPECT_EQ(iterations_of(lines[0][1]), 20);
  EXPECT_EQ(line_label(lines[0]), "ode quickstep, tuned+quickStepW=1");
  EXPECT_EQ(iterations_of(lines[1][0]), 0);
}

TEST(Results, RunsOfSeveralStepsAndIterationsAreALineEachSet) {
  const fs::path folder = testing::fresh_folder();
  testing::Sample sample;
  sample.engines = {{"ode", "quickstep", "tuned+quickStepNumIterations=20", 2e-3},
                    {"ode", "quickstep", "tuned+quickStepNumIterations=100", 2e-3}};
  sample.steps = {1e-3, 1e-4};
  testing::write_sample(folder, sample);
  const auto lines = step_lines(read_comparison(folder), "sample");
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_EQ(lines[0].size(), 2u);
  EXPECT_EQ(line_label(lines[0]), "ode quickstep, tuned+quickStepNumIterations=20");
}

TEST(Results, ShowsTheSmallestStepOfEachSolverAndTunedBeforeDefault) {
  const fs::path folder = testing::fresh_folder();
  testing::write_sample(folder, tuned_and_default());
  const RunSelection shown = shown_runs(read_comparison(folder), "sample");
  ASSERT_EQ(shown.exact.size(), 1u);
  ASSERT_EQ(shown.engines.size(), 2u);
  EXPECT_EQ(run_label(shown.engines[0]), "bullet nncg, tuned, 1 ms");
  EXPECT_EQ(run_label(shown.engines[1]), "ode step, default, 1 ms");
}

/// So many engines of two solvers each, of which the second is nearer at its finest step and the first at its
/// coarsest.
Comparison many_solvers(int engines) {
  Comparison comparison;
  for (int i = 0; i < engines; ++i)
    for (const char* solver : {"one", "two"})
      for (const double dt : {4e-3, 1e-3}) {
        Run run;
        run.scene = "sample";
        run.engine = std::string(1, static_cast<char>('a' + i));
        run.solver = solver;
        run.settings = "tuned";
        run.dt = dt;
        run.status = RunStatus::done;
        run.error = (run.solver == "two") == (dt < 2e-3) ? 1e-4 : 1e-2;
        comparison.runs.push_back(run);
      }
  return comparison;
}

TEST(Results, WhereFiguresOverTimeLackRoomTheyShowTheNearestSolverOfEachEngine) {
  const int few = most_lines / 2;
  EXPECT_EQ(shown_lines(many_solvers(few), "sample").size(), most_lines);
  const std::vector<StepLine> lines = shown_lines(many_solvers(few + 1), "sample");
  ASSERT_EQ(lines.size(), static_cast<std::size_t>(few) + 1);
  for (const StepLine& line : lines) {
    EXPECT_EQ(line.front().solver, "two");
    EXPECT_EQ(line.size(), 2U);
  }
}

TEST(Results, PatternSpansCoverTheWholeMotionWithoutGaps) {
  const fs::path folder = testing::fresh_folder();
  testing::write_sample(folder, testing::Sample{});
  const auto exact = history_of(done_runs(read_comparison(folder), "sample").front());
  EXPECT_EQ(impact_times(*exact, 1).size() + impact_times(*exact, 2).size(), 9u);
  const std::vector<PatternSpan> spans = pattern_spans(*exact);
  ASSERT_EQ(spans.size(), 10u);
  EXPECT_EQ(spans.front().from, 0);
  for (std::size_t i = 1; i < spans.size(); ++i) EXPECT_EQ(spans[i].from, spans[i - 1].to);
  EXPECT_EQ(spans.back().to, 5);
}

// Figures and pages ask for the same motion again and again: a file that is gone is still there for them.
TEST(Results, AFileIsReadOnce) {
  const fs::path folder = testing::fresh_folder();
  testing::write_sample(folder, testing::Sample{});
  const Comparison comparison = read_comparison(folder);
  const plots::Run& exact = comparison.runs.front();
  const auto history = history_of(exact);
  fs::remove(exact.folder / "history.csv");
  const plots::Run copy = exact;
  EXPECT_EQ(history_of(copy), history);
  EXPECT_THROW(history_of(read_comparison(folder).runs.front()), InputError);
}

TEST(Results, AMalformedDescriptionIsNamedByItsFile) {
  const fs::path folder = testing::fresh_folder();
  testing::write_sample(folder, testing::Sample{});
  for (const char* text : {"{", "[]", "{\"title\": 3}"}) {
    std::ofstream(folder / "comparison.json") << text;
    try {
      read_comparison(folder);
      ADD_FAILURE() << text;
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find("comparison.json"), std::string::npos) << error.what();
    }
  }
}

// Results from before hold the text of the scene's file alone; its record may be gone.
TEST(Results, WithoutAPageASceneIsThatOfItsFileWithoutItsGround) {
  const fs::path folder = testing::fresh_folder();
  testing::write_sample(folder, testing::Sample{});
  auto json = Json::parse(testing::bytes_of(folder / "comparison.json"));
  Json& entry = json["scenes"][0];
  entry.erase("page");
  entry["title"] = "From before";
  entry["ground"] = "gone.csv (a record)";
  entry["toml"] =
      "duration = 5\nlaw = \"unilateral\"\n[[blocks]]\nwidth = 1\nheight = 2\ndensity = 500\n"
      "[contact]\nfriction = 0.3\n[ground.horizontal]\nrecord = \"gone.csv\"\n[measured]\nfile = \"gone\"\n";
  std::ofstream(folder / "comparison.json") << json;
  const Comparison comparison = read_comparison(folder);
  const ComparedScene& scene = comparison.scenes.front();
  EXPECT_EQ(scene.heading, "From before, law unilateral");
  EXPECT_EQ(scene.ground, "gone.csv (a record)");
  EXPECT_EQ(scene.block_count(), 1);
  EXPECT_EQ(friction_of(scene), std::vector{0.3});
  EXPECT_TRUE(scene.page.empty());
}

TEST(Results, AHeadingNamesTheLawAndWhatEnginesDoWithout) {
  const fs::path folder = testing::fresh_folder();
  testing::write_sample(folder, testing::Sample{});
  EXPECT_EQ(read_comparison(folder).scenes[0].heading, "A made-up scene, law consistent");
  auto json = Json::parse(testing::bytes_of(folder / "comparison.json"));
  Json page = Json::parse(json["scenes"][0]["page"].get<std::string>());
  page["restitution"] = {0.9, 1};
  json["scenes"][0]["page"] = page.dump();
  std::ofstream(folder / "comparison.json") << json;
  EXPECT_EQ(read_comparison(folder).scenes[0].heading,
            "A made-up scene, law consistent with restitution 0.9, 1, engines without");
}

TEST(Results, DurationsCarryAUnitThatSuitsThem) {
  EXPECT_EQ(duration_text(1.5), "1.5 s");
  EXPECT_EQ(duration_text(1e-3), "1 ms");
  EXPECT_EQ(duration_text(1e-4), "0.1 ms");
  EXPECT_EQ(duration_text(1e-5), "10 µs");
}

}  // namespace
}  // namespace rockstack::plots
