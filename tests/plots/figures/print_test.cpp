// Figures for print: pictures of gnuplot are held against what was asked for and the files that they are of.

#include <gtest/gtest.h>

#include <fstream>

#include "comparisons/measures/results/csv.hpp"
#include "plots/data/run_files.hpp"
#include "plots/figures/figure.hpp"
#include "tests/plots/picture.hpp"
#include "tests/plots/sample.hpp"

namespace rockstack::plots {
namespace {

using testing::Picture;

/// How far the numbers left of panels stay from their turned words, pixels; letters are as wide as 14 pt of a
/// screen have them.
double room_beside(const Picture& picture) {
  constexpr double letter = 10.5, half_line = 9;
  const auto letters = [](const std::string& words) {
    return static_cast<double>(std::ranges::count_if(words, [](char c) { return (c & 0xC0) != 0x80; }));
  };
  double room = HUGE_VAL;
  for (const testing::ShownText& words : picture.texts)
    for (const testing::ShownText& number : picture.texts)
      if (words.turned && !number.turned && number.anchor == "end" && number.x > words.x)
        room = std::min(room, number.x - letter * letters(number.words) - words.x - half_line);
  return room;
}

/// A comparison whose motion is drawn in several styles.
struct PrintedSample {
  fs::path folder = testing::fresh_folder();
  PrintedFigures printed = {};

  explicit PrintedSample(const testing::Sample& sample) { testing::write_sample(folder, sample); }

