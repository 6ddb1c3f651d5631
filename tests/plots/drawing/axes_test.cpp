#include "plots/drawing/axes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "tests/plots/sample.hpp"

namespace rockstack::plots {
namespace {

TEST(LinearTics, AreRoundAndHaveRoom) {
  EXPECT_EQ(linear_tics("y", 0, 1, 300), "set ytics 0.1\n");
  EXPECT_EQ(linear_tics("y", -3, 4, 110), "set ytics 2\n");
  EXPECT_EQ(linear_tics("x", 0, 0.3, 340), "set xtics 0.1\n");
}

// Else the words beside them leave the figure: six letters are as wide as -0.015.
TEST(LinearTics, UpwardsAreShortHoweverLargeNumbersAre) {
  for (int power = -12; power <= 12; ++power)
    for (const double reach : {1.0, 1.6, 4.4, 9.9}) {
      const double high = reach * std::pow(10, power);
      const std::string tics = linear_tics("y", -high, high, 380);
      if (tics.find('(') == std::string::npos) {
        const double step = std::stod(tics.substr(tics.rfind(' ')));
        EXPECT_TRUE(step >= 1e-4 && high < 1e6) << tics;  // gnuplot's numbers are as those of printf's %g
        continue;
      }
      for (std::size_t at = tics.find('\''); at < tics.find(')'); at = tics.find('\'', at + 1)) {
        const std::size_t end = tics.find('\'', at + 1);
        EXPECT_LE(end - at - 1, 6u) << tics;
        at = end;
      }
      EXPECT_NE(tics.find("'×10^{" + std::to_string(power) + "}'"), std::string::npos) << tics;
    }
  EXPECT_EQ(linear_tics("y", -1e-5, 2e-5, 120),
            "set ytics ('-1' -1e-05, '0' 0, '1' 1e-05, '2' 2e-05)\n"
            "set label '×10^{-5}' at graph 0, graph 1 left offset 0.5,-0.9 front\n");
}

TEST(LogarithmicTics, ArePowersOfTenAndWithinTwoDecadesTheirMultiplesToo) {
  EXPECT_EQ(logarithmic_tics("x", 1e-4, 1e-2, 300), "set format x '10^{%T}'\nset xtics 0.0001, 10\n");
  EXPECT_EQ(logarithmic_tics("x", 1e-6, 1e-1, 300),
            "set format x '10^{%T}'\nset xtics 1e-06, 100\nunset mxtics\n");
  EXPECT_EQ(logarithmic_tics("y", 0.02, 0.5, 300),
            "set ytics ('3·10^{-2}' 0.03, '10^{-1}' 0.1, '3·10^{-1}' 0.3)\n");
  EXPECT_EQ(logarithmic_tics("y", 0.2, 0.9, 300),
            "set ytics ('2·10^{-1}' 0.2, '3·10^{-1}' 0.3, '5·10^{-1}' 0.5, '7·10^{-1}' 0.7)\n");
  EXPECT_EQ(logarithmic_tics("x", 0.027, 0.08, 185), "set xtics ('3.5·10^{-2}' 0.035, '6·10^{-2}' 0.06)\n");
}

/// A run that swings until that second, the first of ten, and rests after it.
plots::Run swinging_until(const std::filesystem::path& folder, int second) {
  plots::Run run;
  run.folder = folder / std::to_string(second);
  std::filesystem::create_directories(run.folder);
  std::ofstream history(run.folder / "history.csv");
  history << "time,theta_1,omega_1\n";
  for (int t = 0; t <= 10; ++t) history << t << "," << (t < second ? 0.1 - 0.2 * (t % 2) : 0) << ",0\n";
  return run;
}

ComparedScene scene_until(double predictable_time) {
  ComparedScene scene;
  scene.duration = 10;
  scene.predictable_time = predictable_time;
  return scene;
}

TEST(TimeAxis, EndsWithTheMotionAndNotWithTheRest) {
  const auto folder = testing::fresh_folder();
  const plots::Run exact = swinging_until(folder, 2), engine = swinging_until(folder, 4);
  const ComparedScene scene = scene_until(std::nan(""));
  EXPECT_DOUBLE_EQ(time_axis(scene, {exact}).end, 1.08 * 2);
  EXPECT_DOUBLE_EQ(time_axis(scene, {exact, engine}).end, 1.08 * 4);
  EXPECT_EQ(time_axis(scene, {swinging_until(folder, 11)}).end, 10);
}

TEST(TimeAxis, IsShadedFromTheHorizonOn) {
  const plots::Run exact = swinging_until(testing::fresh_folder(), 2);
  Legend legend;
  for (const double horizon : {std::nan(""), 10.0, 3.0}) {
    const TimeAxis axis = time_axis(scene_until(horizon), {exact});
    EXPECT_FALSE(axis.is_shaded()) << horizon;
    EXPECT_EQ(time_range(axis), "set xrange [0:2.16]\n");
    explain_shade(axis, legend);
  }
  EXPECT_TRUE(legend.empty());
  const TimeAxis axis = time_axis(scene_until(1.5), {exact});
  EXPECT_NE(time_range(axis).find("rectangle from 1.5, graph 0 to graph 1, graph 1"), std::string::npos);
  explain_shade(axis, legend);
  EXPECT_EQ(legend.size(), 1U);
}

}  // namespace
}  // namespace rockstack::plots
