#include "plots/pages/front.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "plots/pages/html.hpp"
#include "plots/pages/player_data.hpp"
#include "tests/plots/browser.hpp"
#include "tests/plots/sample.hpp"

namespace rockstack::plots {
namespace {

using testing::Answer;
using testing::ask_browser;

constexpr double duration = 2, impact_time = 0.5;
const std::vector<double> steps{0.02, 0.01, 0.001};

Scene two_blocks() {
  Scene scene;
  scene.title = "Two made-up blocks";
  scene.duration = duration;
  scene.blocks = {make_block(1.25, 1.25, 2500), make_block(1, 2.5, 2500)};
  scene.initial = {{0.1, 0.1}, {0, 0}};
  return scene;
}

/// Both blocks swing as one, engines by a part of their step too slowly.
double swing(double time, double slow) {
  return 0.1 * std::cos(std::numbers::pi * time / (1 + slow));
}

History motion(double interval, double slow, double end = duration) {
  History history;
  history.blocks = 2;
  for (int i = 0; i * interval <= end + 1e-9; ++i) {
    history.times.push_back(i * interval);
    history.angles.insert(history.angles.end(), 2, swing(i * interval, slow));
  }
  return history;
}

/// The exact one, with an impact on the ground that takes half the velocity.
History exact_motion() {
  History history = motion(1e-3, 0);
  history.patterns.assign(history.size(), named_pattern("3a", 2));
  const double rate = -0.1 * std::numbers::pi;
  history.events.push_back({.time = impact_time,
                            .kind = EventKind::impact,
                            .interface = 1,
                            .from = named_pattern("3a", 2),
                            .to = named_pattern("3b", 2),
                            .angles = {0, 0},
                            .before = {rate, rate},
                            .after = {rate / 2, rate / 2}});
  return history;
}

/// Slower by ten times its step; `fast` is right at all steps but the first.
std::vector<FrontRun> runs_of(bool fast) {
  return mapped(steps, [&](double dt) { return FrontRun{motion(dt, fast && dt < 0.02 ? 0 : 10 * dt), ""}; });
}

class Front : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    const fs::path file = testing::fresh_folder() / "front.html";
    std::vector<FrontRun> failing = runs_of(false);
    failing.back() = {{}, "time limit: 1 s"};
    write_front(file, {.scene = two_blocks(),
                       .text = R"({"blocks":[]})",
                       .command = "rockstack page <made up>",
                       .exact = exact_motion(),
                       .steps = steps,
                       .engines = {{"bullet", "1.0", "tuned", Json::object(), runs_of(false)},
                                   {"ode", "1.1", "tuned", Json::object(), runs_of(true)},
                                   {"mine", "0.1", "default", Json::object(), failing}}});
    page_ = testing::bytes_of(file);
  }

  void SetUp() override {
    if (!testing::has_browser()) GTEST_SKIP() << "chromium is not installed";
  }

  static inline std::string page_;
};

/// Until when a run agrees within 0.01 rad, as the page says it.
std::string agreed(const History& run) {
  for (std::size_t i = 0; i < run.size(); ++i)
    if (std::abs(run.angles[2 * i] - swing(run.times[i], 0)) > 0.01)
      return fmt::format("{:.2f} s", run.times[i]);
  return "the end";
}

TEST_F(Front, OpensWithoutComplaintAndMovesByItself) {
  const Answer answer = ask_browser(page_, R"(
    for (let i = 0; i < 500 && player.time === 0; ++i) await wait(20);
    return { time: player.time, links: document.querySelectorAll("[src], link").length };)");
  EXPECT_EQ(answer.complaints.size(), 0u) << answer.complaints;
  EXPECT_GT(answer.result["time"].get<double>(), 0);
  EXPECT_EQ(answer.result["links"], 0);
  EXPECT_LT(page_.size(), 3'000'000u);
  EXPECT_NE(page_.find("rockstack page &lt;made up&gt;"), std::string::npos);
}

TEST_F(Front, SaysThatItCannotSolveWhereItCannot) {
  const std::string probe = "return document.querySelector('.fixed').checkVisibility();";
  EXPECT_EQ(ask_browser(page_, probe).result, page_.find("application/gzip") == std::string::npos);
  std::string page = page_;
  page.insert(page.find("<head>") + 6, "<script>delete globalThis.WebAssembly;</script>");
  const Answer answer = ask_browser(page, probe);
  EXPECT_EQ(answer.complaints.size(), 0u) << answer.complaints;
  EXPECT_TRUE(answer.result.get<bool>());
}

