#include "plots/figures/comparison/figures.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <stdexcept>

#include "analytic/scene/messages/input_error.hpp"
#include "plots/drawing/axes.hpp"
#include "plots/drawing/gnuplot.hpp"
#include "plots/drawing/layout.hpp"
#include "plots/figures/comparison/drawings.hpp"
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

/// The kinds of figures that the sample has.
std::vector<FigureKind> kinds_of(const fs::path& folder) {
  const ComparedScene scene = read_comparison(folder).scenes.at(0);
  std::vector<FigureKind> kinds;
  for (const FigureKind& kind : figure_kinds())
    if (has_figure(scene, kind)) kinds.push_back(kind);
  return kinds;
}

void expect_figures(const fs::path& folder) {
  for (const FigureKind& kind : kinds_of(folder)) {
    const fs::path stem = figure_stem(folder, "sample", kind.name);
    const std::string png = testing::bytes_of(fs::path(stem).concat(".png"));
    ASSERT_EQ(png.substr(0, 8), "\x89PNG\r\n\x1a\n") << kind.name;
    EXPECT_EQ(png_number(png, 16), 1200u) << kind.name;
    EXPECT_GE(png_number(png, 20), 150u) << kind.name;
    const std::string svg = testing::bytes_of(fs::path(stem).concat(".svg"));
    EXPECT_NE(svg.find("<svg"), std::string::npos) << kind.name;
    EXPECT_NE(svg.find("</svg>"), std::string::npos) << kind.name;
    EXPECT_LT(svg.size(), 400'000u) << kind.name;
    EXPECT_EQ(testing::bytes_of(fs::path(stem).concat(".pdf")).substr(0, 5), "%PDF-") << kind.name;
  }
}

std::size_t files_in(const fs::path& folder) {
  std::size_t count = 0;
  if (fs::exists(folder))
    for ([[maybe_unused]] const auto& entry : fs::directory_iterator(folder)) ++count;
  return count;
}

std::vector<std::string> names_of_figures(const testing::Sample& sample) {
  const fs::path folder = testing::fresh_folder();
  testing::write_sample(folder, sample);
  std::vector<std::string> names;
  for (const FigureKind& kind : kinds_of(folder)) names.push_back(kind.name);
  return names;
}

void draw_sample(const testing::Sample& sample) {
  const fs::path folder = testing::fresh_folder();
  testing::write_sample(folder, sample);
  draw_figures(folder);
  expect_figures(folder);
  EXPECT_EQ(files_in(folder / "figures"), 3 * kinds_of(folder).size());
}

testing::SampleEngine ode() {
  return {"ode", "step", "default", 3e-3};
}

/// Sets PATH for as long as it lives.
struct SearchPath {
  std::string before = std::getenv("PATH");
  explicit SearchPath(const std::string& path) { ::setenv("PATH", path.c_str(), 1); }
  ~SearchPath() { ::setenv("PATH", before.c_str(), 1); }
  SearchPath(const SearchPath&) = delete;
  SearchPath& operator=(const SearchPath&) = delete;
};

/// A program named gnuplot that does what `body` says.
fs::path false_gnuplot(const fs::path& folder, const std::string& body) {
  fs::create_directories(folder);
  std::ofstream(folder / "gnuplot") << "#!/bin/sh\n" << body << "\n";
  fs::permissions(folder / "gnuplot", fs::perms::owner_all);
  return folder;
}

std::string failure_with(const std::string& path, const fs::path& stem) {
  const SearchPath search(path);
  try {
    draw(Drawing{.data = std::string(200'000, '#') + "\n", .commands = "plot x"}, stem);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

TEST(Figures, OneEngineOneBlock) {
  draw_sample({.blocks = 1});
}

TEST(Figures, TwoEnginesThreeBlocksAndAFailedRow) {
  draw_sample({.blocks = 3, .engines = {{"bullet", "nncg", "tuned", 2e-3}, ode()}, .failed_row = true});
}

TEST(Figures, EachKindAsksWhatItsExplanationBeginsWith) {
  for (const FigureKind& kind : figure_kinds())
    EXPECT_NE(kind.explanation.substr(0, kind.explanation.find('.')).find('?'), std::string::npos)
        << kind.name;
}

TEST(Figures, MoreSeriesThanOnePanelBearsHaveAPanelEach) {
  testing::Sample sample{.blocks = 1, .engines = {}, .steps = {1e-2}};
  for (const char* engine : {"bullet", "bullet-single"})
    for (const char* solver : {"sequential-impulse", "nncg", "mlcp-dantzig", "mlcp-pgs"})
      sample.engines.push_back({engine, solver, "tuned", 2e-3});
  const fs::path folder = testing::fresh_folder();
  testing::write_sample(folder, sample);
  draw_figures(folder);
  expect_figures(folder);
  const std::string svg = testing::bytes_of(figure_stem(folder, "sample", "differences").concat(".svg"));
  for (const testing::SampleEngine& engine : sample.engines)
    EXPECT_NE(svg.find(engine.engine + " " + engine.solver + ", tuned"), std::string::npos);
  // Numbers that another panel shows are not seen, in SVG as elsewhere.
  EXPECT_NE(svg.find(R"(fill="none" font-family)"), std::string::npos);
  EXPECT_EQ(svg.find("rgb(1,2,3)"), std::string::npos);
}

TEST(Figures, SlidingAndFlightAreDrawnAndTold) {
  const fs::path folder = testing::fresh_folder();
  testing::write_sample(folder, {.steps = {1e-2}, .slides = true, .results = R"(["histories"])"});
  draw_figures(folder);
  expect_figures(folder);
  const std::string svg = testing::bytes_of(figure_stem(folder, "sample", "slip").concat(".svg"));
  EXPECT_NE(svg.find("500 mm at interface 1 (exact)"), std::string::npos);
  EXPECT_NE(svg.find("interface 1 from 1 to 1.5 s"), std::string::npos);
}

TEST(Figures, AGroundThatMovesHasAFigureOfItsOwn) {
  draw_sample({.blocks = 1, .shaken = true});
}

using Names = std::vector<std::string>;

TEST(Figures, AreThoseThatTheResultsHaveDataFor) {
  EXPECT_EQ(names_of_figures({}), (Names{"histories", "differences", "impact-times", "impact-energy",
                                         "ranking", "error-time", "energy", "phase", "occupancy"}));
  EXPECT_EQ(names_of_figures({.results = R"(["angles"])"}), (Names{"ranking", "error-time"}));
  EXPECT_EQ(names_of_figures({.results = R"(["patterns"])"}), Names{"occupancy"});
  EXPECT_EQ(names_of_figures({.shaken = true, .results = "[]"}), Names{"ground-motion"});
  EXPECT_EQ(names_of_figures({.slides = true, .results = R"(["histories"])"}),
            (Names{"histories", "slip", "differences", "phase"}));
}

constexpr const char* two_fits = R"([
  {"scene": "sample", "engine": "bullet", "solver": "nncg", "settings": "tuned", "quantity": "rms_angle_difference",
   "gap": 1e-4, "gap_low": 5e-5, "gap_high": 2e-4, "order": 1, "order_low": 0.9, "order_high": 1.1,
   "coefficient": 2, "holds": true, "reason": ""},
  {"scene": "sample", "engine": "ode", "solver": "step", "settings": "default", "quantity": "rms_angle_difference",
   "gap": null, "gap_low": null, "gap_high": null, "order": null, "order_low": null, "order_high": null,
   "coefficient": null, "holds": false, "reason": "4 steps are fewer than 5"}])";

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
  EXPECT_NO_THROW(draw(error_step(comparison, comparison.scenes.at(0)), folder / "error-step"));
}

TEST(Figures, DistributionsOverPerturbedScenes) {
  draw_sample(
      {.engines = {ode()},
       .steps = {1e-2},
       .distributions = R"([{"scene": "sample", "run": "sample.ode.step.default.0.01", "quantity": "impacts",
                                     "distance": 0.4, "critical": 0.3}])"});
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
    draw_figures(folder);
    FAIL() << "no InputError";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find(history.string()), std::string::npos) << error.what();
  }
  EXPECT_EQ(files_in(folder / "figures"), 0u);
}

