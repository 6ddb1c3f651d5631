#include "plots/pages/show.hpp"

#include <gtest/gtest.h>

#include <set>

#include "analytic/scene/messages/input_error.hpp"
#include "plots/data/results.hpp"
#include "plots/pages/html.hpp"
#include "tests/plots/sample.hpp"

namespace rockstack::plots {
namespace {

namespace fs = std::filesystem;

std::string sample_page(const fs::path& folder) {
  testing::write_sample(folder, {.engines = {{"ode", "step", "default", 3e-3}}, .failed_row = true});
  show(folder);
  return testing::bytes_of(folder / "report.html");
}

bool shows(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(Report, NamesEveryRunAndExplainsWhyOneFailed) {
  const fs::path folder = testing::fresh_folder();
  const std::string page = sample_page(folder);
  for (const auto& run : read_comparison(folder).runs) EXPECT_TRUE(shows(page, run.run)) << run.run;
  EXPECT_TRUE(shows(page, "angle not finite, at t = 0.3 s &lt;nan&gt;"));
  EXPECT_TRUE(shows(page, "This build leaves out ode."));
  EXPECT_TRUE(shows(page, "erp&lt;1&gt;"));
  EXPECT_TRUE(shows(page, "What &lt;it&gt; comes to."));
  EXPECT_TRUE(shows(page, "What it &lt;shows&gt;."));
}

TEST(Report, NeedsNothingBesideItself) {
  std::string page = sample_page(testing::fresh_folder());
  if (!uplot_js.empty()) page.erase(page.find(uplot_js), uplot_js.size());  // whose comments name its own
  for (std::size_t at = page.find("://"); at != std::string::npos; at = page.find("://", at + 1)) {
    const std::size_t attribute = page.rfind("xmlns", at);
    ASSERT_NE(attribute, std::string::npos);
    EXPECT_LT(at - attribute, std::string("xmlns:xlink=\"https:").size()) << page.substr(at, 40);
  }
  for (const char* part : {"<link", "<img", " src=", "@import", "url(http"})
    EXPECT_FALSE(shows(page, part)) << part;
}

TEST(Report, TextFromTheSceneAndTheRowsIsNeverMarkup) {
  const std::string page = sample_page(testing::fresh_folder());
  EXPECT_FALSE(shows(page, "<b>not bold</b>"));
  EXPECT_TRUE(shows(page, "&amp; &lt;b&gt;not bold&lt;/b&gt;"));
  EXPECT_TRUE(shows(page, "<h1>A sample &lt;comparison&gt;</h1>"));
}

TEST(Report, EveryIdIsThereOnce) {
  const std::string page = sample_page(testing::fresh_folder());
  std::set<std::string> seen;
  for (const char quote : {'"', '\''}) {
    const std::string mark = std::string(" id=") + quote;
    for (std::size_t at = page.find(mark); at != std::string::npos; at = page.find(mark, at + 1)) {
      const std::size_t begin = at + mark.size();
      const std::string id = page.substr(begin, page.find(quote, begin) - begin);
      EXPECT_TRUE(seen.insert(id).second) << id;
    }
  }
  EXPECT_TRUE(seen.contains("summary"));
}

TEST(Report, AMissingFigureIsNamedAndNoPageIsLeftBehind) {
  const fs::path folder = testing::fresh_folder();
  testing::write_sample(folder, {});
  try {
    write_report(folder, read_comparison(folder));
    FAIL() << "no InputError";
  } catch (const InputError& error) {
    EXPECT_TRUE(shows(error.what(), "sample.histories.svg")) << error.what();
  }
  EXPECT_FALSE(fs::exists(folder / "report.html"));
  EXPECT_FALSE(fs::exists(folder / "report.html.partial"));
}

TEST(Html, EscapesEveryCharacterThatCouldBecomeMarkup) {
  EXPECT_EQ(escaped("<a b=\"c\" d='e'>&"), "&lt;a b=&quot;c&quot; d=&#39;e&#39;&gt;&amp;");
}

TEST(Html, NumbersOfATableAreWrittenAsPeopleWriteThem) {
  EXPECT_TRUE(shows(table_cell("dt", "1e-05"), "data-value=\"1e-05\" title=\"1e-05\">1 × 10⁻⁵</td>"));
  EXPECT_TRUE(shows(table_cell("stiffness", "2.5e+12"), ">2.5 × 10¹²</td>"));
  EXPECT_TRUE(shows(table_cell("dt", "0.001"), ">0.001</td>"));
}

TEST(Html, AHeadingWithoutWordsIsNoButton) {
  EXPECT_EQ(heading(""), "<th scope=\"col\"></th>");
  EXPECT_TRUE(shows(heading("rms_error"), ">rms error</button>"));
}

TEST(Html, ValuesAreNotFilledInASecondTime) {
  EXPECT_EQ(filled_in("<{{a}}>", {{"a", "{{b}}"}, {"b", "wrong"}}), "<{{b}}>");
  EXPECT_THROW(filled_in("{{missing}}", {}), std::logic_error);
}

TEST(Html, ReferencesInsideAPictureFollowItsIds) {
  const std::string svg =
      inline_svg("<?xml?>\n<svg a='1'><title>t</title><use id='x' xlink:href='#y'/></svg>", "p-", "l");
  EXPECT_EQ(svg, "<svg role=\"img\" aria-label=\"l\" a='1'><use id='p-x' xlink:href='#p-y'/></svg>");
}

}  // namespace
}  // namespace rockstack::plots