TEST_F(Front, StandsStillWhereMotionIsNotWanted) {
  std::string page = page_;
  page.insert(page.find("<head>") + 6, "<script>matchMedia = () => ({ matches: true });</script>");
  const Answer answer = ask_browser(page, "await wait(500); return [player.time, player.playing];");
  EXPECT_EQ(answer.complaints.size(), 0u) << answer.complaints;
  EXPECT_EQ(answer.result, nlohmann::json::parse("[0, false]"));
}

TEST_F(Front, TheSliderChangesMotionsAndHowLongTheyAgree) {
  const Answer answer = ask_browser(page_, R"(
    if (player.playing) player.toggle();
    player.goTo(1);
    const slider = document.querySelector(".steps"), chart = document.querySelector(".chart");
    return [0, 1, 2].map((step) => {
      slider.value = step;
      slider.dispatchEvent(new Event("input"));
      return { told: Array.from(document.querySelectorAll(".answers strong"), (one) => one.textContent),
        chart: chart.toDataURL(), step: slider.getAttribute("aria-valuetext") };
    });)");
  EXPECT_EQ(answer.complaints.size(), 0u) << answer.complaints;
  const std::vector<FrontRun> slow = runs_of(false), fast = runs_of(true);
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const std::string own = i == 2 ? "time limit: 1 s" : agreed(slow[i].history);
    EXPECT_EQ(answer.result[i]["told"],
              nlohmann::json({"1.00 s", agreed(slow[i].history), agreed(fast[i].history), own}))
        << steps[i];
  }
  EXPECT_EQ(answer.result[1]["told"][2], "the end");
  EXPECT_NE(answer.result[0]["chart"], answer.result[1]["chart"]);
  EXPECT_EQ(answer.result[1]["step"], "10 ms, 100 a second");
}

TEST_F(Front, EnginesCountWhileTheyAgree) {
  const Answer answer = ask_browser(page_, R"(
    const told = () => Array.from(document.querySelectorAll(".answers li"), (one) => one.textContent).slice(0, 2);
    if (!player.playing) player.toggle();
    player.goTo(0.1);
    const early = told();
    player.goTo(1.5);
    return [early, told()];)");
  EXPECT_EQ(answer.complaints.size(), 0u) << answer.complaints;
  EXPECT_EQ(answer.result[0],
            nlohmann::json::parse(R"(["Exact motion is at 0.10 s", "Bullet agrees so far 0.10 s"])"));
  EXPECT_EQ(answer.result[1][1], "Bullet agrees until " + agreed(motion(0.01, 0.1)));
}

// All that the centre of a block on its corner loses of its velocity, times its mass, came through the
// corner.
TEST_F(Front, AnImpactShowsVelocitiesAndImpulses) {
  const Json blow = stage_of(two_blocks(), exact_motion())["blows"].at(0);
  const std::vector<double> before = blow[2], after = blow[3], impulses = blow[4];
  const double rate = -0.1 * std::numbers::pi, mass = 2500 * 1.25 * 1.25;
  EXPECT_NEAR(before[0], rate * 0.625, 1e-12);  // about the right corner
  EXPECT_NEAR(before[1], rate * 0.625, 1e-12);
  EXPECT_NEAR(after[1], -rate / 2 * 0.625, 1e-12);  // about the left one
  EXPECT_NEAR(impulses[1] - impulses[3], mass * (after[1] - before[1]), 1e-9);
  const Answer answer = ask_browser(page_, R"(
    if (player.playing) player.toggle();
    const picture = () => document.querySelector(".stage").toDataURL();
    player.goTo(0);
    document.querySelector(".next").click();
    const first = picture();
    for (let i = 0; i < 500 && player.blow.part < 1; ++i) await wait(20);
    return { time: player.time, words: document.querySelector(".told").textContent, moved: picture() !== first, part: player.blow.part };)");
  EXPECT_EQ(answer.complaints.size(), 0u) << answer.complaints;
  EXPECT_EQ(answer.result["time"], impact_time);
  EXPECT_EQ(answer.result["part"], 1);
  EXPECT_TRUE(answer.result["moved"].get<bool>());
  EXPECT_EQ(answer.result["words"].get<std::string>().find("0.500 s: block 1 lands on the ground."), 0u);
}

TEST_F(Front, KeysMoveTimeAndPlay) {
  const Answer answer = ask_browser(page_, R"(
    if (player.playing) player.toggle();
    player.goTo(0);
    const press = (name, key) => document.querySelector(name).dispatchEvent(new KeyboardEvent("keydown", { key, bubbles: true }));
    press(".chart", "ArrowRight");
    const later = document.querySelector(".chart").getAttribute("aria-valuetext");
    press(".stage", " ");
    return [later, player.playing];)");
  EXPECT_EQ(answer.complaints.size(), 0u) << answer.complaints;
  EXPECT_EQ(answer.result, nlohmann::json::parse(R"(["0.02 s", true])"));
}

}  // namespace
}  // namespace rockstack::plots
