#include "plots/drawing/rows.hpp"

#include <gtest/gtest.h>

#include "plots/drawing/axes.hpp"
#include "tests/plots/picture.hpp"
#include "tests/plots/sample.hpp"

namespace rockstack::plots {
namespace {

/// Two panels of so many rows and columns, one over seconds, one over decades.
testing::Picture shot(std::size_t rows, std::size_t columns) {
  Sheet sheet("Rows", {}, "", shared_width);
  const RowPanel panel{.words = std::vector<std::string>(rows, "an engine, its solver"),
                       .low = 1e-6,
                       .high = 1,
                       .order = "best first"};
  add_rows(sheet, panel, std::vector<RowColumn>(columns, {"until (s), words", {}, "scene", "what it is", 3}));
  sheet.leave_room_above(90);
  add_rows(sheet, panel, std::vector<RowColumn>(columns, {"off by (rad, or share)", {}}));
  sheet.note("what they are, in words that are long enough to lie under the first of the columns");
  const auto stem = testing::fresh_folder() / "rows";
  draw(sheet.finish(), stem);
  return testing::read_picture(stem.string() + ".svg");
}

std::size_t count(const testing::Picture& picture, const std::string& words) {
  return static_cast<std::size_t>(std::ranges::count(picture.texts, words, &testing::ShownText::words));
}

// Who sees the upper half of a tall panel alone, as on a screen, reads its axis there.
TEST(Rows, TallPanelsHaveTheirAxisAboveAsWell) {
  constexpr std::size_t few = 4, many = 33;
  for (const std::size_t rows : {few, many}) {
    const testing::Picture picture = shot(rows, 2);
    const std::size_t axes = rows == many ? 2 : 1;
    EXPECT_EQ(count(picture, "until (s), words"), 2 * axes);
    EXPECT_EQ(count(picture, "off by (rad, or share)"), 2 * axes);
    EXPECT_EQ(count(picture, " 3"), 2 * axes);
    EXPECT_EQ(count(picture, "best first"), 2u);
    EXPECT_EQ(testing::collisions(picture), std::vector<std::string>()) << rows;
  }
}

// Six columns beside long words of rows leave a hundred pixels each.
TEST(Rows, WordsOfNarrowColumnsDoNotMeet) {
  for (const std::size_t rows : {4u, 33u})
    EXPECT_EQ(testing::collisions(shot(rows, 6)), std::vector<std::string>()) << rows;
}

}  // namespace
}  // namespace rockstack::plots