TEST(Figures, GnuplotsOwnWordsStandInTheError) {
  const fs::path stem = testing::fresh_folder() / "broken";
  try {
    draw(Drawing{.data = "", .commands = "plot no_such_thing"}, stem);
    FAIL() << "no error";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("undefined variable: no_such_thing"), std::string::npos)
        << error.what();
  }
  EXPECT_EQ(files_in(stem.parent_path()), 0u);
}

TEST(Figures, GnuplotThatIsNotThereIsNamed) {
  const fs::path folder = testing::fresh_folder();
  EXPECT_NE(failure_with((folder / "empty").string(), folder / "picture").find("gnuplot is not installed"),
            std::string::npos);
  EXPECT_EQ(files_in(folder), 0u);
}

TEST(Figures, GnuplotThatDiesHalfwayLeavesNothing) {
  const fs::path folder = testing::fresh_folder();
  const fs::path programs = false_gnuplot(folder / "programs", "echo half > picture.png; kill -9 $$");
  EXPECT_NE(failure_with(programs.string(), folder / "out" / "picture").find("status 137"),
            std::string::npos);
  EXPECT_EQ(files_in(folder / "out"), 0u);
}

TEST(Figures, GnuplotThatSaysItIsDoneButIsNotLeavesNothing) {
  const fs::path folder = testing::fresh_folder();
  const fs::path programs = false_gnuplot(folder / "programs", "echo half > picture.png; exit 0");
  EXPECT_NE(failure_with(programs.string(), folder / "out" / "picture").find("unfinished"),
            std::string::npos);
  EXPECT_EQ(files_in(folder / "out"), 0u);
}

