#include "plots/pages/show.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "analytic/scene/messages/input_error.hpp"
#include "plots/figures/figure.hpp"
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
    "name": "signs", "title": "A lesson on <signs>", "number": 2, "count": 9, "minutes": 45, "numbers": {"least": "3 < 4"},
    "aims": ["read <i>signs</i>"], "after": [{"name": "housner", "title": "Housner"}], "references": ["A book"],
    "neighbours": {"previous": "", "next": "steps"},
    "predictions": [
      {"name": "side", "text": "A block leans.", "parts": [{"ask": "Where?", "choices": ["left", "right"], "right": 1,
        "unit": "", "within": 0.05, "value": 2, "shown": "right", "why": "It is {{least}}."}]},
      {"name": "time", "text": "", "parts": [{"ask": "When?", "choices": [], "unit": "s", "within": 0.05,
        "value": 2, "shown": "2.00 s", "why": ""}]}],
    "tables": {"steps": {"columns": ["step (s)", "error"], "rows": [["0.01", "2"], ["0.001", "1"]]},
               "patterns": {"columns": ["pattern"], "rows": [["1a → 2b"], ["L←C"], ["none"]]},
               "near": {"columns": ["time (s)"], "rows": [["0.12345671"], ["0.12345682"]]}},
    "player": {"time": 1.25, "speed": 0.05, "gain": 10, "overlaid": true, "chatter": true}
  })json");
  lesson["text"] = text;
  std::ofstream(folder / "lesson.json") << lesson.dump();
  draw_figures(folder, read_comparison(folder));
  return folder;
}

/// A page as it is made where there is no em++.
std::string without_solver(const fs::path& file) {
  std::string page = testing::bytes_of(file);
  constexpr std::string_view end = "</script>";
  for (std::size_t package; (package = page.find("<script type=\"application/gzip\"")) != std::string::npos;)
    page.erase(package, page.find(end, package) + end.size() - package);
  return page;
}

