#include "plots/figures/figure.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <stdexcept>

#include "analytic/scene/messages/input_error.hpp"
#include "plots/drawing/axes.hpp"
#include "plots/drawing/gnuplot.hpp"
#include "plots/drawing/layout.hpp"
#include "tests/plots/picture.hpp"
#include "tests/plots/sample.hpp"

namespace rockstack::plots {
namespace {

namespace fs = std::filesystem;

/// Width or height from a PNG's first chunk: four bytes, the highest first.
unsigned png_number(const std::string& bytes, std::size_t at) {
  unsigned value = 0;
  for (std::size_t i = 0; i < 4; ++i) value = value * 256 + static_cast<unsigned char>(bytes.at(at + i));
  return value;
}

/// Draws all figures of a folder; each is a picture in three formats whose words can be read, with its
/// question.
void expect_figures(const fs::path& folder) {
  const Comparison comparison = read_comparison(folder);
  draw_figures(folder, comparison);
  const ComparedScene& scene = comparison.scenes.at(0);
  for (const Figure* figure : figures_of(scene)) {
    const fs::path stem = figure_stem(folder, scene, *figure);
    const std::string png = testing::bytes_of(fs::path(stem).concat(".png"));
    ASSERT_EQ(png.substr(0, 8), "\x89PNG\r\n\x1a\n") << figure->name;
    EXPECT_EQ(png_number(png, 16), 1200u) << figure->name;
    EXPECT_GE(png_number(png, 20), 150u) << figure->name;
    EXPECT_EQ(testing::bytes_of(fs::path(stem).concat(".pdf")).substr(0, 5), "%PDF-") << figure->name;
    EXPECT_LT(fs::file_size(fs::path(stem).concat(".svg")), 400'000u) << figure->name;
    const testing::Picture picture = testing::read_picture(fs::path(stem).concat(".svg"));
    EXPECT_EQ(testing::collisions(picture), std::vector<std::string>()) << figure->name;
    EXPECT_TRUE(picture.says(scene.heading)) << figure->name;
  }
}

/// Tables of curves do not count.
std::size_t pictures_in(const fs::path& folder) {
  std::size_t count = 0;
  if (fs::exists(folder))
    for (const auto& entry : fs::directory_iterator(folder))
      if (entry.path().extension() != ".csv") ++count;
  return count;
}

std::vector<std::string> names_of_figures(const testing::Sample& sample) {
  const fs::path folder = testing::fresh_folder();
  testing::write_sample(folder, sample);
  std::vector<std::string> names;
  for (const Figure* figure : figures_of(read_comparison(folder).scenes.at(0))) names.push_back(figure->name);
  return names;
}

fs::path draw_sample(const testing::Sample& sample) {
  fs::path folder = testing::fresh_folder();
  testing::write_sample(folder, sample);
  expect_figures(folder);
  const std::size_t of_all_scenes = sample.engines.empty() ? 0 : 2;  // wide and narrow
  EXPECT_EQ(pictures_in(folder / "figures"),
            3 * (of_all_scenes + figures_of(read_comparison(folder).scenes.at(0)).size()));
  return folder;
}

testing::SampleEngine ode() {
  return {"ode", "step", "default", 3e-3};
}

TEST(Figures, OneEngineOneBlock) {
  draw_sample({.blocks = 1});
}

TEST(Figures, TwoEnginesThreeBlocksAndAFailedRow) {
  draw_sample({.blocks = 3, .engines = {{"bullet", "nncg", "tuned", 2e-3}, ode()}, .failed_row = true});
}

TEST(Figures, MoreSeriesThanOnePanelBearsHaveAPanelEach) {
  testing::Sample sample{.blocks = 1, .engines = {}, .steps = {1e-2}};
  for (const char* engine : {"bullet", "bullet-single"})
    for (const char* solver : {"sequential-impulse", "nncg", "mlcp-dantzig", "mlcp-pgs"})
      sample.engines.push_back({engine, solver, "tuned", 2e-3});
  const fs::path folder = draw_sample(sample);
  const std::string svg = testing::bytes_of(folder / "figures/sample.differences.svg");
  for (const testing::SampleEngine& engine : sample.engines)
    EXPECT_NE(svg.find(engine.engine + " " + engine.solver + ", tuned"), std::string::npos);
  // Numbers that another panel shows are not seen, in SVG as elsewhere.
  EXPECT_NE(svg.find(R"(fill="none" font-family)"), std::string::npos);
  EXPECT_EQ(svg.find("rgb(1,2,3)"), std::string::npos);
}

TEST(Figures, SlidingAndFlightAreDrawnAndTold) {
  const fs::path folder = draw_sample({.steps = {1e-2}, .slides = true, .results = {"histories"}});
  const testing::Picture slip = testing::read_picture(folder / "figures/sample.slip.svg");
  EXPECT_TRUE(slip.says("500 mm at interface 1 (exact)"));
  EXPECT_TRUE(slip.says("interface 1 from 1 to 1.5 s"));
}

TEST(Figures, WhatATestHasMeasuredStandsOverAllMotions) {
  for (const std::vector<double>& steps : {std::vector{1e-2}, std::vector{1e-2, 1e-3}}) {
    const fs::path folder = draw_sample({.engines = {{"bullet", "nncg", "tuned", 2e-3}, ode()},
                                         .steps = steps,
                                         .tested = true,
                                         .results = {"histories"}});
    const testing::Picture picture = testing::read_picture(folder / "figures/sample.readings.svg");
    EXPECT_TRUE(picture.says("base of a_b (m)"));
    EXPECT_TRUE(picture.says("measured"));
    EXPECT_TRUE(picture.says("exact by 0.002 m"));
    EXPECT_TRUE(picture.says("the nearest engine bullet nncg, tuned by"));
    EXPECT_TRUE(testing::collisions(picture).empty());
  }
}

TEST(Figures, AGroundThatMovesHasAFigureOfItsOwn) {
  draw_sample({.blocks = 1, .shaken = true});
}

using Names = std::vector<std::string>;

TEST(Figures, AreThoseThatTheResultsHaveDataFor) {
  EXPECT_EQ(names_of_figures({}),
            (Names{"histories", "differences", "impact-times", "impact-energy", "ranking", "peaks",
                   "amplitude-phase", "error-time", "energy", "phase", "occupancy"}));
  EXPECT_EQ(names_of_figures({.results = {"angles"}}),
            (Names{"ranking", "peaks", "amplitude-phase", "error-time"}));
  EXPECT_EQ(names_of_figures({.results = {"patterns"}}), Names{"occupancy"});
  EXPECT_EQ(names_of_figures({.shaken = true, .results = {}}), Names{"ground-motion"});
  EXPECT_EQ(names_of_figures({.results = {"histories", "forces"}}),
            (Names{"histories", "differences", "forces", "impulses", "phase"}));
  EXPECT_EQ(names_of_figures({.slides = true, .results = {"histories"}}),
            (Names{"histories", "slip", "differences", "phase"}));
}

constexpr const char* two_fits = R"([
  {"scene": "sample", "engine": "bullet", "solver": "nncg", "settings": "tuned", "quantity": "rms_angle_difference",
   "steps": 5, "gap": 1e-4, "gap_low": 5e-5, "gap_high": 2e-4, "order": 1, "order_low": 0.9, "order_high": 1.1,
   "coefficient": 2, "scatter": 0.1, "holds": true, "reason": ""},
  {"scene": "sample", "engine": "ode", "solver": "step", "settings": "default", "quantity": "rms_angle_difference",
   "steps": 4, "gap": null, "gap_low": null, "gap_high": null, "order": null, "order_low": null, "order_high": null,
   "coefficient": null, "scatter": null, "holds": false, "reason": "4 steps are fewer than 5"}])";

TEST(Figures, ForcesOfFewAndOfManyEngines) {
  draw_sample({.blocks = 1, .results = {"histories", "forces"}});
  std::vector<testing::SampleEngine> many;
  for (const char* solver : {"nncg", "mlcp-pgs", "mlcp-lemke", "mlcp-dantzig"})
    for (const char* settings : {"default", "tuned"}) many.push_back({"bullet", solver, settings, 2e-3});
  draw_sample({.engines = many, .steps = {1e-3}, .results = {"histories", "forces"}});
}

TEST(Figures, FitsAreDrawnWhereTheyHold) {
  draw_sample(
      {.engines = {{"bullet", "nncg", "tuned", 2e-3}, ode()}, .steps = {1e-2, 1e-3}, .fits = two_fits});
}

TEST(Figures, AQuartileWithoutAnyErrorHasAPlaceOnALogarithmicAxis) {
  const fs::path folder = testing::fresh_folder();
  testing::write_sample(folder, {.engines = {ode()}, .steps = {1e-2, 1e-3}, .fits = two_fits});
  Comparison comparison = read_comparison(folder);
  for (plots::Run& run : comparison.runs) {
    run.rms_angle_difference_lower = 0;
    run.rms_angle_difference_upper = run.rms_angle_difference;
  }
  EXPECT_NO_THROW(draw_figures(folder, comparison));
}

TEST(Figures, DistributionsOverPerturbedScenes) {
  draw_sample(
      {.engines = {ode()},
       .steps = {1e-2},
       .distributions = R"([{"scene": "sample", "run": "sample.ode.step.default.0.01", "quantity": "impacts",
                            "exact_runs": 19, "runs": 19, "exact_mean": 21.5, "mean": 21.5, "distance": 0.4,
                            "critical": 0.3, "p_value": 0.01}])"});
}

