// Figures show what the results hold: pixels of gnuplot's pictures are held against the files that they are
// drawn from.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "plots/data/run_files.hpp"
#include "plots/data/selection.hpp"
#include "plots/drawing/style.hpp"
#include "plots/figures/figure.hpp"
#include "tests/plots/picture.hpp"
#include "tests/plots/sample.hpp"

namespace rockstack::plots {
namespace {

namespace fs = std::filesystem;
using testing::Picture;

/// A comparison of one block, and what one of its figures shows.
struct Shot {
  Comparison comparison;
  Picture picture;
};

Shot shot(const testing::Sample& sample, const std::string& figure) {
  const fs::path folder = testing::fresh_folder();
  testing::write_sample(folder, sample);
  Shot taken{read_comparison(folder), {}};
  draw_figures(folder, taken.comparison);
  taken.picture = testing::read_picture(folder / "figures" / ("sample." + figure + ".svg"));
  return taken;
}

std::string colour_of(const Run& run) {
  return testing::shown_colour(style_of(run).colour);
}

/// How far apart the highest and the lowest point of a colour's longest line are, pixels.
double extent_of(const Picture& picture, const std::string& colour) {
  const auto lines = picture.lines_of(colour);
  const auto longest = std::max_element(lines.begin(), lines.end(), [](const auto& a, const auto& b) {
    return a.points.size() < b.points.size();
  });
  if (longest == lines.end()) return 0;
  const auto [low, high] =
      std::minmax_element(longest->points.begin(), longest->points.end(),
                          [](const auto& a, const auto& b) { return a.second < b.second; });
  return high->second - low->second;
}

double spread_of(const std::vector<double>& values) {
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  return *high - *low;
}

TEST(RunSelection, CurvesHaveTheExtentOfTheirHistories) {
  const Shot taken = shot({.blocks = 1, .results = {"histories"}}, "histories");
  const double slope = std::abs(testing::left_axis(taken.picture, 0, taken.picture.height).slope);
  const RunSelection shown = shown_runs(taken.comparison, "sample");
  const double pixel = 1.5 * slope;
  EXPECT_NEAR(extent_of(taken.picture, "rgb(154,154,154)") * slope,
              spread_of(history_of(shown.exact.front())->angles), pixel);
  ASSERT_EQ(shown.engines.size(), 1u);
  const plots::Run engine = shown.engines.front();
  EXPECT_NEAR(extent_of(taken.picture, colour_of(engine)) * slope, spread_of(history_of(engine)->angles),
              pixel);
  EXPECT_TRUE(taken.picture.says("Largest angles: exact 0.1"));
}

// All rest from 0.1 s on in a scene of 5 s: an axis of 0.108 s, with a sample each millisecond.
TEST(RunSelection, CurvesOfPartOfTheTimeHaveAllOfItsSamples) {
  const fs::path folder = testing::fresh_folder();
  testing::write_sample(
      folder, {.steps = {1e-3}, .rests_from = 0.1, .tested = true, .readings = 1e-3, .slides = true});
  const Comparison comparison = read_comparison(folder);
  draw_figures(folder, comparison);
  const ComparedScene& scene = comparison.scenes.front();
  const std::string colour = colour_of(shown_runs(comparison, scene.name).engines.front());
  std::set<std::string> over_time;
  for (const Figure* figure : figures_of(scene)) {
    const Picture picture = testing::read_picture(figure_stem(folder, scene, *figure).concat(".svg"));
    if (std::ranges::find(picture.texts, "time (s)", &testing::ShownText::words) == picture.texts.end())
      continue;
    over_time.insert(figure->name);
    std::size_t most = 0;
    for (const testing::ShownLine& line : picture.lines_of(colour)) most = std::max(most, line.points.size());
    EXPECT_GE(most, 100u) << figure->name;  // a logarithmic axis leaves out what is nearly zero
  }
  EXPECT_EQ(over_time, (std::set<std::string>{"histories", "differences", "energy", "readings", "slip"}));
}

// Twelve impacts are told of, the last at 6 s, and the axis ends at 5 s with the exact curve.
TEST(RunSelection, ImpactsAfterTheAxisHaveNoTick) {
  const Shot taken = shot({.blocks = 1, .impacts = 12, .results = {"histories"}}, "histories");
  const auto rightmost = [&](const std::string& colour) {
    double most = 0;
    for (const testing::ShownLine& line : taken.picture.lines_of(colour)) {
      for (const auto& [x, y] : line.points) most = std::max(most, x);
    }
    return most;
  };
  ASSERT_GT(rightmost("rgb(154,154,154)"), 0);
  EXPECT_LE(rightmost("rgb(0,0,0)"), rightmost("rgb(154,154,154)") + 1.5);
}

// No line of a single step is dashed.
TEST(RunSelection, OneStepHasNoWordOfACoarserOne) {
  const testing::Sample one{.blocks = 1, .steps = {1e-2}, .results = {"histories"}};
  EXPECT_FALSE(shot(one, "histories").picture.says("coarsest"));
  EXPECT_TRUE(shot({.blocks = 1, .results = {"histories"}}, "histories").picture.says("coarsest"));
}

TEST(RunSelection, EachImpactIsAMarkAndSoIsWhatIsMissedOrAdded) {
  const Shot taken = shot({.blocks = 1, .impacts = 9}, "impact-times");
  const plots::Run engine = shown_runs(taken.comparison, "sample").engines.front();
  const auto impacts = impacts_of(engine);
  // And one in the legend.
  EXPECT_EQ(taken.picture.marks_of(colour_of(engine)).size(), impacts->size() + 1);
  EXPECT_TRUE(taken.picture.says("By engine: 8 impacts matched, in the median"));
}

// The run that is drawn has 8; that is one draw of five, whose median the row has.
TEST(RunSelection, ImpactsAreCountedInTheMedianOfReplicates) {
  const Shot taken = shot({.blocks = 1, .impacts = 9, .draws = 5}, "impact-times");
  EXPECT_TRUE(taken.picture.says("By engine: 9 impacts matched, in the median"));
  EXPECT_TRUE(taken.picture.says("counts are medians of replicates"));
}

// A row a solver and set, a column a time step: marks of one run stand at its rank and nowhere else.
TEST(RunSelection, RowsAreRankedFromAbove) {
  const Shot taken = shot({.blocks = 1,
                           .engines = {{"ode", "step", "default", 3e-3}, {"bullet", "nncg", "tuned", 1e-3}},
                           .steps = {1e-2, 1e-3},
                           .results = {"angles"}},
                          "ranking");
  const std::vector<plots::Run>& runs = taken.comparison.runs;
  const auto worse = taken.picture.marks_of(colour_of(runs[1])),
             better = taken.picture.marks_of(colour_of(runs[3]));
  ASSERT_EQ(worse.size(), 2u);
  ASSERT_EQ(better.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) EXPECT_LT(better[i].y, worse[i].y);
  // Both have a third and a thousandth of an error: a decade between steps is a decade along the axis of
  // either.
  EXPECT_LT(better[0].x, worse[0].x);
  EXPECT_NEAR(worse[0].x - better[0].x, worse[1].x - better[1].x, 0.5);
}

// In the file they stand in the other order.
TEST(RunSelection, AgreementHasTheSetsAsTheVerdictRanksThemAndItsScenesHaveNamesAndTitles) {
  const fs::path folder = testing::fresh_folder();
  testing::write_sample(folder,
                        {.blocks = 1,
                         .engines = {{"ode", "step", "tuned", 3e-3}, {"bullet", "nncg", "tuned", 1e-3}},
                         .results = {"angles"}});
  Comparison comparison = read_comparison(folder);
  comparison.verdict.ranking = {{.engine = "bullet", .solver = "nncg", .settings = "tuned"},
                                {.engine = "ode", .solver = "step", .settings = "tuned"}};
  draw_figures(folder, comparison);
  const Picture picture = testing::read_picture(folder / "figures/agreement.svg");
  const auto height_of = [&](const RankedSet& set) {
    const auto run = std::ranges::find(comparison.runs, set.engine, &plots::Run::engine);
    return picture.lines_of(colour_of(*run)).front().points.front().second;
  };
  EXPECT_LT(height_of(comparison.verdict.ranking[0]), height_of(comparison.verdict.ranking[1]));
  EXPECT_TRUE(picture.says("sample"));
  EXPECT_TRUE(picture.says(comparison.scenes.front().title));
  EXPECT_EQ(testing::collisions(picture), std::vector<std::string>());
}

// The exact rotation is half of the slenderness angle, engines' are so much larger as they are late.
TEST(RunSelection, NormalizedRotationsStandBesideTheExactOne) {
  const Shot taken = shot({.blocks = 1, .steps = {1e-2}, .results = {"angles"}}, "peaks");
  const plots::Run& run = taken.comparison.runs[1];
  const std::vector<testing::ShownMark> marks = taken.picture.marks_of(colour_of(run));
  const std::vector<testing::ShownLine> exact = taken.picture.lines_of("rgb(154,154,154)"),
                                        brink = taken.picture.lines_of("rgb(102,102,102)");
  ASSERT_EQ(marks.size(), 1u);
  const auto place = [](const testing::ShownLine& line) { return line.points.front().first; };
  // The longest lines are those of the panel, the others the legend's.
  const auto upright = [&](const std::vector<testing::ShownLine>& lines) {
    const auto found = std::ranges::find_if(lines, [](const testing::ShownLine& line) {
      return line.points.front().first == line.points.back().first;
    });
    return place(*found);
  };
  EXPECT_NEAR((marks.front().x - upright(exact)) / (upright(brink) - upright(exact)),
              (*run.peak_over_slenderness - 0.5) / 0.5, 0.01);
  EXPECT_EQ(testing::collisions(taken.picture), std::vector<std::string>());
}

TEST(RunSelection, DifferencesPassTheToleranceWhereTheFileDoes) {
  const Shot taken = shot({.blocks = 1, .results = {"histories"}}, "differences");
  const plots::Run engine = shown_runs(taken.comparison, "sample").engines.front();
  EXPECT_TRUE(taken.picture.says("tolerance"));
  // The large mark of the lowest row stands at the time, between the panel's edges at 0 and at 1.012 times 5
  // s.
  const auto marks = taken.picture.marks_of(colour_of(engine));
  const auto lowest =
      std::max_element(marks.begin(), marks.end(), [](const auto& a, const auto& b) { return a.y < b.y; });
  ASSERT_NE(lowest, marks.end());
  const double left = 0.105 * taken.picture.width, right = 0.975 * taken.picture.width;
  EXPECT_NEAR(left + (right - left) * *engine.agreement_time / (1.012 * 5), lowest->x, 1.5);
}

/// How long the only line of a colour is, pixels.
double length_of(const Picture& picture, const std::string& colour) {
  const auto lines = picture.lines_of(colour);
  EXPECT_EQ(lines.size(), 1u) << colour;
  return lines.empty() ? 0 : lines.front().points.back().first - lines.front().points.front().first;
}

// Those of rows that agree to the end reach the edge, which is 8 % behind the end of the motion.
TEST(RunSelection, LinesOfAgreementEndWhereRowsStopToAgree) {
  constexpr double coarse = 1, whole = 5, rests_from = 2;  // s
  for (const bool rests : {false, true}) {
    const fs::path folder = testing::fresh_folder();
    testing::write_sample(folder, {.blocks = 1,
                                   .steps = {1e-2, 1e-3},
                                   .rests_from = rests ? rests_from : whole,
                                   .results = {"angles", "histories"}});
    const Comparison comparison = read_comparison(folder);
    draw_figures(folder, comparison);
    const std::string colour = style_of(comparison.runs[1]).colour;
    for (const char* file : {"agreement.svg", "agreement.narrow.svg"}) {
      const Picture picture = testing::read_picture(folder / "figures" / file);
      EXPECT_EQ(testing::collisions(picture), std::vector<std::string>()) << file;
      EXPECT_NEAR(length_of(picture, testing::shown_colour(paler(colour, 0.5))) /
                      length_of(picture, testing::shown_colour(colour)),
                  coarse / (rests ? 1.08 * rests_from : whole), 0.01)
          << file;
    }
    EXPECT_TRUE(
        testing::read_picture(folder / "figures/agreement.svg")
            .says(
                "1 of 2 runs (solver × set × scene × step) stay within 10 mrad and 1 % of the least block height"));
  }
}

TEST(RunSelection, FiguresOverTimeExplainWhatLiesBeyondTheHorizon) {
  for (const double horizon : {2.0, 5.0}) {
    const fs::path folder = testing::fresh_folder();
    testing::write_sample(folder, {.blocks = 1, .predictable_time = horizon, .shaken = true});
    draw_figures(folder, read_comparison(folder));
    for (const char* figure :
         {"agreement", "sample.histories", "sample.differences", "sample.energy", "sample.ground-motion"})
      EXPECT_EQ(testing::read_picture(folder / "figures" / (std::string(figure) + ".svg"))
                    .says("beyond the horizon of predictability"),
                horizon < 5)
          << figure;
  }
}

// An engine whose forces are all larger by 2 %: marks of impulses stand there, and the answers say so.
TEST(Forces, AreShownAsFarOffAsTheyAre) {
  const testing::Sample sample{.blocks = 1, .steps = {1e-2}, .results = {"histories", "forces"}};
  const Shot impulses = shot(sample, "impulses"), forces = shot(sample, "forces");
  EXPECT_TRUE(impulses.picture.says("Off by 2 % of all exact impulses"));
  EXPECT_TRUE(forces.picture.says("off by 2 % of the weight above"));
}

}  // namespace
}  // namespace rockstack::plots
