#include "plots/figures/figure.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <sstream>

#include "analytic/scene/messages/input_error.hpp"
#include "plots/figures/studies/sweep_facts.hpp"
#include "tests/plots/sample.hpp"

namespace rockstack::plots {
namespace {

using testing::bytes_of;

/// A folder with sweep.json and one more file.
std::filesystem::path folder_with(const std::string& name, const std::string& text) {
  auto folder = testing::fresh_folder();
  std::ofstream(folder / "sweep.json")
      << R"({"title": "A made-up sweep", "summary": {"intensity": "ground.horizontal.peak", "period": ""}})";
  std::ofstream(folder / name) << text;
  return folder;
}

bool drawn(const std::filesystem::path& folder, const std::string& name) {
  return bytes_of(folder / "figures" / (name + ".png")).starts_with("\x89PNG") &&
         bytes_of(folder / "figures" / (name + ".svg")).find("peak ground acceleration") != std::string::npos;
}

TEST(SweepFigures, AFragilityCurveIsDrawnWithAndWithoutAFit) {
  const auto folder = folder_with("fragility.csv",
                                  "intensity,runs,toppled,failed,fraction,lower,upper,fitted\n"
                                  "2,20,0,0,0,0,0.16,0.02\n3,20,9,0,0.45,0.25,0.65,0.4\n4,0,0,2,,0,1,0.9\n");
  std::ofstream(folder / "fragility-fit.csv") << "median,beta,log_likelihood\n3.1,0.3,-20\n";
  draw_figures(folder);
  EXPECT_TRUE(drawn(folder, "fragility"));
  EXPECT_TRUE(drawn(folder, "fragility.narrow"));
  EXPECT_NE(bytes_of(folder / "figures/fragility.svg").find("median 3.1"), std::string::npos);
  std::ofstream(folder / "fragility-fit.csv") << "median,beta,log_likelihood\n";
  draw_figures(folder);
  EXPECT_EQ(bytes_of(folder / "figures/fragility.svg").find("median"), std::string::npos);
}

TEST(SweepFigures, IndicesAreBarsAtEachIntensityOrOverAllRuns) {
  const std::string header =
      "intensity,outcome,key,first,first_lower,first_upper,total,total_lower,total_upper,deviation,samples,left_out\n";
  const std::string width = ",toppled,blocks.1.width,0.3,0.2,0.4,0.5,0.4,0.6,0.4,99,0\n",
                    seed = ",toppled,ground.horizontal.synthetic,0.4,0.3,0.5,0.6,0.5,0.7,0.4,99,0\n",
                    constant = ",toppled,blocks.1.width,,,,,,,0,99,0\n";
  const auto folder =
      folder_with("indices.csv", header + "2" + constant + "3" + width + "3" + seed + "4.5" + width);
  std::ofstream(folder / "sweep.json")
      << R"({"title": "t", "summary": {"intensity": "ground.horizontal.peak", "period": ""},
             "indices": {"headline": ["At a peak the seed decides most over toppled: its total Sobol index is 0.6."]}})";
  draw_figures(folder);
  EXPECT_TRUE(drawn(folder, "indices"));
  EXPECT_TRUE(drawn(folder, "indices.narrow"));
  const std::string svg = bytes_of(folder / "figures/indices.svg");
  for (const char* words : {"ground.horizontal.synthetic", "share of the variance of toppled", ">4.5<",
                            "the seed decides most over toppled"})
    EXPECT_NE(svg.find(words), std::string::npos) << words;
  std::ofstream(folder / "indices.csv") << header + width + seed;
  draw_figures(folder);
  EXPECT_FALSE(drawn(folder, "indices")) << "no intensity, and none along an axis";
  EXPECT_NE(bytes_of(folder / "figures/indices.svg").find("blocks.1.width"), std::string::npos);
}

TEST(SweepFigures, IncrementalCurvesMayToppleAndRockAgain) {
  const auto folder = folder_with(
      "incremental.csv",
      "curve,values,intensity,peak_ratio,toppled\n1,seed=1,2,0.1,0\n1,seed=1,3,5,1\n1,seed=1,4,0.7,0\n"
      "2,seed=2,2,0.2,0\n2,seed=2,3,0.3,0\n2,seed=2,4,6,1\n");
  std::ofstream(folder / "incremental-fractiles.csv")
      << "intensity,runs,fractile_16,fractile_50,fractile_84\n2,2,0.1,0.1,0.2\n3,2,0.3,0.3,inf\n4,2,0.7,0.7,"
         "inf\n";
  draw_figures(folder);
  EXPECT_TRUE(drawn(folder, "incremental"));
}

