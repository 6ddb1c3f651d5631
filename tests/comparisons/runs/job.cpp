#include "comparisons/runs/compare.hpp"

#include <gtest/gtest.h>

#include "comparisons/measures/results/csv.hpp"
#include "tests/comparisons/block_text.hpp"
#include "tests/native_engines.hpp"
#include "tests/temporary_folder.hpp"

namespace rockstack {
namespace {

double size_of(const std::filesystem::path& folder) {
  double bytes = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    if (entry.path().extension() == ".csv") bytes += static_cast<double>(entry.file_size());
  }
  return bytes;
}

TEST(DiskUse, IsToldBeforeAndFallsWithTheSamplesThatAreKept) {
  if (native_engines().empty()) GTEST_SKIP() << "this build has no engine";
  const TemporaryFolder folder;
  Suite suite = suite_for(read_named_scene(folder.write("block.toml", block_text), {"duration=0.5"}),
                          {.steps = {1e-3}});
  suite.repeats = 1;
  suite.replicates.runs = 1;
  const RunMetrics all = compare({suite}, folder.path() / "all", *make_threads(1), {}).rows.back();
  const double bytes = size_of(folder.path() / "all");
  // How long numbers are depends on the motion.
  EXPECT_GT(result_bytes({suite}), 0.7 * bytes);
  EXPECT_LT(result_bytes({suite}), 1.5 * bytes);

  for (EngineSeries& series : suite.series) series.steps = {1e-4};
  const RunMetrics fine = compare({suite}, folder.path() / "fine", *make_threads(1), {}).rows.back();
  EXPECT_EQ(read_columns(folder.path() / "fine" / "runs" / fine.run / "history.csv", {"time"})[0].size(),
            501U);
  for (EngineSeries& series : suite.series) series.steps = {1e-3};

  suite.history_interval = 0.02;
  const RunMetrics thin = compare({suite}, folder.path() / "thin", *make_threads(1), {}).rows.back();
  EXPECT_EQ(thin.rms_angle_difference, all.rms_angle_difference);
  EXPECT_LT(size_of(folder.path() / "thin"), 0.1 * bytes);
  const auto history = [&](const char* results) {
    return folder.path() / results / "runs" / all.run / "history.csv";
  };
  const auto kept = read_columns(history("thin"), {"time", "theta_1"});
  const auto every = read_columns(history("all"), {"time", "theta_1"});
  ASSERT_EQ(kept[0].size(), 26U);
  for (std::size_t i = 0; i < kept[0].size(); ++i) {
    EXPECT_EQ(kept[0][i], every[0][20 * i]);
    EXPECT_EQ(kept[1][i], every[1][20 * i]);
  }
}

}  // namespace
}  // namespace rockstack