TEST(Figures, GnuplotThatHangsIsEnded) {
  const fs::path folder = testing::fresh_folder();
  const SearchPath path(false_gnuplot(folder / "programs", "exec /bin/sleep 1000").string());
  try {
    draw(Drawing{.data = "", .commands = std::string(200'000, '\n'), .time_limit = 0.1}, folder / "picture");
    FAIL() << "no error";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("gnuplot has not drawn"), std::string::npos) << error.what();
  }
}

TEST(Figures, TheUsersTerminalDoesNotCount) {
  const fs::path folder = testing::fresh_folder();
  ::setenv("GNUTERM", "no-such-terminal", 1);
  EXPECT_NO_THROW(draw(Drawing{.data = "", .commands = "plot x"}, folder / "picture"));
  ::unsetenv("GNUTERM");
}

TEST(Figures, TextIsDrawnAsItStandsWhateverSignsItHas) {
  const fs::path folder = testing::fresh_folder();
  for (const std::string text : {"'quoted'", "''", "\"double\"", "back\\slash \\n", "`touch ran`",
                                 "@macro $x %g", "Blöcke θ₁ {_^} & <b>"}) {
    draw(Drawing{.data = "", .commands = "set title " + in_quotes(text) + " noenhanced\nplot x"},
         folder / "picture");
    std::string shown = text;
    for (const auto& [sign, word] : {std::pair{"&", "&amp;"}, {"<", "&lt;"}})
      if (const auto at = shown.find(sign); at != std::string::npos) shown.replace(at, 1, word);
    EXPECT_NE(testing::bytes_of(folder / "picture.svg").find(shown), std::string::npos) << text;
  }
  EXPECT_FALSE(fs::exists("ran"));
}

TEST(LinearTics, AreRoundAndHaveRoom) {
  EXPECT_EQ(linear_tics("y", 0, 1, 300), "set ytics 0.1\n");
  EXPECT_EQ(linear_tics("y", -3, 4, 110), "set ytics 2\n");
  EXPECT_EQ(linear_tics("x", 0, 0.3, 340), "set xtics 0.1\n");
}

TEST(LogarithmicTics, ArePowersOfTenAndWithinTwoDecadesTheirMultiplesToo) {
  EXPECT_EQ(logarithmic_tics("x", 1e-4, 1e-2, 300), "set format x '10^{%T}'\nset xtics 0.0001, 10\n");
  EXPECT_EQ(logarithmic_tics("x", 1e-6, 1e-1, 300), "set format x '10^{%T}'\nset xtics 1e-06, 100\n");
  EXPECT_EQ(logarithmic_tics("y", 0.02, 0.5, 300),
            "set ytics ('3·10^{-2}' 0.03, '10^{-1}' 0.1, '3·10^{-1}' 0.3)\n");
  EXPECT_EQ(logarithmic_tics("y", 0.2, 0.9, 300),
            "set ytics ('2·10^{-1}' 0.2, '3·10^{-1}' 0.3, '5·10^{-1}' 0.5, '7·10^{-1}' 0.7)\n");
  EXPECT_EQ(logarithmic_tics("x", 0.027, 0.08, 185), "set xtics ('3.5·10^{-2}' 0.035, '6·10^{-2}' 0.06)\n");
}

}  // namespace
}  // namespace rockstack::plots
