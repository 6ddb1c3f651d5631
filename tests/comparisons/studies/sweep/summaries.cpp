#include "comparisons/studies/sweep/sweep.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "comparisons/measures/results/csv.hpp"
#include "comparisons/measures/statistics/fragility.hpp"
#include "tests/comparisons/studies/sweep/sweep_folder.hpp"

namespace rockstack {
namespace {

/// One sine of 0.5 s on a block of slenderness 0.2 and the given radius in m; amplitudes in units of g tan α.
Ensemble sine_on_block(double radius, const std::string& amplitudes, double duration) {
  const double gravity = 9.80665;
  std::string values;
  std::istringstream words(amplitudes);
  for (double unit = 0; words >> unit;) {
    values += (values.empty() ? "" : ", ") + std::to_string(unit * gravity * std::tan(0.2));
  }
  const auto length = [&](double part) { return std::to_string(2 * radius * part); };
  return ensemble_from(
      "title = \"sine\"\n[scene]\ngravity = 9.80665\nduration = " + std::to_string(duration) +
      "\n[[scene.blocks]]\nwidth = " + length(std::sin(0.2)) + "\nheight = " + length(std::cos(0.2)) +
      "\nmass = 1000\n[scene.ground.horizontal]\npulse = \"sine\"\namplitude = 1\nperiod = 0.5\n"
      "[[vary]]\nkey = \"ground.horizontal.period\"\nvalues = [0.5]\n"
      "[[vary]]\nkey = \"ground.horizontal.amplitude\"\nvalues = [" +
      values +
      "]\n[summary]\nintensity = \"ground.horizontal.amplitude\"\nperiod = "
      "\"ground.horizontal.period\"\n");
}

// A public solver of the nonlinear equations (Numerics-in-Motion, blocks) finds the first amplitude at which
// the block leans by α or more at 1.4584424 and 2.1637842 g tan α. Lengths and amplitudes written with six
// decimals move these by some 1e-6; the grid steps on either side are 5e-4.
TEST(Summaries, OneSineFirstReachesTheSlendernessWherePublished) {
  for (const auto& [radius, amplitudes] :
       {std::pair{0.5, "1.4579 1.4589"}, std::pair{1.0, "2.1633 2.1643"}}) {
    const TemporaryFolder folder;
    sweep_into(folder.path(), sine_on_block(radius, amplitudes, 10));
    const auto ratios = read_columns(folder.path() / "runs.csv", {"peak_ratio"})[0];
    ASSERT_EQ(ratios.size(), 2u);
    EXPECT_LT(ratios[0], 1) << "R = " << radius;
    EXPECT_GE(ratios[1], 1) << "R = " << radius;
  }
}

// Zhang & Makris 2001: between the amplitudes that topple a block after an impact and those that do it
// without one there is a safe bay. Rest, up to g tan α, is exact; the others in the order of their amplitude.
TEST(Summaries, TheOverturningSpectrumHasASafeBay) {
  const TemporaryFolder folder;
  std::string amplitudes;
  for (int tenths = 9; tenths < 140; ++tenths) amplitudes += std::to_string(0.1 * tenths) + " ";
  Ensemble ensemble = sine_on_block(1.0, amplitudes, 6);
  sweep_into(folder.path(), ensemble, {.threads = 2});
  const auto cells =
      read_columns(folder.path() / "overturning.csv",
                   {"rest", "rocking", "toppled_after_impact", "toppled_without_impact", "runs"});
  std::string course;
  for (std::size_t i = 0; i < cells[0].size(); ++i) {
    const char kind = cells[0][i] > 0 ? 'r' : cells[1][i] > 0 ? 's' : cells[2][i] > 0 ? 'i' : 'd';
    EXPECT_EQ(cells[0][i] + cells[1][i] + cells[2][i] + cells[3][i], cells[4][i]);
    if (course.empty() || course.back() != kind) course += kind;
  }
  EXPECT_EQ(course, "rsisd") << "rest, survival, toppling after an impact, the safe bay, direct toppling";
}

std::string rows(const std::vector<std::string>& lines) {
  std::string text = "run,seed,level,peak_1,peak_ratio,toppled,impacts,events,status\n";
  for (std::size_t i = 0; i < lines.size(); ++i) text += std::to_string(i) + "," + lines[i] + "\n";
  return text;
}

// Shares of 16, 50 and 84 % lie 0.32, 1 and 1.68 places behind the first of three values, and 0.48, 1.5
// and 2.52 behind the first of four.
TEST(Summaries, FractilesCountToppledBlocksAsInfinitelyFar) {
  const TemporaryFolder folder;
  folder.write("runs.csv", rows({"1,2,0.1,0.3,0,1,1,done", "1,4,0.2,0.6,0,1,1,done", "2,2,0.1,0.2,0,1,1,done",
                                 "2,4,2,5,1,1,1,done", "3,2,0.1,0.4,0,1,1,done", "3,4,0.1,0.5,0,1,1,done",
                                 "4,2,,,,,,failed", "4,4,0.1,0.7,0,1,1,done"}));
  write_summaries(folder.path(), {.intensity = "level", .period = "", .friction = "", .indices = {}});
  const auto fractiles = read_columns(folder.path() / "incremental-fractiles.csv",
                                      {"intensity", "runs", "fractile_16", "fractile_50", "fractile_84"});
  EXPECT_EQ(fractiles[0], (std::vector<double>{2, 4}));
  EXPECT_EQ(fractiles[1], (std::vector<double>{3, 4}));
  EXPECT_NEAR(fractiles[2][0], 0.232, 1e-15);
  EXPECT_NEAR(fractiles[2][1], 0.548, 1e-15);
  EXPECT_NEAR(fractiles[3][0], 0.3, 1e-15);
  EXPECT_NEAR(fractiles[3][1], 0.65, 1e-15);
  EXPECT_NEAR(fractiles[4][0], 0.368, 1e-15);
  EXPECT_EQ(fractiles[4][1], std::numeric_limits<double>::infinity());
  const Table curves = read_table(folder.path() / "incremental.csv");
  ASSERT_EQ(curves.rows.size(), 7u);
  EXPECT_EQ(curves.rows[2], (std::vector<std::string>{"2", "seed=2", "2", "0.2", "0"}));
  EXPECT_EQ(curves.rows[6], (std::vector<std::string>{"4", "seed=4", "4", "0.7", "0"}));
}

TEST(Summaries, FailedRunsAreCountedAndLeftOutOfShares) {
  const TemporaryFolder folder;
  folder.write("runs.csv", rows({"1,2,0.1,0.3,0,1,1,done", "2,2,,,,,,failed", "3,2,2,5,1,1,1,done"}));
  write_summaries(folder.path(), {.intensity = "level", .period = "", .friction = "", .indices = {}});
  const auto levels =
      read_columns(folder.path() / "fragility.csv", {"runs", "toppled", "failed", "fraction"});
  EXPECT_EQ(levels[0], std::vector<double>{2});
  EXPECT_EQ(levels[1], std::vector<double>{1});
  EXPECT_EQ(levels[2], std::vector<double>{1});
  EXPECT_EQ(levels[3], std::vector<double>{0.5});
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "incremental.csv")) << "no curve has two points";
}

