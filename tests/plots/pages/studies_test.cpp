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
      R"({"title": "A <made-up> sweep", "headline": ["Of 3 runs 1 topples."],
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

TEST(StudyPage, AStudyOfStabilityCountsVerdictsAndNamesStableSteps) {
  const fs::path folder = testing::fresh_folder();
  put(folder / "stability.json",
      R"json({"title": "weights", "axis": "mass (kg)", "command": "rockstack compare x"})json");
  put(folder / "stability.csv", "run,dt,verdict\nexact,,sound\na,0.001,sound\nb,0.002,unstable\n");
  put(folder / "steps.csv",
      "engine,solver,settings,value,largest_stable_step\node,step,tuned,1,0\node,step,tuned,2,0.002\n");
  write_study_page(folder);
  const std::string page = study_page(folder);
  EXPECT_TRUE(tells(page, "Of 2 engine runs 1 is sound and 1 is unstable."));
  EXPECT_TRUE(tells(
      page, "ode step, tuned: the largest stable step is between none and 2 ms over 2 values of mass (kg)."));
  EXPECT_TRUE(tells(page, "rockstack compare x"));
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

/// The canon's page for sets with so many answers of each verdict, on three scenes.
std::string canon_page(const std::vector<std::vector<std::string>>& sets) {
  Json canon{{"title", "The canon"},
             {"steps", {0.004, 0.00025}},
             {"agreement", 0.5},
             {"replicates", 5},
             {"rows", Json::array()},
             {"scenes", Json::array()},
             {"command", "rockstack canon"}};
  for (const char* name : {"rest", "rock", "slide"})
    canon["scenes"].push_back({{"name", name}, {"title", "A scene"}, {"scene_file", ""}});
  for (std::size_t i = 0; i < sets.size(); ++i) {
    Json row{{"engine", "own"}, {"solver", fmt::format("s{}", i)}, {"settings", "tuned"}};
    for (const std::string& verdict : sets[i])
      row["answers"].push_back({{"verdict", verdict}, {"reason", ""}, {"steps_off", {1.0, 0.1}}});
    canon["rows"].push_back(row);
  }
  const fs::path folder = testing::fresh_folder();
  put(folder / "canon.json", canon.dump());
  write_study_page(folder);
  return study_page(folder);
}

TEST(CanonPage, TheHeadlineNamesTheSetsThatFollowTheLawInTheMostScenes) {
  EXPECT_TRUE(
      tells(canon_page({{"agrees", "another law", "cannot tell"},
                        {"agrees", "converges", "another law"},
                        {"no run", "no run", "agrees"}}),
            "own:s1 (tuned) agrees with the exact solution, or converges to it, in 2 of 3 scenes; none of "
            "3 sets in more."));
  EXPECT_TRUE(
      tells(canon_page({{"agrees", "converges", "agrees"}, {"converges", "converges", "agrees"}}),
            "own:s0 (tuned) and own:s1 (tuned) agree with the exact solution, or converge to it, in 3 of 3 "
            "scenes."));
  EXPECT_TRUE(tells(canon_page({{"another law", "cannot tell", "no run"}}),
                    "No set agrees with the exact solution, or converges to it, in any of 3 scenes."));
}

TEST(StudyPage, AFitSaysItsParametersAndWhatTheResidualMeans) {
  const fs::path folder = testing::fresh_folder();
  put(folder / "fit.json",
      Json{{"title", "A tested block"},
           {"columns", {"angle"}},
           {"unit", "rad"},
           {"horizon", 0.2},
           {"parameters",
            {{{"key", "restitution.1"}, {"value", 0.9123456}, {"lower", 0.911}, {"upper", 0.914}},
             {{"key", "blocks.1.density"}, {"value", 2000.0}, {"lower", nullptr}}}},
           {"meaning", {"It is 0.001 rad off.", "It is noise."}},
           {"command", "rockstack fit x"}}
          .dump());
  put(folder / "fit.csv", "time,measured_angle,fitted_angle\n0,0.1,0.1\n0.1,,0.05\n0.2,-0.1,-0.1\n");
  draw_figures(folder);
  write_study_page(folder);
  const std::string page = study_page(folder);
  EXPECT_TRUE(tells(page, "restitution.1 = 0.912346, with 95 % confidence from 0.911 to 0.914."));
  EXPECT_TRUE(tells(page, "blocks.1.density = 2000."));
  EXPECT_TRUE(tells(page, "It is noise."));
  EXPECT_TRUE(tells(page, "How near does the model come to the test?"));
  const testing::Picture picture = testing::read_picture(folder / "figures/fit.svg");
  EXPECT_TRUE(picture.says("It is 0.001 rad off."));
  EXPECT_TRUE(testing::collisions(picture).empty());
}

TEST(StudyPage, ARecordSaysItsPeaks) {
  const fs::path folder = testing::fresh_folder();
  put(folder / "record.json",
      R"({"file": "a/wave.at2", "gravity": 10.0, "arias_intensity": 0.4, "significant_5_95": {"length": 2.9},)"
      R"("peak_acceleration": {"value": -3, "time": 0.1}, "peak_velocity": {"value": -0.2, "time": 0.3},)"
      R"("peak_displacement": {"value": 0.05, "time": 0.5}})");
  write_study_page(folder);
  EXPECT_TRUE(tells(study_page(folder), "The peak acceleration is 0.3 g: -3 m/s² at 0.1 s."));
}

TEST(StudyPage, WhatIsMissingIsNamedAndNoPageIsLeftBehind) {
  const fs::path folder = testing::fresh_folder();
  put(folder / "record.json", R"({"file": "a"})");
  try {
    write_study_page(folder);
    FAIL() << "no InputError";
  } catch (const InputError& error) {
    EXPECT_TRUE(tells(error.what(), "record.json: ")) << error.what();
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
