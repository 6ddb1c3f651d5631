#include "plots/pages/lesson.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "analytic/scene/messages/input_error.hpp"
#include "plots/figures/comparison/figures.hpp"
#include "tests/plots/browser.hpp"
#include "tests/plots/sample.hpp"

namespace rockstack::plots {
namespace {

namespace fs = std::filesystem;

/// A made-up comparison with a lesson's text beside it.
fs::path lesson_folder(const std::string& text) {
  fs::path folder = testing::fresh_folder();
  testing::write_sample(folder, {});
  nlohmann::json lesson = nlohmann::json::parse(R"json({
    "title": "A lesson on <signs>", "number": 2, "count": 9, "numbers": {"least": "3 < 4"},
    "tables": {"steps": {"columns": ["step (s)", "error"], "rows": [["0.01", "2"], ["0.001", "1"]]},
               "near": {"columns": ["time (s)"], "rows": [["0.12345671"], ["0.12345682"]]}},
    "player": {"time": 1.25, "speed": 0.05, "gain": 10, "overlaid": true, "chatter": true}
  })json");
  lesson["text"] = text;
  std::ofstream(folder / "lesson.json") << lesson.dump();
  draw_figures(folder);
  return folder;
}

bool holds(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(Lesson, NumbersTablesFiguresAndPlayersTakeTheirPlaces) {
  const fs::path folder =
      lesson_folder("<p>{{least}}</p>{{table:steps}}{{figure:sample.histories}}{{player:sample}}");
  EXPECT_TRUE(has_lesson(folder));
  write_lesson(folder);
  const std::string page = testing::bytes_of(folder / "lesson.html");
  for (const char* part : {"<h1>A lesson on &lt;signs&gt;</h1>", "Lesson 2 of 9", "<p>3 &lt; 4</p>", "<svg ",
                           "class=\"player\"", "data-value=\"0.001\""})
    EXPECT_TRUE(holds(page, part)) << part;
  EXPECT_FALSE(holds(page, "{{"));
}

TEST(Lesson, APlaceWithoutAValueIsAnErrorThatNamesItAndLeavesNoPage) {
  const fs::path folder = lesson_folder("<p>{{lest}}</p>");
  try {
    write_lesson(folder);
    FAIL() << "no error";
  } catch (const std::logic_error& error) {
    EXPECT_TRUE(holds(error.what(), "{{lest}}")) << error.what();
  }
  EXPECT_FALSE(fs::exists(folder / "lesson.html"));
}

TEST(Lesson, AMalformedFileIsNamed) {
  const fs::path folder = lesson_folder("");
  std::ofstream(folder / "lesson.json") << R"({"title": "no text"})";
  EXPECT_THROW(write_lesson(folder), InputError);
}

TEST(Lesson, NumbersOfAColumnKeepTheDigitsThatTellThemApart) {
  const fs::path folder = lesson_folder("{{table:near}}");
  write_lesson(folder);
  const std::string page = testing::bytes_of(folder / "lesson.html");
  EXPECT_TRUE(holds(page, ">0.1234567</td>"));
  EXPECT_TRUE(holds(page, ">0.1234568</td>"));
}

TEST(Lesson, ItsPageWorksInABrowser) {
  if (!testing::has_browser()) GTEST_SKIP() << "chromium is not installed";
  const fs::path folder =
      lesson_folder("{{table:steps}}{{player:sample}}<details class=\"question\">why</details>");
  write_lesson(folder);
  const testing::Answer answer = testing::ask_browser(testing::bytes_of(folder / "lesson.html"), R"(
    document.querySelector("main table thead button").click();
    dispatchEvent(new Event("beforeprint"));
    return { first: document.querySelector("main table tbody td").textContent, end: player.end, start: [player.time, player.find("speed").value,
        player.find("gain-text").textContent, player.find("view").value, player.find("chatter").checked],
      answered: document.querySelector(".question").open };)");
  EXPECT_EQ(answer.complaints.size(), 0u) << answer.complaints;
  EXPECT_EQ(answer.result["first"], "0.001");
  EXPECT_EQ(answer.result["end"], 5);
  EXPECT_EQ(answer.result["start"], nlohmann::json::parse(R"([1.25, "0.05", "10", "over", true])"));
  EXPECT_EQ(answer.result["answered"], true);
}

}  // namespace
}  // namespace rockstack::plots
