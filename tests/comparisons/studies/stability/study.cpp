#include "comparisons/studies/stability/study.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "analytic/scene/input/json_reader.hpp"
#include "analytic/scene/input/page_scene.hpp"
#include "comparisons/measures/results/csv.hpp"
#include "comparisons/measures/results/provenance.hpp"
#include "tests/temporary_folder.hpp"

namespace rockstack {
namespace {

/// A block 1 m wide and 4 m high: slenderness atan(1/4), tipped over by sqrt(1 + 1/16) − 1 = 0.0308 of its
/// weight times its half height.
Scene tower() {
  Scene scene;
  scene.duration = 1;
  scene.blocks = {make_block(1, 4, 2500)};
  scene.initial = {{0.1}, {0}};
  return scene;
}

RunMetrics clean() {
  RunMetrics row;
  row.energy_gain = row.penetration = row.rise = row.slip = row.out_of_plane = row.out_of_plane_tilt = 0;
  row.largest_angle_difference = 0;
  row.toppling_verdict = TopplingVerdict::neither;
  return row;
}

const double tipping = std::hypot(1, 0.25) - 1;

struct Measure {
  const char* name;
  std::optional<double> RunMetrics::*field;
  double unit;   ///< of the tower
  double limit;  ///< share of it
  Soundness beyond;
};

class Verdicts : public ::testing::TestWithParam<Measure> {};

TEST_P(Verdicts, ChangeAtTheLimitOfEachMeasure) {
  const Measure& measure = GetParam();
  RunMetrics row = clean();
  row.*measure.field = 0.999 * measure.limit * measure.unit;
  EXPECT_LT(judge_stability(row, tower()).soundness, measure.beyond);
  row.*measure.field = 1.001 * measure.limit * measure.unit;
  const StabilityVerdict verdict = judge_stability(row, tower());
  EXPECT_EQ(verdict.soundness, measure.beyond);
  EXPECT_NE(verdict.reason.find("limit"), std::string::npos) << verdict.reason;
}

INSTANTIATE_TEST_SUITE_P(
    Of, Verdicts,
    ::testing::Values(
        Measure{"gain", &RunMetrics::energy_gain, tipping, 0.05, Soundness::inexact},
        Measure{"blow_up", &RunMetrics::energy_gain, tipping, 0.5, Soundness::unstable},
        Measure{"rise", &RunMetrics::rise, 4, 0.1, Soundness::unstable},
        Measure{"tilt", &RunMetrics::out_of_plane_tilt, 1, 0.1, Soundness::unstable},
        Measure{"penetration", &RunMetrics::penetration, 4, 0.01, Soundness::inexact},
        Measure{"slip", &RunMetrics::slip, 1, 0.02, Soundness::inexact},
        Measure{"out_of_plane", &RunMetrics::out_of_plane, 1, 0.01, Soundness::inexact},
        Measure{"residual", &RunMetrics::residual_motion, std::sqrt(9.81 / 4), 1e-3, Soundness::inexact},
        Measure{"angle", &RunMetrics::largest_angle_difference, std::atan(0.25), 0.05, Soundness::inexact}),
    [](const auto& instance) { return std::string(instance.param.name); });

TEST(Verdict, IsSoundWithoutReasonWhereNothingIsBroken) {
  EXPECT_EQ(judge_stability(clean(), tower()).soundness, Soundness::sound);
  EXPECT_EQ(judge_stability(clean(), tower()).reason, "");
}

TEST(Verdict, NumbersThatAreNoneAreNotSound) {
  RunMetrics row = clean();
  row.energy_gain = std::nan("");
  EXPECT_EQ(judge_stability(row, tower()).soundness, Soundness::unstable);
}

TEST(Verdict, OfToppling) {
  RunMetrics row = clean();
  row.toppling_verdict = TopplingVerdict::engine_alone;
  EXPECT_EQ(judge_stability(row, tower()).soundness, Soundness::unstable);
  row.toppling_verdict = TopplingVerdict::exact_alone;
  EXPECT_EQ(judge_stability(row, tower()).soundness, Soundness::inexact);
  row.toppling_verdict = TopplingVerdict::both;
  EXPECT_EQ(judge_stability(row, tower()).soundness, Soundness::sound);
}

TEST(Verdict, ARunThatIsNotDoneHasFailedAndSaysWhy) {
  RunMetrics row = clean();
  row.status = RunStatus::signal;
  row.reason = "SIGABRT";
  EXPECT_EQ(judge_stability(row, tower()).soundness, Soundness::failed);
  EXPECT_EQ(judge_stability(row, tower()).reason, "signal: SIGABRT");
}

// The verdict of a pebble is that of a tower: all lengths and what they are measured by scale together.
TEST(Verdict, DoesNotDependOnSize) {
  Scene pebble = tower();
  pebble.blocks = {make_block(0.001, 0.004, 2500)};
  RunMetrics row = clean();
  row.slip = 0.0199 * 0.001;
  EXPECT_EQ(judge_stability(row, pebble).soundness, Soundness::sound);
  row.slip = 0.0201 * 0.001;
  EXPECT_EQ(judge_stability(row, pebble).soundness, Soundness::inexact);
}

std::vector<StabilityRun> at_steps(const std::vector<std::pair<double, Soundness>>& verdicts) {
  std::vector<StabilityRun> rows;
  for (const auto& [dt, soundness] : verdicts) {
    RunMetrics row;
    row.engine = "e";
    row.dt = dt;
    rows.push_back({row, 1, {soundness, ""}});
  }
  return rows;
}

TEST(LargestSteps, AreThoseBelowWhichAllHold) {
  const auto steps = largest_steps(at_steps({{1e-1, Soundness::sound},
                                             {2e-2, Soundness::unstable},
                                             {1e-2, Soundness::inexact},
                                             {2e-3, Soundness::sound},
                                             {1e-3, Soundness::sound}}));
  ASSERT_EQ(steps.size(), 1U);
  EXPECT_EQ(steps[0].sound, 2e-3);
  EXPECT_EQ(steps[0].stable, 1e-2);
}

TEST(LargestSteps, AreZeroWhereTheSmallestFails) {
  const auto steps = largest_steps(at_steps({{1e-2, Soundness::sound}, {1e-3, Soundness::failed}}));
  EXPECT_EQ(steps.at(0).sound, 0);
  EXPECT_EQ(steps.at(0).stable, 0);
}

const std::string block_toml = R"(title = "A block"
duration = 0.2
[[blocks]]
width = 0.5
height = 2.5
mass = 3000
[initial]
angles = [0.05]
)";

std::string study_toml(const std::string& widths) {
  return "study = \"stability\"\ntitle = \"t\"\nscene = \"block.toml\"\n[axis]\nname = \"width\"\n"
         "values = [0.5, 1]\n[axis.set]\n\"blocks.1.width\" = " +
         widths + "\n";
}

TEST(StabilityStudies, VaryKeysOfASceneAndGiveEachRunAVerdict) {
  const TemporaryFolder folder;
  folder.write("block.toml", block_toml);
  const StabilityStudy study = read_stability_study(folder.write("study.toml", study_toml("[0.5, 1]")), {});
  ASSERT_EQ(study.suite.scenes.size(), 2U);
  EXPECT_EQ(study.suite.scenes[1].scene.blocks[0].half_width, 0.5);
  const auto rows = run_stability(study, folder.path(), *make_threads(1), {});
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows[1].value, 1);
  EXPECT_EQ(read_table(folder.path() / "stability.csv").rows.size(), 2U);
}

