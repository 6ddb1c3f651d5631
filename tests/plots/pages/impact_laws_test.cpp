#include "plots/pages/show.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "analytic/scene/messages/input_error.hpp"
#include "plots/pages/sections.hpp"
#include "tests/plots/browser.hpp"
#include "tests/plots/sample.hpp"

namespace rockstack::plots {
namespace {

namespace fs = std::filesystem;

constexpr auto description = R"json({
  "title": "A <small> study", "command": "rockstack compare small --out DIR", "suite_file": "study = \"a<b\"",
  "definitions": {"impact-laws.csv": {"differ": "how many"}, "impact-laws-engines.csv": {"dt": "step, s"}},
  "disagreements": [{"kind": "4a-blocks", "paper": "4b", "consistent": "3b", "count": 50, "clearness": 0.5}],
  "cases": [{"name": "4a-blocks.4b.3b", "blocks": [{"width": 2, "height": 1, "mass": 1},
                                                   {"width": 1, "height": 3, "mass": 0.25}]}],
  "engines": [{"engine": "ode", "solver": "step", "settings": "tuned", "parameters": {"erp": 0.01}}],
  "left_out": ["bullet"], "environment": {"ode": "0.16"}
})json";

constexpr auto cells =
    "blocks,kind,aspect_ratio_from,aspect_ratio_to,mass_ratio_from,mass_ratio_to,impacts,differ,none\n"
    "2,4a-blocks,0.5,1,0.1,1,100,40,0\n2,4a-blocks,1,2,1,10,100,10,0\n"
    "2,1a-ground,0.5,1,0.1,1,100,0,0\n2,1a-ground,1,2,1,10,100,0,8\n";

constexpr auto run_columns =
    "case,engine,solver,settings,dt,status,reason,paper,consistent,pattern,follows,from_paper,"
    "from_consistent,before,rates\n";

/// Runs of one state: two follow law consistent, one law paper, one fails.
constexpr auto runs =
    "4a-blocks.4b.3b,ode,step,tuned,0.001,done,,4b,3b,3b,consistent,0.5,0.02,0 -0.12345678,0 0.25\n"
    "4a-blocks.4b.3b,ode,step,tuned,0.0001,done,,4b,3b,3b,consistent,0.5,0.01,0 -0.12345678,0 0.25\n"
    "4a-blocks.4b.3b,ode,quickstep,tuned,0.001,done,,4b,3b,4b,paper,0.03,0.6,0 -0.12345678,0 0.25\n"
    "4a-blocks.4b.3b,ode,quickstep,tuned,0.0001,failed,it <stopped>,4b,3b,,,,,0 -0.12345678,\n";

/// The results of a made-up study.
fs::path study_folder(const std::string& rows) {
  fs::path folder = testing::fresh_folder();
  std::ofstream(folder / "impact-laws.json") << description;
  std::ofstream(folder / "impact-laws.csv") << cells;
  std::ofstream(folder / "impact-laws-engines.csv") << run_columns << rows;
  return folder;
}

std::string page_of(const fs::path& folder) {
  show(folder);
  return testing::bytes_of(folder / "report.html");
}

/// One sentence a line.
std::string lines(const std::vector<std::string>& sentences) {
  std::string text;
  for (const std::string& sentence : sentences) text += sentence + "\n";
  return text;
}

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(ImpactLawPage, TheSummaryCountsWhereTheLawsDiffer) {
  EXPECT_EQ(lines(law_summary(read_law_results(study_folder(runs)))),
            "Stacks of 2 blocks: 400 impacts of 2 kinds were judged. The laws have different patterns after "
            "12.5 % of them, in 1 of these kinds: 4a-blocks (25.0 %).\n"
            "The share within this kind by height over width of the top block: most from 0.5 to 1 (40.0 %), "
            "least from 1 to 2 (10.0 %); by its mass over that of the block below: most from 0.1 to 1 (40.0 "
            "%), least from 1 to 10 (10.0 %).\n"
            "After 2.0 % no pattern is consistent; law consistent then takes that of law paper.\n");
}