bool holds(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(Lesson, NumbersTablesFiguresAndPlayersTakeTheirPlaces) {
  const fs::path folder =
      lesson_folder("<p>{{least}}</p>{{table:steps}}{{figure:sample.histories}}{{player:sample}}");
  write_lesson(folder, read_comparison(folder));
  const std::string page = testing::bytes_of(folder / "lesson.html");
  for (const char* part : {"<h1>A lesson on &lt;signs&gt;</h1>", "Lesson 2 of 9", "<p>3 &lt; 4</p>", "<svg ",
                           "class=\"player\"", "data-value=\"0.001\""})
    EXPECT_TRUE(holds(page, part)) << part;
  EXPECT_FALSE(holds(page, "{{"));
}

TEST(Lesson, APlaceWithoutAValueIsAnErrorThatNamesItAndLeavesNoPage) {
  const fs::path folder = lesson_folder("<p>{{lest}}</p>");
  try {
    write_lesson(folder, read_comparison(folder));
    FAIL() << "no error";
  } catch (const std::logic_error& error) {
    EXPECT_TRUE(holds(error.what(), "{{lest}}")) << error.what();
  }
  EXPECT_FALSE(fs::exists(folder / "lesson.html"));
}

TEST(Lesson, AMalformedFileIsNamed) {
  const fs::path folder = lesson_folder("");
  std::ofstream(folder / "lesson.json") << R"({"title": "no text"})";
  EXPECT_THROW(write_lesson(folder, read_comparison(folder)), InputError);
}

TEST(Lesson, NumbersOfAColumnKeepTheDigitsThatTellThemApart) {
  const fs::path folder = lesson_folder("{{table:near}}");
  write_lesson(folder, read_comparison(folder));
  const std::string page = testing::bytes_of(folder / "lesson.html");
  EXPECT_TRUE(holds(page, ">0.1234567</td>"));
  EXPECT_TRUE(holds(page, ">0.1234568</td>"));
}

TEST(Lesson, ItsPageWorksInABrowser) {
  if (!testing::has_browser()) GTEST_SKIP() << "chromium is not installed";
  const fs::path folder =
      lesson_folder("{{table:steps}}{{player:sample}}<details class=\"question\">why</details>");
  write_lesson(folder, read_comparison(folder));
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

TEST(Lesson, WordsThatNameAThingHaveItsColourInThePicture) {
  if (!testing::has_browser()) GTEST_SKIP() << "chromium is not installed";
  const fs::path folder = lesson_folder(
      "{{player:sample}}<p><b data-colour=\"exact\">a</b> <b data-colour=\"block-2\">b</b> "
      "<b data-colour=\"nothing\">c</b></p>");
  write_lesson(folder, read_comparison(folder));
  const testing::Answer answer = testing::ask_browser(testing::bytes_of(folder / "lesson.html"), R"js(
    const colours = Array.from(document.querySelectorAll("[data-colour]"), (word) => word.style.getPropertyValue("--colour"));
    return [colours[0] === player.tracks.find((track) => track.exact).colour, colours[1] === stacks.blockColours[1], colours[2]];)js");
  EXPECT_EQ(answer.complaints.size(), 0u) << answer.complaints;
  EXPECT_EQ(answer.result, nlohmann::json({true, true, "transparent"}));
}

TEST(Lesson, OneOfItsPlayersHasTheHint) {
  if (!testing::has_browser()) GTEST_SKIP() << "chromium is not installed";
  const fs::path folder = lesson_folder("{{player:sample}}{{player:sample}}");
  write_lesson(folder, read_comparison(folder));
  const testing::Answer answer = testing::ask_browser(testing::bytes_of(folder / "lesson.html"), R"js(
    for (const one of document.querySelectorAll("details")) one.open = true;
    return Array.from(document.querySelectorAll(".player .hint"), (one) => one.checkVisibility());)js");
  EXPECT_EQ(answer.complaints.size(), 0u) << answer.complaints;
  EXPECT_EQ(answer.result, nlohmann::json({true, false}));
}

TEST(Lesson, ItsPlayerSavesAFilmOfWhatItPlays) {
  if (!testing::has_browser()) GTEST_SKIP() << "chromium is not installed";
  const fs::path folder = lesson_folder("{{player:sample}}");
  write_lesson(folder, read_comparison(folder));
  const testing::Answer answer = testing::ask_browser(testing::bytes_of(folder / "lesson.html"), R"(
    // The browser's time runs ahead where nothing is done; the encoder has the clock's.
    let spent = 0;
    const work = () => { for (let i = 0; i < 3e6; ++i) spent += Math.sqrt(i); return wait(10); };
    const film = player.find("film");
    film.click();
    const words = film.textContent;
    while (!(player.filmed?.size > 1000)) await work();
    film.click();
    while (player.filming) await work();
    const paper = Array.from(player.find("stage").getContext("2d").getImageData(1, 1, 1, 1).data);
    return { words, after: film.textContent, playing: player.playing, type: player.filmed.type, size: player.filmed.size, paper };)");
  EXPECT_EQ(answer.complaints.size(), 0u) << answer.complaints;
  EXPECT_EQ(answer.result["words"], "■ Save film");
  EXPECT_EQ(answer.result["after"], "● Film");
  EXPECT_EQ(answer.result["playing"], false);
  EXPECT_TRUE(holds(answer.result["type"], "video/"));
  EXPECT_GT(answer.result["size"], 1000) << "bytes";
  EXPECT_EQ(answer.result["paper"], nlohmann::json({255, 255, 255, 255})) << "a film has no paper behind it";
}

TEST(Lesson, WhatFollowsAPredictionIsHiddenUntilItIsMade) {
  if (!testing::has_browser()) GTEST_SKIP() << "chromium is not installed";
  const fs::path folder = lesson_folder(
      "<section><h2>First</h2>{{predict:side}}<p id='told'>told</p>{{predict:time}}<p "
      "id='more'>more</p></section>");
  write_lesson(folder, read_comparison(folder));
  const testing::Answer answer = testing::ask_browser(testing::bytes_of(folder / "lesson.html"), R"(
    const seen = (id) => document.getElementById(id).getClientRects().length > 0;
    const [side, time] = document.querySelectorAll(".predict"), states = [[seen("told"), seen("more")]];
    side.querySelector("[type=submit]").click();
    states.push([seen("told"), side.querySelector(".complaint").textContent !== ""]);
    side.querySelector("input[value='1']").click();
    side.querySelector("[type=submit]").click();
    states.push([seen("told"), seen("more"), side.querySelector(".verdict").textContent,
      document.activeElement === side.querySelector(".revealed"), side.textContent.includes("It is 3 < 4.")]);
    time.querySelector("input").value = "2,5";
    time.querySelector("[type=submit]").click();
    states.push([seen("more"), time.querySelector(".verdict").textContent]);
    document.getElementById("large").click();
    states.push(getComputedStyle(document.documentElement).fontSize);
    return states;)");
  EXPECT_EQ(answer.complaints.size(), 0u) << answer.complaints;
  EXPECT_EQ(answer.result, nlohmann::json::parse(R"([[false, false], [false, true],
    [true, false, "Your prediction holds.", true, true], [true, "It is less than you predicted."], "24px"])"));
}

TEST(Lesson, ItsSlidesAreWhatIsSeenAndMarkedInItsTextAndFitTheScreen) {
  if (!testing::has_browser()) GTEST_SKIP() << "chromium is not installed";
  const fs::path folder = lesson_folder(
      "<section><h2>First</h2>{{predict:side}}<p>Long. <span data-slide>Short.</span></p>{{player:sample}}"
      "<p data-slide>Left out. <span data-slide>{{least}}</span> <span data-title>So it is:</span></p>"
      "<ul data-slide><li><b data-slide>An item</b> that goes on</li></ul>{{table:patterns}}"
      "<div data-slide=\"All <i>steps</i>\">{{table:steps}}</div>"
      "<div data-slide=\"Angles\">{{figure:sample.histories}}</div>"
      "<div class=\"try\" hidden><p><span data-title>Try</span> it.</p></div></section>"
      "<section><h2>Questions</h2><p>Few.</p>"
      "<details class=\"question\"><summary>Why?</summary><p>So.</p></details></section>");
  write_lesson(folder, read_comparison(folder));
  const testing::Answer answer = testing::ask_browser(without_solver(folder / "slides.html"), R"(
    const { slides } = slideShow, small = slides.filter((one) => {
      one.classList.add("now");
      const held = one.scrollHeight <= one.clientHeight + 1;
      one.classList.remove("now");
      return !held;
    });
    slideShow.show(0);
    const press = (key) => document.body.dispatchEvent(new KeyboardEvent("keydown", { key, bubbles: true }));
    press("ArrowRight");
    const stage = document.querySelector(".slide:not(.now) .player .stage");
    const drawn = stage.width > 0 && new Set(stage.getContext("2d").getImageData(0, 0, stage.width, stage.height).data).size > 9;
    return { drawn, said: [slides[3].innerHTML, slides[5].innerHTML], names: slides.map((one) => one.getAttribute("aria-label")), overflowing: small.length,
      place: document.getElementById("place").textContent, wide: document.querySelector("figure svg").viewBox.baseVal.width };)");
  EXPECT_EQ(answer.complaints.size(), 0u) << answer.complaints;
  EXPECT_EQ(
      answer.result["names"],
      nlohmann::json::parse(R"(["A lesson on <signs>", "Predict", "Predict", "First", "First", "So it is",
    "All steps", "Angles", "Question", "Question", "References"])"));
  EXPECT_EQ(answer.result["said"],
            nlohmann::json({"<h2>First</h2><span data-slide=\"\">Short.</span>",
                            "<h2>So it is</h2><p data-slide=\"\"><span data-slide=\"\">3 &lt; 4</span> </p>"
                            "<ul data-slide=\"\"><li><b data-slide=\"\">An item</b> </li></ul>"}));
  EXPECT_EQ(answer.result["overflowing"], 0);
  EXPECT_EQ(answer.result["place"], "2 of 11");
  EXPECT_EQ(answer.result["wide"], 860) << "a figure is drawn for the slide";
  EXPECT_EQ(answer.result["drawn"], true) << "what is printed of a player is its picture";
}

// Its player moves, and what would ask the solver is not offered.
TEST(Lesson, WithoutASolverItsPageHasThePlayerAlone) {
  if (!testing::has_browser()) GTEST_SKIP() << "chromium is not installed";
  const fs::path folder =
      lesson_folder("<section>{{player:sample}}<div class=\"try\" hidden><p>Try it.</p></div></section>");
  write_lesson(folder, read_comparison(folder));
  const testing::Answer answer = testing::ask_browser(without_solver(folder / "lesson.html"), R"js(
    player.find("play").click();
    for (let i = 0; i < 500 && player.frames < 3; ++i) await wait(20);
    return { moves: player.frames >= 3, offered: document.querySelectorAll(".release").length,
      tries: document.querySelectorAll(".try:not([hidden])").length, said: document.querySelector(".try").previousElementSibling.textContent };)js");
  EXPECT_EQ(answer.complaints.size(), 0u) << answer.complaints;
  EXPECT_EQ(answer.result, nlohmann::json::parse(R"({"moves": true, "offered": 0, "tries": 0,
    "said": "This page was made without the exact solver in it: the sliders that belong here are left out."})"));
}

// One picture, whoever names the pattern.
TEST(Lesson, PatternsHaveTheirPictureInTablesAndInThePlayer) {
  if (!testing::has_browser()) GTEST_SKIP() << "chromium is not installed";
  const fs::path folder = lesson_folder("{{player:sample}}{{table:patterns}}");
  write_lesson(folder, read_comparison(folder));
  const testing::Answer answer = testing::ask_browser(testing::bytes_of(folder / "lesson.html"), R"js(
    const named = player.events.spans.filter(([, name, ...contacts]) => JSON.stringify(stacks.contactsOf(name)) !== JSON.stringify(contacts));
    const cells = [...document.querySelectorAll("main table:not(.values) td")].map((cell) => [cell.textContent, cell.querySelectorAll(".icon").length]);
    const picture = (pattern) => stacks.iconOf(null, ...stacks.contactsOf(pattern)).innerHTML;
    return { named, cells, same: player.find("icon").innerHTML === picture(player.pattern()), strange: stacks.contactsOf("none") };)js");
  EXPECT_EQ(answer.complaints.size(), 0u) << answer.complaints;
  EXPECT_EQ(answer.result,
            nlohmann::json::parse(R"({"named": [], "cells": [["1a → 2b", 2], ["L←C", 1], ["none", 0]],
    "same": true, "strange": null})"));
}

}  // namespace
}  // namespace rockstack::plots
