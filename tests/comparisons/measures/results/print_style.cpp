#include "comparisons/measures/results/print_style.hpp"

#include <gtest/gtest.h>

namespace rockstack {
namespace {

using Options = std::vector<std::pair<std::string, std::string>>;

std::string style_error(const Options& options) {
  try {
    read_print_style(style_table(options));
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(PrintStyle, ACommandLineHasTheValuesOfAFile) {
  const Options given{{"style", "paper"}, {"width", "180mm"},   {"font", "DejaVu Serif"}, {"font_size", "7"},
                      {"unit", "deg"},    {"titles", "none"},   {"panels", "θ2,slip"},    {"from", "4s"},
                      {"to", "7"},        {"figures", "motion"}};
  const PrintStyle style = read_print_style(style_table(given));
  EXPECT_EQ(style.width, 180);
  EXPECT_EQ(style.font, "DejaVu Serif");
  EXPECT_EQ(style.font_size, 7);
  EXPECT_EQ(style.unit, PrintStyle::Unit::deg);
  EXPECT_FALSE(style.titles);
  EXPECT_EQ(style.panels, (std::vector<std::string>{"θ2", "slip"}));
  EXPECT_EQ(style.figures, std::vector<std::string>{"motion"});
  EXPECT_EQ(style.from, 4);
  EXPECT_EQ(style.to, 7);
}

TEST(PrintStyle, ItsTextIsReadAgain) {
  const Node table =
      style_table({{"width", "120.5"}, {"panels", "θ,gap1"}, {"titles", "none"}, {"unit", "mrad"}});
  const PrintStyle again = read_style_text(style_text(table), "results");
  EXPECT_EQ(again.width, 120.5);
  EXPECT_EQ(again.panels, (std::vector<std::string>{"θ", "gap1"}));
  EXPECT_FALSE(again.titles);
  EXPECT_EQ(again.unit, PrintStyle::Unit::mrad);
}

TEST(PrintStyle, WhatItCannotBeIsRefusedInOneLine) {
  EXPECT_EQ(style_error({{"width", "88cm"}}), "--width: width = \"88cm\": must be a number");
  EXPECT_EQ(style_error({{"width", "20mm"}}), "--width: width = 20: must be a number from 50 to 400");
  EXPECT_TRUE(style_error({{"unit", "grad"}}).starts_with("--unit: unit = \"grad\": must be \"auto\" or"));
  EXPECT_TRUE(style_error({{"from", "5"}, {"to", "5"}}).starts_with("--to: to = 5: must be a time after"));
  EXPECT_TRUE(
      style_error({{"font_size", "12"}}).starts_with("--font_size: font_size = 12: must be such that"));
  EXPECT_EQ(style_error({{"font_size", "11"}}), "");
}

}  // namespace
}  // namespace rockstack
