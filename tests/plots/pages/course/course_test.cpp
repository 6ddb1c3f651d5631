#include "plots/pages/show.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "analytic/scene/messages/input_error.hpp"
#include "tests/plots/browser.hpp"
#include "tests/plots/sample.hpp"

namespace rockstack::plots {
namespace {

namespace fs = std::filesystem;

bool has_part(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(Course, ItsIndexLinksEachLessonWithAimsAndTime) {
  const fs::path folder = testing::fresh_folder();
  std::ofstream(folder / "course.json") << R"({"lessons": [
    {"name": "a", "title": "First < all", "minutes": 45, "pattern": "1a", "aims": ["see"], "after": []},
    {"name": "b", "title": "Then", "minutes": 75, "pattern": "R→", "aims": ["do"], "after": [{"name": "a", "title": "First < all"}]}]})";
  for (const char* name : {"a", "b"}) {
    fs::create_directories(folder / name);
    std::ofstream(folder / name / "comparison.json") << R"({"scenes": [{"page": "{\"title\": \"x\"}"}]})";
  }
  show(folder);
  const std::string page = testing::bytes_of(folder / "index.html");
  for (
      const char* part :
      {"<h2 data-pattern=\"1a\"><a href=\"a/lesson.html\">First &lt; all</a>", "href=\"b/slides.html\"",
       "75 minutes", "<li>do</li>",
       "<figure class=\"moving\" data-scene=\"{&quot;title&quot;: &quot;x&quot;}\" data-moves></figure><ul>\n<li>see",
       "<figure class=\"moving\" data-scene=\"{&quot;title&quot;: &quot;x&quot;}\"></figure><ul>\n<li>do",
       "After: <a href=\"#a\">", "2 lessons, 2 hours"})
    EXPECT_TRUE(has_part(page, part)) << part;
}

TEST(Course, ItsGlossaryIsAPageWithPicturesThatMove) {
  const fs::path folder = testing::fresh_folder();
  std::ofstream(folder / "course.json") << R"({"lessons": []})";
  show(folder);
  const std::string glossary = testing::bytes_of(folder / "glossary.html");
  for (const char* key : {"key <code>restitution</code>", "key <code>contact.restitution</code>"})
    EXPECT_TRUE(has_part(glossary, key)) << "two numbers have the name";
  if (!testing::has_browser()) GTEST_SKIP() << "chromium is not installed";
  const testing::Answer answer = testing::ask_browser(
      glossary,
      "return ['dt', 'figure.moving[data-scene]'].map((one) => document.querySelectorAll(one).length);");
  EXPECT_EQ(answer.complaints.size(), 0U) << answer.complaints;
  EXPECT_EQ(answer.result, nlohmann::json({16, 13}));
}

TEST(Course, ItsPagesShareTheSolverThatLiesBesideThem) {
  const fs::path folder = testing::fresh_folder();
  std::ofstream(folder / "course.json") << R"({"lessons": []})";
  constexpr auto own = "type=\"application/gzip\"", shared = "<script src=\"solver.js\"></script>";
  const auto glossary = [&] {
    show(folder);
    return testing::bytes_of(folder / "glossary.html");
  };
  const bool solves = has_part(glossary(), own);
  share_solver(folder);
  EXPECT_EQ(fs::exists(folder / "solver.js"), solves);
  if (!solves) GTEST_SKIP() << "this build has no solver for pages";
  EXPECT_FALSE(has_part(glossary(), own));
  EXPECT_TRUE(has_part(glossary(), shared));
  EXPECT_TRUE(has_part(glossary(), "script-src 'self' file: 'unsafe-inline'"));
  std::ofstream(folder / "solver.js", std::ios::app) << "// of another program\n";
  EXPECT_TRUE(has_part(glossary(), own));
  EXPECT_FALSE(has_part(glossary(), shared));
}

TEST(Sheet, ThePageHasRoomWhereTheKeyHasAnswers) {
  const fs::path folder = testing::fresh_folder();
  const fs::path file = folder / "a-key-3.json";
  std::ofstream(file)
      << R"({"lesson": "a", "title": "A & B", "seed": 3, "problems": [{"name": "", "text": "A block.",
    "parts": [{"ask": "When?", "choices": [], "unit": "s", "within": 0.05, "value": 1.5, "shown": "1.50 s", "why": ""},
      {"ask": "Where?", "choices": ["left", "right"], "right": 0, "unit": "", "within": 0.05, "value": 1, "shown": "left", "why": ""}]}]})";
  const SheetPages pages = write_sheet(file);
  const std::string sheet = testing::bytes_of(pages.sheet), key = testing::bytes_of(pages.key);
  EXPECT_EQ(pages.sheet.filename(), "a-sheet-3.html");
  EXPECT_FALSE(has_part(sheet, "1.50"));
  EXPECT_TRUE(has_part(sheet, "class=\"blank\"></span> s"));
  EXPECT_TRUE(has_part(sheet, "left / right"));
  EXPECT_TRUE(has_part(key, "1.50 s") && has_part(key, ">left</strong>"));
  EXPECT_TRUE(has_part(key, "A &amp; B"));
}

TEST(Sheet, AMalformedFileIsNamed) {
  const fs::path file = testing::fresh_folder() / "a-key-3.json";
  std::ofstream(file) << R"({"lesson": "a"})";
  EXPECT_THROW(write_sheet(file), InputError);
}

}  // namespace
}  // namespace rockstack::plots