  Picture draw(PrintStyle style) {
    if (style.figures.empty()) style.figures = {"motion"};
    printed = print_figures(folder, style);
    return testing::read_picture(fs::path(printed.stems.at(0)).concat(".svg"));
  }
  Table table() const { return read_table(fs::path(printed.stems.at(0)).concat(".csv")); }
};

std::string print_error(PrintedSample& sample, const PrintStyle& style) {
  try {
    sample.draw(style);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

testing::Sample sliding() {
  return {.title = "A made-up scene of two blocks that slide on a floor and on each other",
          .steps = {1e-2},
          .shaken = true,
          .slides = true};
}

TEST(Print, LettersNeitherCollideNorLeaveAFigureOfAnyWidth) {
  PrintedSample sample(sliding());
  for (const double width : {60.0, 88.0, 180.0})
    for (const auto& panels : {std::vector<std::string>{"θ2"},
                               {"θ", "ground"},
                               {"theta2", "slip", "gap1"},
                               {"θ", "slip"},
                               {"θ1", "ω", "Δθ", "ground", "gap"}}) {
      const Picture picture = sample.draw({.width = width, .panels = panels});
      EXPECT_EQ(testing::collisions(picture), std::vector<std::string>()) << width << " " << panels.front();
      EXPECT_NEAR(picture.width, width / 25.4 * 168, 1) << "8 pt are 14 pt at 168 dots an inch";
      EXPECT_GE(room_beside(picture), 0) << width << " " << panels.front();
      EXPECT_TRUE(picture.says("time (s)"));
      EXPECT_TRUE(picture.says("tuned, 10 ms")) << "in as many lines as it needs";
    }
}

TEST(Print, AFigureHasItsWidthOnPaper) {
  PrintedSample sample(sliding());
  sample.draw({.width = 88, .titles = false});
  const fs::path stem = sample.printed.stems.at(0);
  EXPECT_NE(testing::bytes_of(fs::path(stem).concat(".svg")).find(" width=\"87.99mm\""), std::string::npos);
  const std::string png = testing::bytes_of(fs::path(stem).concat(".png"));
  const unsigned dots =
      static_cast<unsigned char>(png.at(18)) * 256U + static_cast<unsigned char>(png.at(19));
  EXPECT_NEAR(dots, 88 / 25.4 * 300, 2);
  EXPECT_EQ(testing::bytes_of(fs::path(stem).concat(".pdf")).substr(0, 5), "%PDF-");
}

TEST(Print, PanelsAreInTwoColumnsWhereTheyAreFour) {
  PrintedSample sample(sliding());
  const auto columns = [&](const std::vector<std::string>& panels) {
    std::set<long> places;
    for (const testing::ShownText& text : sample.draw({.width = 180, .panels = panels}).texts)
      if (text.turned) places.insert(std::lround(text.x));
    return places.size();
  };
  EXPECT_EQ(columns({"θ", "slip1"}), 1U);
  EXPECT_EQ(columns({"θ", "slip"}), 2U);
}

TEST(Print, AnglesAreInTheUnitAskedForAndOfSmallOnesInMilliradians) {
  PrintedSample sample(sliding());
  const double largest =
      largest_magnitude(history_of(done_runs(read_comparison(sample.folder), "sample").front())->angles);
  const auto drawn = [&](PrintStyle::Unit unit) {
    sample.draw({.unit = unit});
    double most = 0;
    for (const auto& row : sample.table().rows)
      if (row.at(2) == "exact") most = std::max(most, std::abs(number_in(row.at(6)).value_or(0)));
    return most;
  };
  EXPECT_NEAR(drawn(PrintStyle::Unit::rad), largest, 1e-5);
  EXPECT_NEAR(drawn(PrintStyle::Unit::mrad), 1e3 * largest, 1e-2);
  EXPECT_NEAR(drawn(PrintStyle::Unit::deg), largest * 180 / std::numbers::pi, 1e-3);
  EXPECT_STREQ(angle_unit(0.1).name, "rad");
  EXPECT_STREQ(angle_unit(2e-3).name, "mrad");
  EXPECT_STREQ(angle_unit(1e-6).name, "µrad");
}

TEST(Print, TimeIsThatAskedFor) {
  PrintedSample sample(sliding());
  sample.draw({.from = 1.25, .to = 2.5});
  double least = HUGE_VAL, most = 0;
  for (const auto& row : sample.table().rows) {
    least = std::min(least, number_in(row.at(5)).value());
    most = std::max(most, number_in(row.at(5)).value());
  }
  constexpr double sample_apart = 0.0101;
  EXPECT_NEAR(least, 1.25, sample_apart);
  EXPECT_NEAR(most, 2.5, sample_apart);
}

// The one that is nearer lies on the exact motion.
TEST(Print, AVariantThatIsTheExactMotionIsLeftOut) {
  PrintedSample sample(
      {.engines = {{"consistent", "taylor", "", 0}, {"unilateral", "taylor", "", 2e-2}}, .steps = {1e-2}});
  const Picture picture = sample.draw({});
  ASSERT_EQ(sample.printed.left_out.size(), 1U);
  EXPECT_TRUE(sample.printed.left_out.front().starts_with("exact, law consistent"));
  EXPECT_TRUE(sample.printed.left_out.front().ends_with(": lies on the exact motion"));
  EXPECT_FALSE(picture.says("exact, law consistent"));
  EXPECT_TRUE(picture.says("exact, law unilateral"));
}

TEST(Print, OptionsChooseTheFiguresForWhichTheyHaveAMeaning) {
  PrintedSample sample({.blocks = 1, .steps = {1e-2}});
  const auto drawn = [&](const PrintStyle& style) {
    return mapped(print_figures(sample.folder, style).stems,
                  [](const fs::path& stem) { return stem.filename().string(); });
  };
  EXPECT_EQ(drawn({.panels = {"θ", "ω"}}), std::vector<std::string>{"sample.motion"});
  EXPECT_EQ(drawn({.unit = PrintStyle::Unit::deg}),
            (std::vector<std::string>{"sample.motion", "sample.histories", "sample.differences"}));
  EXPECT_EQ(drawn({.figures = {"ranking", "agreement"}}),
            (std::vector<std::string>{"agreement", "sample.ranking"}));
}

// Differences of 10 mrad pass their tolerance where they do in degrees, and motions begin where they are
// asked to.
TEST(Print, AxesOfOtherFiguresAreInTheUnitAndTheTimeAskedFor) {
  PrintedSample sample({.blocks = 1, .steps = {1e-2}});
  const auto largest = [&](PrintStyle::Unit unit) {
    sample.draw({.unit = unit, .figures = {"differences"}, .from = 1, .to = 3});
    double most = 0;
    for (const auto& row : sample.table().rows)
      if (row.at(0).starts_with("|Δθ")) {
        most = std::max(most, number_in(row.at(6)).value());
        EXPECT_GE(number_in(row.at(5)).value(), 0.98);
        EXPECT_LE(number_in(row.at(5)).value(), 3.1);
      }
    return most;
  };
  const double radians = largest(PrintStyle::Unit::rad);
  EXPECT_NEAR(largest(PrintStyle::Unit::deg), radians * 180 / std::numbers::pi, 1e-4 * radians * 60);
}

TEST(Print, MoreEnginesThanAPanelBearsAreLeftOut) {
  std::vector<testing::SampleEngine> engines;
  for (const char* solver : {"a", "b", "c", "d", "e", "f", "g", "h"})
    engines.push_back({"bullet", solver, "tuned", 2e-3});
  PrintedSample sample({.engines = engines, .steps = {1e-2}});
  sample.draw({});
  EXPECT_EQ(sample.printed.left_out.size(), 2U);
}

TEST(Print, WhatAFigureCannotShowIsRefusedWithWhatThereIs) {
  PrintedSample sample({.title = "One block", .blocks = 1, .steps = {1e-2}});
  EXPECT_EQ(print_error(sample, {.panels = {"θ2"}}),
            "panels = \"θ2\": must be among θ1, ω1, Δθ1, which One block has");
  EXPECT_EQ(print_error(sample, {.figures = {"error-time"}, .from = 1}),
            "from: must be left out: it has no meaning for error-time");
  EXPECT_EQ(print_error(sample, {.unit = PrintStyle::Unit::deg, .figures = {"motion", "error-time"}}),
            "unit: must be left out: it has no meaning for error-time, but for motion");
  EXPECT_TRUE(print_error(sample, {.figures = {"mode"}})
                  .starts_with("figures = \"mode\": must be among agreement, "));
  EXPECT_TRUE(print_error(sample, {.from = 9}).starts_with("from = 9: must be before "));
  EXPECT_TRUE(
      print_error(sample, {.font = "No Such Letters"}).starts_with("font = \"No Such Letters\": must be a"));
}

// Angles of up to 0.1 rad stand over slips of up to 500 mm.
TEST(Grid, EachPanelHasItsOwnAxis) {
  const fs::path folder = testing::fresh_folder();
  testing::write_sample(folder, {.engines = {{"friction=0.3", "taylor", "", 2e-2}},
                                 .steps = {1e-2},
                                 .slides = true,
                                 .results = {"histories"}});
  draw_figures(folder, read_comparison(folder));
  const Picture picture = testing::read_picture(folder / "figures/sample.friction.svg");
  EXPECT_EQ(testing::collisions(picture), std::vector<std::string>());
  const auto shows = [&](const std::string& number) {
    return std::ranges::any_of(picture.texts, [&](const auto& text) { return text.words.ends_with(number); });
  };
  EXPECT_TRUE(shows("0.1") || shows("0.05"));
  EXPECT_TRUE(shows("400") || shows("500"));
}

TEST(Print, AStudyHasItsFigureAndNoPanelsOverTime) {
  const fs::path folder = testing::fresh_folder();
  std::ofstream(folder / "sweep.json")
      << R"({"title": "A made-up sweep", "summary": {"intensity": "ground.horizontal.peak", "period": ""}})";
  std::ofstream(folder / "fragility.csv") << "intensity,runs,toppled,failed,fraction,lower,upper,fitted\n"
                                             "2,20,0,0,0,0,0.16,0.02\n3,20,9,0,0.45,0.25,0.65,0.4\n";
  std::ofstream(folder / "fragility-fit.csv") << "median,beta,log_likelihood\n3.1,0.3,-20\n";
  for (const double width : {88.0, 180.0}) {
    const PrintedFigures printed = print_figures(folder, {.width = width, .titles = false});
    const Picture picture = testing::read_picture(fs::path(printed.stems.at(0)).concat(".svg"));
    EXPECT_EQ(testing::collisions(picture), std::vector<std::string>()) << width;
    EXPECT_FALSE(picture.says("A made-up sweep"));
  }
  EXPECT_EQ(read_table(folder / "paper/fragility.csv").rows.front(),
            (std::vector<std::string>{"share of runs that topple", "linear", "counted", "1A1A1A",
                                      "peak ground acceleration (m/s²)", "2", "0"}));
  EXPECT_THROW(print_figures(folder, {.panels = {"θ"}}), InputError);
}

}  // namespace
}  // namespace rockstack::plots
