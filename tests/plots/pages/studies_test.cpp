#include "plots/pages/show.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <fstream>

#include "analytic/scene/messages/input_error.hpp"
#include "comparisons/measures/results/run_metrics.hpp"
#include "plots/data/results.hpp"
#include "plots/figures/figure.hpp"
#include "tests/plots/browser.hpp"
#include "tests/plots/picture.hpp"
#include "tests/plots/sample.hpp"

namespace rockstack::plots {
namespace {

namespace fs = std::filesystem;

void put(const fs::path& file, const std::string& text) {
  fs::create_directories(file.parent_path());
  std::ofstream(file) << text;
}

/// A sweep of four runs, one failed, with a figure that no code knows.
fs::path made_up_sweep() {
  fs::path folder = testing::fresh_folder();
  put(folder / "sweep.json",
      R"({"title": "A <made-up> sweep", "headline": ["Of 3 runs 1 topples."], "tables": ["fragility-fit.csv", "none.csv"],
          "summary": {"intensity": "ground.horizontal.peak", "period": ""}})");
  put(folder / "runs.csv", "run,toppled,status\n0,0,done\n1,1,done\n2,,failed\n3,0,done\n");
  put(folder / "fragility-fit.csv", "median,beta,log_likelihood\n3.125,0.25,-20\n");
  put(folder / "figures/later.idea.svg", "<?xml?><svg viewBox='0 0 9 9'><g id='g'/></svg>");
  return folder;
}

std::string study_page(const fs::path& folder) {
  return testing::bytes_of(folder / "report.html");
}

bool tells(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(StudyPage, ASweepSaysWhatItsHeadlineSays) {
  const fs::path folder = made_up_sweep();
  write_study_page(folder);
  const std::string page = study_page(folder);
  EXPECT_TRUE(tells(page, "Of 3 runs 1 topples."));
  EXPECT_TRUE(tells(page, "A &lt;made-up&gt; sweep"));
}

TEST(StudyPage, EveryFigureOfTheFolderIsThereAndEveryTableIsLinked) {
  const fs::path folder = made_up_sweep();
  write_study_page(folder);
  const std::string page = study_page(folder);
  EXPECT_TRUE(tells(page, "<h3>later idea</h3>"));
  EXPECT_TRUE(tells(page, "id='later.idea-g'"));
  for (const char* name : {"runs.csv", "fragility-fit.csv", "sweep.json"})
    EXPECT_TRUE(tells(page, std::string("<a href=\"") + name + "\">")) << name;
}

TEST(StudyPage, EveryStudyHasItsTitleItsHeadlineTheTablesThatItNamesAndItsCommand) {
  for (const auto& [file, title] : {std::pair{"record.json", "Record a &lt;b&gt;"},
                                    {"stability.json", "Stability: a &lt;b&gt;"},
                                    {"fit.json", "Fit: a &lt;b&gt;"},
                                    {"advice.json", "Advice: a &lt;b&gt;"},
                                    {"impact-laws.json", "a &lt;b&gt;"},
                                    {"checks.json", "a &lt;b&gt;"},
                                    {"diff.json", "a &lt;b&gt;"}}) {
    const fs::path folder = testing::fresh_folder();
    put(folder / file,
        R"json({"title": "a <b>", "headline": ["One & two.", "Three."], "tables": ["one.csv"], "left": "over",
                "command": "rockstack compare x"})json");
    put(folder / "one.csv", "verdict,dt\nsound <s>,0.001\n");
    put(folder / "two.csv", "other\n1\n");
    write_study_page(folder);
    const std::string page = study_page(folder);
    for (const std::string& part :
         {std::string("<h1>") + title + "</h1>", std::string("<p>One &amp; two.</p>"), std::string("Three."),
          std::string("sound &lt;s&gt;"), std::string("<dt>left</dt><dd>over"),
          std::string("rockstack compare x")})
      EXPECT_TRUE(tells(page, part)) << file << ": " << part;
    EXPECT_FALSE(tells(page, "<h3>two.csv</h3>")) << file;
    EXPECT_FALSE(tells(page, "{{")) << file;
  }
}

TEST(StudyPage, WhatWasDoneIsLeftOutWhereNobodySaysIt) {
  for (const bool said : {true, false}) {
    const fs::path folder = testing::fresh_folder();
    put(folder / "diff.json", said ? R"({"title": "a", "command": "rockstack diff"})" : R"({"title": "a"})");
    write_study_page(folder);
    const std::string page = study_page(folder);
    EXPECT_EQ(tells(page, "What was done</h2>\n<p>By this command:</p><pre>"), said);
    EXPECT_EQ(tells(page, "href=\"#facts\""), said);
    EXPECT_FALSE(tells(page, "<dl></dl>"));
  }
}

TEST(StudyPage, ALongNameFitsAPhone) {
  if (!testing::has_browser()) GTEST_SKIP() << "chromium is not installed";
  const fs::path folder = testing::fresh_folder();
  put(folder / "record.json",
      R"({"title": "a_record_whose_name_has_no_place_at_which_a_line_may_end.AT2", "file": "a"})");
  write_study_page(folder);
  const testing::Answer answer = testing::ask_browser(study_page(folder), R"(
    const frame = Object.assign(document.createElement("iframe"), { srcdoc: document.head.querySelector("style").outerHTML + document.querySelector("header").outerHTML });
    frame.style.width = "400px";
    const loaded = new Promise((done) => frame.addEventListener("load", done));
    document.body.append(frame);
    await loaded;
    return frame.contentDocument.documentElement.scrollWidth;)");
  EXPECT_LE(answer.result.get<int>(), 400);
}

TEST(StudyPage, ResultsOfBeforeWithoutTitleAndHeadlineStillOpen) {
  const fs::path folder = testing::fresh_folder();
  put(folder / "record.json", R"({"file": "a/wave.at2", "arias_intensity": 0.4})");
  write_study_page(folder);
  EXPECT_TRUE(tells(study_page(folder), "<h1>Record " + folder.filename().string() + "</h1>"));
}

/// Three trials of two solvers, of which the cheapest that passes is picked, as advise writes them.
std::string made_up_advice() {
  const auto trial = [](const std::string& solver, double dt, double off, double seconds, bool passes) {
    RunMetrics row;
    row.run = fmt::format("{}-{}", solver, dt);
    row.engine = "own";
    row.solver = solver;
    row.settings = "tuned";
    row.dt = dt;
    row.largest_angle_difference = off;
    row.stepping_time_minimum = seconds;
    Json trial_json = row;
    trial_json.update({{"draws_tried", 21}, {"draws_within", passes ? 20 : 3}});
    trial_json.update(
        {{"confirming_draws_tried", passes ? 20 : 0}, {"confirming_draws_within", passes ? 19 : 0}});
    trial_json["passes"] = passes;
    return trial_json;
  };
  const Json trials{trial("one", 0.01, 0.1, 1e-3, false), trial("one", 0.001, 2e-3, 1e-2, true),
                    trial("two", 0.001, 1e-3, 2e-2, true)};
  return Json{{"title", "A column"},
              {"headline", {"Take own:one at 1 ms.", "This holds until 2.5 s."}},
              {"error", 0.01},
              {"within", 60},
              {"duration", 5.0},
              {"predictable_time", 2.5},
              {"pick", trials[1]},
              {"untried", Json::array()},
              {"beyond", Json::array()},
              {"trials", trials},
              {"command", "rockstack advise x"}}
      .dump();
}

TEST(StudyPage, AdviceBeginsWithItsWordsAndMarksWhatToTake) {
  const fs::path folder = testing::fresh_folder();
  put(folder / "advice.json", made_up_advice());
  put(folder / "advice.csv", "run\none-0.01\n");
  draw_figures(folder);
  write_study_page(folder);
  const std::string page = study_page(folder);
  EXPECT_TRUE(tells(page, "Take own:one at 1 ms."));
  EXPECT_TRUE(tells(page, "This holds until 2.5 s."));
  EXPECT_TRUE(tells(page, "What is the cheapest that is near enough?"));
  const testing::Picture picture = testing::read_picture(folder / "figures/advice.svg");
  EXPECT_TRUE(picture.says("own:one at 1 ms, within 0.01"));
  EXPECT_TRUE(testing::collisions(picture).empty());
  // A ring for each of two that pass, one more about the pick, and one in the legend.
  EXPECT_EQ(picture.marks_of(testing::shown_colour("#000000")).size(), 4U);
}

/// Trials of three solvers, of which the last is far off at any step.
std::string advice_with(double passing_off) {
  Json advice = Json::parse(made_up_advice());
  Json far = advice["trials"][0];
  far.update({{"solver", "three"}, {"largest_angle_difference", 0.5}});
  advice["trials"].push_back(far);
  if (passing_off > 0) return advice.dump();
  for (Json& trial : advice["trials"]) trial["passes"] = false;
  advice["pick"] = nullptr;
  return advice.dump();
}

/// Whether the figure of advice draws solver `words` in a colour of its own: the others share one line of the
/// legend.
bool names_solver(const testing::Picture& picture, const std::string& words) {
  return std::ranges::any_of(picture.texts, [&](const auto& text) { return text.words == words; });
}

TEST(StudyPage, AdviceColoursTheSolversThatHoldOrWhereNoneDoesTheNearest) {
  for (const double passing : {1.0, 0.0}) {
    const fs::path folder = testing::fresh_folder();
    put(folder / "advice.json", advice_with(passing));
    draw_figures(folder);
    const testing::Picture picture = testing::read_picture(folder / "figures/advice.svg");
    EXPECT_TRUE(names_solver(picture, "own:one"));  // holds at 1 ms, and is off by twice the least
    EXPECT_TRUE(names_solver(picture, "own:two"));
    EXPECT_FALSE(names_solver(picture, "own:three"));
    EXPECT_TRUE(names_solver(picture, "other solvers"));
  }
}

TEST(CanonPage, ShowsItsHeadlineAndEveryVerdict) {
  Json canon{{"title", "The canon"},      {"headline", {"own:s1 (tuned) agrees."}},
             {"steps", {0.004, 0.00025}}, {"agreement", 0.5},
             {"replicates", 5},           {"rows", Json::array()},
             {"scenes", Json::array()},   {"command", "rockstack canon"}};
  canon["scenes"].push_back({{"name", "rest"}, {"title", "A scene"}, {"scene_file", ""}});
  const Json answer{{"verdict", "another law"}, {"reason", ""}, {"steps_off", {1.0, 0.1}}};
  Json noisy = answer;
  noisy["verdict"] = "scatters";
  canon["rows"].push_back(
      {{"engine", "own"}, {"solver", "s1"}, {"settings", "tuned"}, {"answers", {answer, noisy}}});
  const fs::path folder = testing::fresh_folder();
  put(folder / "canon.json", canon.dump());
  write_study_page(folder);
  const std::string page = study_page(folder);
  for (const char* part :
       {"own:s1 (tuned) agrees.", "class=\"another-law\"", "class=\"scatters\"", "1 → 0.1"})
    EXPECT_TRUE(tells(page, part)) << part;
}

TEST(StudyPage, AFitShowsHowNearItComes) {
  const fs::path folder = testing::fresh_folder();
  put(folder / "fit.json", Json{{"title", "A tested block"},
                                {"headline", {"restitution.1 = 0.9."}},
                                {"columns", {"angle"}},
                                {"unit", "rad"},
                                {"horizon", 0.2},
                                {"meaning", {"It is 0.001 rad off."}},
                                {"command", "rockstack fit x"}}
                               .dump());
  put(folder / "fit.csv", "time,measured_angle,fitted_angle\n0,0.1,0.1\n0.1,,0.05\n0.2,-0.1,-0.1\n");
  draw_figures(folder);
  write_study_page(folder);
  EXPECT_TRUE(tells(study_page(folder), "How near does the model come to the test?"));
  const testing::Picture picture = testing::read_picture(folder / "figures/fit.svg");
  EXPECT_TRUE(picture.says("It is 0.001 rad off."));
  EXPECT_TRUE(testing::collisions(picture).empty());
}

TEST(StudyPage, WhatIsMissingIsNamedAndNoPageIsLeftBehind) {
  const fs::path folder = testing::fresh_folder();
  put(folder / "canon.json", R"({"title": "a"})");
  try {
    write_study_page(folder);
    FAIL() << "no InputError";
  } catch (const InputError& error) {
    EXPECT_TRUE(tells(error.what(), "canon.json: ")) << error.what();
  }
  EXPECT_FALSE(fs::exists(folder / "report.html"));
}

TEST(StudyPage, LoadsWithoutComplaint) {
  if (!testing::has_browser()) GTEST_SKIP() << "chromium is not installed";
  const fs::path folder = made_up_sweep();
  write_study_page(folder);
  const testing::Answer answer =
      testing::ask_browser(study_page(folder), "return document.querySelector('tbody td').dataset.label;");
  EXPECT_EQ(answer.complaints.size(), 0u) << answer.complaints;
  EXPECT_EQ(answer.result, "median");
}

}  // namespace
}  // namespace rockstack::plots
