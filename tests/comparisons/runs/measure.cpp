#include "comparisons/runs/measure.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>

#include "analytic/scene/input/json_reader.hpp"
#include "comparisons/measures/results/outcome_columns.hpp"
#include "tests/comparisons/block_text.hpp"
#include "tests/temporary_folder.hpp"

namespace rockstack {
namespace {

constexpr const char* shaken_text = R"(
[ground.horizontal]
samples = [0.0, 1.0, -1.0, 0.0]
interval = 0.1
scale = 0.5
)";

/// The summary of a scene that was solved with overrides.
Json solved_summary(const TemporaryFolder& folder, const std::vector<std::string>& overrides) {
  const auto file = folder.write("block.toml", std::string(block_text) + shaken_text);
  const NamedScene scene = read_named_scene(file, overrides);
  const SolveOptions options{
      .sample_times = regular_times(1e-2, scene.scene.duration), .validity = true, .peaks = true};
  const std::vector<std::string> histories;
  std::filesystem::create_directories(folder.path() / "out");
  solve_into({scene, options, histories, folder.path() / "out", "a test"});
  return read_json(folder.path() / "out" / "summary.json", [](const Json& json) { return json; });
}

TEST(SolveInto, ASummaryHasTheSceneAsItWasRun) {
  const TemporaryFolder folder;
  const Json summary = solved_summary(folder, {"duration=0.7", "ground.horizontal.scale=4"});
  const Scene again = read_scene(folder.write("again.toml", summary.at("scene_file").get<std::string>()));
  EXPECT_EQ(again.duration, 0.7);
  EXPECT_EQ(again.horizontal.samples, (std::vector<double>{0, 4, -4, 0}));
  EXPECT_EQ(again.initial.angles, std::vector<double>{0.05});
  EXPECT_EQ(summary.at("scene_as_run").at("ground"), "samples in the scene file, times 4");
  const std::string as_it_is = std::string(block_text) + shaken_text;
  EXPECT_EQ(solved_summary(folder, {}).at("scene_file"), as_it_is);
}

// The block falls over: its balance is at atan(1/4), and it starts beyond that.
TEST(SolveInto, ASummaryHasWhatTheMotionComesToAndNothingThatOnlyComparisonsTell) {
  const TemporaryFolder folder;
  const Json summary = solved_summary(folder, {"duration=5", "initial.angles=[0.3]"});
  EXPECT_EQ(summary.at("toppled"), 1);
  EXPECT_GT(summary.at("topple_time"), 0.0);
  EXPECT_EQ(summary.at("motion"), "topple");
  EXPECT_GT(summary.at("peak_ratio"), 1.0);
  EXPECT_TRUE(summary.contains("force_friction"));
  std::set<std::string> outcome;
  for (const OutcomeColumn& column : outcome_columns(1)) outcome.insert(column.name);
  for (const Column& column : columns())
    EXPECT_EQ(summary.contains(column.name), column.any_motion || outcome.contains(column.name))
        << column.name;
}

}  // namespace
}  // namespace rockstack