// As many intensities as runs, as where values are drawn: a table of them would be the runs once more.
TEST(Summaries, ManyIntensitiesAreCountedInBinsAndFittedAsTheyAre) {
  const TemporaryFolder folder;
  std::vector<std::string> lines;
  std::vector<Level> own;
  for (int i = 1; i <= 400; ++i) {
    const double level = 0.01 * i;
    const bool topples = (i * 7919) % 400 < i;  // more of them the higher, in an order that is not sorted
    lines.push_back(fmt::format("1,{},0.1,0.3,{},1,1,done", level, topples ? 1 : 0));
    own.push_back({level, 1, topples ? 1u : 0u});
  }
  folder.write("runs.csv", rows(lines));
  write_summaries(folder.path(), {.intensity = "level", .period = "", .friction = "", .indices = {}});
  const auto levels = read_columns(folder.path() / "fragility.csv", {"intensity", "runs", "toppled"});
  ASSERT_EQ(levels[0].size(), 20u);
  std::size_t first = 0;
  for (std::size_t bin = 0; bin < 20; ++bin, first += 20) {
    double toppled = 0;
    for (std::size_t i = first; i < first + 20; ++i) toppled += static_cast<double>(own[i].toppled);
    EXPECT_EQ(levels[0][bin], own[first + 10].intensity);
    EXPECT_EQ(levels[1][bin], 20);
    EXPECT_EQ(levels[2][bin], toppled);
  }
  const auto fit = read_columns(folder.path() / "fragility-fit.csv", {"median", "beta"});
  const Fragility expected = fit_fragility(own).value();
  EXPECT_EQ(fit[0][0], expected.median);
  EXPECT_EQ(fit[1][0], expected.beta);
  EXPECT_EQ(read_columns(folder.path() / "incremental-fractiles.csv", {"runs"})[0].size(), 20u);
}

}  // namespace
}  // namespace rockstack