TEST(StabilityStudies, BeginWithHowManyRunsAreSoundAndTheLargestStableSteps) {
  const TemporaryFolder folder;
  folder.write("block.toml", block_toml);
  const auto file = folder.write("study.toml", "rk4 = [0.001]\n" + study_toml("[0.5, 1]"));
  run_stability(read_stability_study(file, {}), folder.path(), *make_threads(1), {});
  const Json json = read_json(folder.path() / "stability.json");
  EXPECT_EQ(json.at("headline"),
            (Json{"Of 2 engine runs 2 are sound.",
                  "rk4 runge-kutta, baseline: the largest stable step is 1 ms at all 2 values of width."}));
}

TEST(StabilityStudies, StackTheTopBlockAsOftenAsAskedFor) {
  const TemporaryFolder folder;
  folder.write("block.toml", block_toml);
  const auto file = folder.write("study.toml", study_toml("[0.5, 0.5]\n\"blocks\" = [1, 3]"));
  const StabilityStudy study = read_stability_study(file, {});
  EXPECT_EQ(study.suite.scenes[0].scene.blocks.size(), 1U);
  const Scene& column = study.suite.scenes[1].scene;
  ASSERT_EQ(column.blocks.size(), 3U);
  EXPECT_EQ(column.blocks[2].half_height, column.blocks[0].half_height);
  EXPECT_EQ(column.initial.angles, (std::vector<double>{0.05, 0.05, 0.05}));
  const NamedScene& again = study.suite.scenes[1];
  const Json held{{"page", page_text(again.document, column)}};
  EXPECT_EQ(scene_fields(recorded_scene(held, "", "results")), scene_fields(column));
  EXPECT_EQ(recorded_scene(Json::object(), again.text, "results").blocks.size(), 3U);
}

TEST(StabilityStudies, SayHowManyBlocksThereMayBe) {
  const TemporaryFolder folder;
  folder.write("block.toml", block_toml);
  const auto file = folder.write("study.toml", study_toml("[0.5, 0.5]\n\"blocks\" = [1, 2.5]"));
  try {
    read_stability_study(file, {});
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("study.toml:9"), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("whole numbers of blocks"), std::string::npos) << error.what();
  }
}

// Smooth motion for 0.2 s: a step of 10 ms is 0.02 of its time, to the fourth power 2e-7.
TEST(StabilityStudies, HoldTheRungeKuttaBaselineAgainstTheSeries) {
  const TemporaryFolder folder;
  folder.write("block.toml", block_toml);
  const auto file = folder.write("study.toml", "rk4 = [1e-2]\n" + study_toml("[0.5, 1]"));
  const auto rows = run_stability(read_stability_study(file, {}), folder.path(), *make_threads(1), {});
  ASSERT_EQ(rows.size(), 4U);
  EXPECT_EQ(rows[1].row.engine, "rk4");
  EXPECT_EQ(rows[1].row.dt, 1e-2);
  EXPECT_EQ(rows[1].verdict.soundness, Soundness::sound);
  EXPECT_GT(rows[1].row.largest_angle_difference, 0);
  EXPECT_LT(rows[1].row.largest_angle_difference, 2e-7);
  EXPECT_EQ(largest_steps({rows.begin(), rows.end()}).size(), 2U);
}

TEST(StabilityStudies, SayWhereAnAxisHasTooFewValues) {
  const TemporaryFolder folder;
  folder.write("block.toml", block_toml);
  const auto file = folder.write("study.toml", study_toml("[0.5]"));
  try {
    read_stability_study(file, {});
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("study.toml:8"), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("2 numbers"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace rockstack