TEST(Figures, NoImpacts) {
  draw_sample({.impacts = 0});
}

TEST(Figures, NoEngineButTheExactSolver) {
  draw_sample({.engines = {}});
}

TEST(Figures, ManyBlocksStaySmall) {
  draw_sample({.blocks = 12, .engines = {{"bullet", "nncg", "tuned", 2e-3}, ode()}, .steps = {1e-3}});
}

TEST(Figures, TitlesWithQuotesAndMarkupAreDrawnAsTheyAre) {
  draw_sample({.title = "It's `odd`_{x} ^2 @ 100% $HOME", .engines = {ode()}, .steps = {1e-2}});
}

TEST(Figures, AnEngineThatStandsExactlyOnTheExactSolution) {
  draw_sample({.engines = {{"ode", "step", "tuned", 1e-300}}, .steps = {1e-2}});
}

TEST(Figures, AMissingHistoryIsNamedAndNoFigureIsLeftHalfDrawn) {
  const fs::path folder = testing::fresh_folder();
  testing::write_sample(folder, {.engines = {ode()}, .steps = {1e-2}});
  const fs::path history = folder / "runs" / "sample.exact" / "history.csv";
  fs::remove(history);
  try {
    draw_figures(folder, read_comparison(folder));
    FAIL() << "no InputError";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find(history.string()), std::string::npos) << error.what();
  }
  EXPECT_EQ(pictures_in(folder / "figures"), 0u);
}

}  // namespace
}  // namespace rockstack::plots
