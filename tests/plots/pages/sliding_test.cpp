#include <gtest/gtest.h>

#include "plots/pages/show.hpp"
#include "tests/plots/browser.hpp"
#include "tests/plots/sample.hpp"

namespace rockstack::plots {
namespace {

using testing::Answer;
using testing::ask_browser;

/// The report of a made-up motion whose blocks slip, fly and land, in a real browser: blocks of 1 m by 2 m,
/// each slipping by 0.1 m/s on the one below.
class SlidingPage : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    if (!testing::has_browser()) return;
    const std::filesystem::path folder = testing::fresh_folder();
    testing::write_sample(folder, {.engines = {}, .slides = true, .results = {"histories"}});
    show(folder);
    page_ = testing::bytes_of(folder / "report.html");
  }

  void SetUp() override {
    if (!testing::has_browser()) GTEST_SKIP() << "chromium is not installed";
  }

  static inline std::string page_;
};

TEST_F(SlidingPage, BlocksAreWhereTheResultsSay) {
  const Answer answer = ask_browser(page_, R"(
    const track = player.tracks[0];
    return [0.5, 1.2].map((time) => player.stack.place(track, time, track.angles(time)).map((part) =>
      [0, 1].map((i) => (part.base[i] + part.top[i]) / 2)));)");
  EXPECT_EQ(answer.complaints.size(), 0u) << answer.complaints;
  constexpr double single = 1e-6;  // places of some metres, in single precision
  for (int k = 0; k < 2; ++k) {
    EXPECT_NEAR(answer.result[0][k][0].get<double>(), 0.05 * (k + 1), single);
    EXPECT_NEAR(answer.result[0][k][1].get<double>(), 2 * k + 1, single);
    EXPECT_NEAR(answer.result[1][k][1].get<double>(), 2 * k + 1.3, single);
  }
}

// A block of half-width 0.5 that has slipped by s to the right and turns clockwise stands on the end of the
// face below, at 0.5 − s from its own middle; one that turns back stands on its own corner.
TEST_F(SlidingPage, SlipsAloneTellWhereABlockTurns) {
  const Answer answer = ask_browser(page_, R"(
    const track = (angle, slip) => ({ slips: () => [0, slip], places: () => null, angles: () => [0, angle] });
    return [[0.1, 0.2], [-0.1, 0.2], [0.1, -0.2], [-0.1, -0.2]].map(([angle, slip]) => {
      const part = player.stack.place(track(angle, slip), 0, [0, angle])[1], side = Math.sign(angle);
      return [part.end(side), ...part.under(part.end(side)), part.face(side), part.gap()];
    });)");
  EXPECT_EQ(answer.complaints.size(), 0u) << answer.complaints;
  const double ends[] = {0.3, -0.5, 0.5, -0.3}, places[] = {0.5, -0.3, 0.3, -0.5},
               faces[] = {0.1, 0, 0, -0.1};
  constexpr double rounding = 1e-14;
  for (int i = 0; i < 4; ++i) {
    EXPECT_NEAR(answer.result[i][0].get<double>(), ends[i], rounding) << i;
    EXPECT_NEAR(answer.result[i][1].get<double>(), places[i], rounding) << i;
    EXPECT_NEAR(answer.result[i][2].get<double>(), 2, rounding) << i;
    EXPECT_NEAR(answer.result[i][3].get<double>(), faces[i], rounding) << i;
    EXPECT_NEAR(answer.result[i][4].get<double>(), 0, rounding) << i;
  }
}

TEST_F(SlidingPage, EventsOfSlidingAndFlightAreStopsInWords) {
  const Answer answer = ask_browser(page_, R"(
    const words = [];
    for (let i = 0; i < 6; ++i) { player.step(1); words.push([player.time, player.find("now").textContent]); }
    player.find("events").open = true;
    await wait(50);
    return { words, listed: player.find("event-list").children.length, button: player.find("next").textContent };)");
  EXPECT_EQ(answer.complaints.size(), 0u) << answer.complaints;
  const std::vector<std::string> said{
      "Slip at interface 2, which starts to slide: pattern R→C becomes R→C←.",
      "Lift-off at interface 1, where blocks part: pattern R→C← becomes –C←.",
      "Impact at interface 1: pattern –C← becomes LC←.",
      "Stick at interface 2, which stops sliding that way: pattern LC← becomes 3b.",
      "Corner at interface 2, where the contact passes to another corner: pattern 3b becomes 2b.",
      "Fall at interface 2, where a block is beside the face below: pattern 2b becomes L–."};
  for (std::size_t i = 0; i < said.size(); ++i) {
    EXPECT_EQ(answer.result["words"][i][0], 0.5 * static_cast<double>(i + 1));
    EXPECT_TRUE(answer.result["words"][i][1].get<std::string>().ends_with(said[i]))
        << answer.result["words"][i];
  }
  EXPECT_EQ(answer.result["listed"], 6);
  EXPECT_EQ(answer.result["button"], "event ▶");
}

TEST_F(SlidingPage, TheTableNamesSlidesFlightsAndSlips) {
  const Answer answer = ask_browser(page_, R"(
    return [0.7, 1.2].map((time) => {
      player.goTo(time);
      return Array.from(player.find("values").tBodies[0].rows[0].cells, (cell) => cell.textContent).slice(3);
    });)");
  EXPECT_EQ(answer.complaints.size(), 0u) << answer.complaints;
  EXPECT_EQ(answer.result[0], (nlohmann::json{"right →, closed ←", "0.0700", "0.0700"}));
  EXPECT_EQ(answer.result[1], (nlohmann::json{"apart, closed ←", "0.1200", "0.1200"}));
}

// The weight of 2000 kg is 19620 N: forces of 4905 N and 100 N are far inside a cone of 0.5.
TEST_F(SlidingPage, ConesStandWhereReactionsDo) {
  const Answer answer = ask_browser(page_, R"(
    const cones = [], draw = player.drawCone;
    player.drawCone = (pen, apex, to, ...rest) => { cones.push(rest); draw.call(player, pen, apex, to, ...rest); };
    player.goTo(0.7);
    const touching = cones.splice(0);
    player.goTo(1.2);
    return [touching, cones];)");
  EXPECT_EQ(answer.complaints.size(), 0u) << answer.complaints;
  ASSERT_EQ(answer.result[0].size(), 2u);
  EXPECT_EQ(answer.result[0][0][0], 0.5);
  EXPECT_EQ(answer.result[1].size(), 1u);  // the lowest block flies
}

TEST_F(SlidingPage, SlipsLeftAndOpenQuestionsAreTold) {
  const Answer answer = ask_browser(page_, R"(
    const part = document.getElementById("contacts");
    return { cells: Array.from(part.querySelectorAll("tbody td"), (cell) => cell.textContent),
      warnings: Array.from(part.querySelectorAll("li"), (item) => item.textContent) };)");
  EXPECT_EQ(answer.complaints.size(), 0u) << answer.complaints;
  EXPECT_EQ(answer.result["cells"], (nlohmann::json{"exact", "1", "-0.25", "0.5", "7", "0.3", "1"}));
  EXPECT_EQ(answer.result["warnings"], nlohmann::json{"exact: several motions <obey>"});
}

}  // namespace
}  // namespace rockstack::plots