TEST(SweepFigures, AnOverturningSpectrumNamesOnlyWhatHappens) {
  const auto folder = folder_with(
      "overturning.csv",
      "period,frequency,intensity,runs,rest,rocking,toppled_after_impact,toppled_without_impact,failed\n"
      "0.5,2,1,1,1,0,0,0,0\n0.5,2,2,1,0,1,0,0,0\n0.25,4,1,1,1,0,0,0,0\n0.25,4,2,1,0,0,0,1,0\n");
  draw_figures(folder);
  EXPECT_TRUE(drawn(folder, "overturning"));
  const std::string svg = bytes_of(folder / "figures/overturning.svg");
  EXPECT_NE(svg.find("topples without an impact"), std::string::npos);
  EXPECT_EQ(svg.find("topples after an impact"), std::string::npos);
  EXPECT_EQ(svg.find("could not be solved"), std::string::npos);
}

// Shenton's boundaries meet where a block slides and rocks at once, at a push and a friction of width over
// height; towards ever stronger pushes the friction that holds a rocking block is (4 + r²)/(3 r).
TEST(SweepFigures, TheBoundariesOfOnsetMeetAndLevelOff) {
  for (const double r : {1.5, 2.0, 4.0}) {
    EXPECT_NEAR(rocking_friction(r, 1 / r), 1 / r, 1e-15);
    EXPECT_NEAR(rocking_friction(r, 1e12), (4 + r * r) / (3 * r), 1e-11);
  }
  EXPECT_NEAR(rocking_friction(2, 1), 0.608696, 5e-7);
}

TEST(SweepFigures, BoundariesOnFallingGroundEndWhereTheBlockFlies) {
  // Gravity 10, falling with half the push: at a = 20 nothing is left of the weight.
  std::istringstream lines(initiation_boundaries({2, 10, -0.5}, 30, 1.2));
  double largest = 0, at_corner = 0;
  for (double a = 0, friction = 0; lines >> a >> friction;) {
    EXPECT_LE(friction, 1.2);
    EXPECT_LE(a, 20 * (1 + 1e-8)) << "numbers have eight digits";
    largest = std::max(largest, a);
    // Tilting begins at a = 4, where 4/(10 − 2) is width over height.
    if (a == 4 && friction == 0.5) ++at_corner;
  }
  EXPECT_EQ(largest, 20);
  EXPECT_EQ(at_corner, 4) << "slide, rock, and slide-rock from below and from above";
}

TEST(SweepFigures, AMapOfModesHasBoundariesOnlyWhereTheyHold) {
  const auto folder = folder_with("modes.csv",
                                  "intensity,friction,runs,onset_rest,onset_slide,onset_rock,onset_slide_"
                                  "rock,onset_free_flight,rest,slide,"
                                  "rock,slide_rock,free_flight,topple,fall,failed\n"
                                  "2,0.3,1,1,0,0,0,0,1,0,0,0,0,0,0,0\n2,0.6,1,1,0,0,0,0,1,0,0,0,0,0,0,0\n"
                                  "4,0.3,1,0,1,0,0,0,0,1,0,0,0,0,0,0\n4,0.6,1,0,0,1,0,0,0,0,0,0,0,1,0,0\n");
  const auto describe = [&](const std::string& scene) {
    std::ofstream(folder / "sweep.json")
        << R"({"title": "t", "summary": {"intensity": "ground.horizontal.amplitude", "period": "",
            "friction": "contact.friction"}, "vary": [], "scene": {"blocks": [{"width": 1, "height": 2}], )"
        << scene << "}}";
    draw_figures(folder);
    return bytes_of(folder / "figures/modes.svg");
  };
  const std::string shaken = describe(R"("ground": {"horizontal": {"pulse": "rectangle", "period": 1}})");
  EXPECT_NE(shaken.find("Shenton"), std::string::npos);
  EXPECT_NE(shaken.find("topple"), std::string::npos);
  EXPECT_EQ(shaken.find("free flight"), std::string::npos) << "nothing flies";
  for (const char* other :
       {R"("ground": {"horizontal": {"pulse": "sine", "period": 1}})",
        R"("initial": {"angles": [0.1]}, "ground": {"horizontal": {"pulse": "rectangle"}})",
        R"("ground": {"horizontal": {"pulse": "rectangle"}, "vertical": {"pulse": "sine"}})"})
    EXPECT_EQ(describe(other).find("Shenton"), std::string::npos) << other;
}

TEST(SweepFigures, AMalformedFileIsNamed) {
  const auto folder = folder_with("fragility.csv", "intensity\n1\n");
  EXPECT_THROW(draw_figures(folder), InputError);
  std::ofstream(folder / "sweep.json") << "{";
  EXPECT_THROW(draw_figures(folder), InputError);
}

}  // namespace
}  // namespace rockstack::plots