TEST(ImpactLawPage, BeginsWithItsAnswer) {
  EXPECT_EQ(
      lines(law_answer(read_law_results(study_folder(runs)))),
      "Where the laws differ, engines take the pattern of law consistent in 2 of 4 runs, and that of law "
      "paper in 1.\n"
      "The laws differ after 12.5 % of the impacts of random stacks.\n");
  const std::string page = page_of(study_folder(runs));
  EXPECT_LT(page.find("class=\"answer\""), page.find("<main>"));
  EXPECT_EQ(lines(law_answer(read_law_results(study_folder("")))),
            "The laws differ after 12.5 % of the impacts of random stacks.\n");
}

TEST(ImpactLawPage, TheSummarySaysWhichLawEnginesFollow) {
  EXPECT_EQ(
      lines(engine_summary(read_law_results(study_folder(runs)))),
      "Engines ran into 1 state where the laws clearly differ, in 4 runs: 2 end in the pattern of law "
      "consistent, 1 in that of law paper, 0 in neither, and 1 failed.\n"
      "Law consistent's pattern by time step: 1 of 2 with steps of 1 ms and 1 of 2 with steps of 0.1 ms.\n"
      "By solver: most often ode step, tuned (2 of 2), least often ode quickstep, tuned (0 of 2).\n"
      "Law paper's pattern is taken in 4a-blocks.4b.3b (1 of 4 runs).\n"
      "The angular velocities after the impact are nearer to law consistent's in 2 of 3 runs that came to "
      "their end. Half of them are within 0.02 of the largest relative one before the impact from law "
      "consistent's, and within 0.5 from law paper's.\n"
      "Farthest from law consistent is ode quickstep (tuned, 1 ms), by 0.6 times that velocity, in "
      "4a-blocks.4b.3b.\n"
      "This build leaves out bullet.\n");
}

TEST(ImpactLawPage, HasFiguresTablesParametersAndTheCommand) {
  const std::string page = page_of(study_folder(runs));
  for (const char* part : {"<h1>A &lt;small&gt; study</h1>", "it &lt;stopped&gt;",
                           "study = &quot;a&lt;b&quot;", "0 -0.1235", "rockstack compare small --out DIR",
                           "<dt>erp</dt>", "<dt>differ</dt>", "laws-2-", "laws-engines-", "class=\"failed\""})
    EXPECT_TRUE(has(page, part)) << part;
  EXPECT_FALSE(has(page, "{{"));
}

TEST(ImpactLawPage, IsWrittenWithoutAnyEngineRun) {
  const std::string page = page_of(study_folder(""));
  EXPECT_TRUE(has(page, "No engine was asked."));
  EXPECT_TRUE(has(page, "No engine run that came to its end."));
}

TEST(ImpactLawPage, AMissingFigureAndAMalformedFileAreNamed) {
  const fs::path folder = study_folder(runs);
  EXPECT_THROW(write_study_page(folder), InputError);
  EXPECT_FALSE(fs::exists(folder / "report.html"));
  std::ofstream(folder / "impact-laws.json") << R"({"title": "no more"})";
  try {
    show(folder);
    FAIL() << "no InputError";
  } catch (const InputError& error) {
    EXPECT_TRUE(has(error.what(), "impact-laws.json: ")) << error.what();
  }
}

TEST(ImpactLawPage, ItsTablesSortInABrowser) {
  if (!testing::has_browser()) GTEST_SKIP() << "chromium is not installed";
  const testing::Answer answer = testing::ask_browser(page_of(study_folder(runs)), R"(
    const heading = Array.from(document.querySelectorAll("#runs thead th"))
      .find((th) => th.textContent === "from consistent");
    heading.querySelector("button").click();
    return { tables: document.querySelectorAll("main table").length, figures: document.querySelectorAll("figure svg").length,
      order: Array.from(document.querySelectorAll("#runs tbody tr"), (row) => row.cells[heading.cellIndex].dataset.value ?? "") };)");
  EXPECT_EQ(answer.complaints.size(), 0u) << answer.complaints;
  EXPECT_EQ(answer.result["tables"], 6);
  EXPECT_EQ(answer.result["figures"], 2);
  EXPECT_EQ(answer.result["order"], nlohmann::json({"0.01", "0.02", "0.6", ""}));
}

}  // namespace
}  // namespace rockstack::plots
