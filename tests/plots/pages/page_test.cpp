#include <gtest/gtest.h>

#include "plots/pages/show.hpp"
#include "tests/plots/browser.hpp"
#include "tests/plots/sample.hpp"

namespace rockstack::plots {
namespace {

using testing::Answer;
using testing::ask_browser;

/// The report of a made-up comparison, in a real browser. Its exact motion swings through zero every 0.5 s,
/// where pattern 1a becomes 2b and back.
class Page : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    if (!testing::has_browser()) return;
    const std::filesystem::path folder = testing::fresh_folder();
    testing::write_sample(folder, {.engines = {{"bullet", "sequential-impulse", "tuned", 2e-3},
                                               {"ode", "step", "default", 3e-3}},
                                   .failed_row = true,
                                   .shaken = true,
                                   .results = {"angles", "histories"}});
    show(folder);
    page_ = testing::bytes_of(folder / "report.html");
  }

  void SetUp() override {
    if (!testing::has_browser()) GTEST_SKIP() << "chromium is not installed";
  }

  static inline std::string page_;
};

TEST_F(Page, LoadsWithoutComplaint) {
  const Answer answer = ask_browser(page_, "return document.querySelectorAll('.player').length;");
  EXPECT_EQ(answer.complaints.size(), 0u) << answer.complaints;
  EXPECT_EQ(answer.result, 1);
}

// On a screen as wide as a phone's the first figure is whole, and its letters are ten pixels high at least.
TEST_F(Page, TheFirstFigureIsReadOnANarrowScreen) {
  const Answer answer = ask_browser(page_, R"(
    const frame = document.createElement("iframe");
    frame.style.width = "400px";
    frame.srcdoc = document.head.querySelector("style").outerHTML + document.querySelector("header").outerHTML;
    document.body.append(frame);
    await new Promise((done) => frame.addEventListener("load", done));
    const inner = frame.contentDocument;
    const boxes = Array.from(inner.querySelectorAll("figure text"), (text) => text.getBoundingClientRect())
      .filter((box) => box.width > 0);
    return { texts: boxes.length, least: Math.min(...boxes.map((box) => box.height)),
      left: Math.min(...boxes.map((box) => box.left)), right: Math.max(...boxes.map((box) => box.right)),
      page: inner.documentElement.scrollWidth };)");
  EXPECT_EQ(answer.complaints.size(), 0u) << answer.complaints;
  EXPECT_GT(answer.result["texts"].get<int>(), 10);
  EXPECT_GT(answer.result["least"].get<double>(), 10.0);
  EXPECT_GE(answer.result["left"].get<double>(), 0.0);
  EXPECT_LE(answer.result["right"].get<double>(), 400.0);
  EXPECT_LE(answer.result["page"].get<double>(), 400.0);
}

TEST_F(Page, AsksNothingOfTheNetwork) {
  const Answer answer = ask_browser(page_, R"(
    const refused = new Promise((done) => addEventListener("securitypolicyviolation", (event) => done(event.effectiveDirective)));
    document.body.append(Object.assign(new Image(), { src: "https://example.invalid/a.png" }));
    return Promise.race([refused, wait(5000)]);)");
  EXPECT_EQ(answer.result, "img-src");
}

TEST_F(Page, APlayerHasThreeControlsUntilMoreAreAskedFor) {
  const Answer answer = ask_browser(page_, R"js(
    const seen = () => Array.from(document.querySelectorAll(".player :is(button, input, select, summary, .hint)"))
      .filter((one) => one.checkVisibility()).map((one) => one.className);
    const few = seen();
    player.find("fold").open = true;
    return { few, all: seen() };)js");
  EXPECT_EQ(answer.complaints.size(), 0u) << answer.complaints;
  EXPECT_EQ(answer.result["few"], nlohmann::json({"scrub", "play", "next", ""}));
  const std::vector<std::string> all = answer.result["all"];
  for (const char* more : {"previous", "film", "speed", "gain", "halt", "hint"})
    EXPECT_EQ(std::count(all.begin(), all.end(), more), 1) << more;
}

TEST_F(Page, ThePlayerMovesUntilItIsPaused) {
  const Answer answer = ask_browser(page_, R"(
    const stage = player.find("stage"), before = stage.toDataURL();
    const drawn = player.frames;
    player.find("play").click();
    for (let i = 0; i < 500 && player.frames < drawn + 3; ++i) await wait(20);
    player.find("play").click();
    const paused = player.time, moved = stage.toDataURL() !== before;
    await wait(300);
    return { paused, later: player.time, moved };)");
  EXPECT_EQ(answer.complaints.size(), 0u) << answer.complaints;
  EXPECT_GT(answer.result["paused"].get<double>(), 0.0);
  EXPECT_EQ(answer.result["later"], answer.result["paused"]);
  EXPECT_TRUE(answer.result["moved"].get<bool>());
}

TEST_F(Page, ScrubbingAcrossAnImpactShowsThePatternChange) {
  const Answer answer = ask_browser(page_, R"(
    const scrub = player.find("scrub");
    const at = (ms) => {
      scrub.value = ms;
      scrub.dispatchEvent(new Event("input"));
      return { words: player.find("now").textContent, contacts: player.find("values").tBodies[0].rows[0].cells[3].textContent };
    };
    return [at(499), at(501), at(1001)];)");
  EXPECT_EQ(answer.complaints.size(), 0u) << answer.complaints;
  EXPECT_EQ(answer.result[0]["words"], "0.4990 s of 5.00 s, exact pattern 1a.");
  EXPECT_EQ(answer.result[1]["words"], "0.5010 s of 5.00 s, exact pattern 2b.");
  EXPECT_EQ(answer.result[2]["words"], "1.0010 s of 5.00 s, exact pattern 1a.");
  EXPECT_EQ(answer.result[0]["contacts"], "right, right");
  EXPECT_EQ(answer.result[1]["contacts"], "left, right");
}

TEST_F(Page, KeysStepFromImpactToImpactAndBack) {
  const Answer answer = ask_browser(page_, R"(
    const press = (key) => {
      player.find("stage").dispatchEvent(new KeyboardEvent("keydown", { key, bubbles: true }));
      return [player.time, player.find("now").textContent];
    };
    return [press("n"), press("n"), press("p"), press("p")];)");
  EXPECT_EQ(answer.complaints.size(), 0u) << answer.complaints;
  EXPECT_EQ(answer.result[0][0], 0.5);
  EXPECT_EQ(answer.result[1][0], 1.0);
  EXPECT_EQ(answer.result[2][0], 0.5);
  EXPECT_EQ(answer.result[3][0], 0.5);  // none is before the first
  EXPECT_EQ(answer.result[1][1],
            "1.0000 s of 5.00 s, exact pattern 1a. Impact at interface 1: pattern 2b becomes 1a.");
}

TEST_F(Page, AHeadingSortsItsColumnThenTurnsItRound) {
  const Answer answer = ask_browser(page_, R"(
    const heading = Array.from(document.querySelectorAll("#runs thead th"))
      .find((th) => th.textContent === "rms angle difference");
    const column = () => Array.from(document.querySelectorAll("#runs tbody tr"),
      (row) => row.cells[heading.cellIndex].dataset.value ?? "");
    heading.querySelector("button").click();
    const up = column(), stated = heading.getAttribute("aria-sort");
    heading.querySelector("button").click();
    return { up, stated, down: column() };)");
  EXPECT_EQ(answer.complaints.size(), 0u) << answer.complaints;
  // Four engine runs with values, the exact one and the failed one without.
  const std::vector<std::string> up = answer.result["up"], down = answer.result["down"];
  ASSERT_EQ(up.size(), 6u);
  EXPECT_EQ(answer.result["stated"], "ascending");
  for (int i = 0; i < 3; ++i) EXPECT_LE(std::stod(up[i]), std::stod(up[i + 1]));
  for (int i = 0; i < 4; ++i) EXPECT_EQ(down[i], up[3 - i]);
  for (int i = 4; i < 6; ++i) EXPECT_TRUE(up[i].empty() && down[i].empty());
}

TEST_F(Page, TheFirstStopOfTheKeyboardLeadsToThePlayer) {
  const Answer answer = ask_browser(page_, R"(
    const first = document.querySelector("a[href], button, input, select, [tabindex]");
    location.hash = first.hash;
    await wait(100);
    return { tag: first.tagName, target: document.querySelector(first.hash) === player.find("stage"),
      focus: player.find("stage").tabIndex };)");
  EXPECT_EQ(answer.complaints.size(), 0u) << answer.complaints;
  EXPECT_EQ(answer.result["tag"], "A");
  EXPECT_TRUE(answer.result["target"].get<bool>());
  EXPECT_EQ(answer.result["focus"], 0);
}

TEST_F(Page, TenColumnsAreShownUntilAllAreAskedFor) {
  const Answer answer = ask_browser(page_, R"(
    const shown = () => Array.from(document.querySelectorAll("#runs thead th"))
      .filter((th) => getComputedStyle(th).display !== "none").map((th) => th.textContent);
    const few = shown();
    document.getElementById("more").click();
    return { few, all: shown().length };)");
  EXPECT_EQ(answer.complaints.size(), 0u) << answer.complaints;
  const std::vector<std::string> few = answer.result["few"];
  ASSERT_GE(few.size(), 2u);
  EXPECT_LE(few.size(), 10u);
  EXPECT_EQ(few[0], "run");
  EXPECT_EQ(few[1], "rms angle difference");
  EXPECT_GT(answer.result["all"].get<std::size_t>(), few.size());
}

TEST_F(Page, ANameLeadsToTheParametersOfItsRun) {
  const Answer answer = ask_browser(page_, R"(
    const link = document.querySelectorAll("#runs tbody a")[1];
    link.click();
    await wait(100);
    const part = document.querySelector(link.hash);
    return { open: part.open, same: part.querySelector("summary").textContent === link.textContent };)");
  EXPECT_EQ(answer.complaints.size(), 0u) << answer.complaints;
  EXPECT_TRUE(answer.result["open"].get<bool>());
  EXPECT_TRUE(answer.result["same"].get<bool>());
}

// In either view, at rest, leaning and with angles exaggerated; names are of one and of several lines.
TEST_F(Page, NamesOfMotionsStandAboveAllBlocks) {
  const Answer answer = ask_browser(page_, R"js(
    const pen = CanvasRenderingContext2D.prototype, write = pen.fillText, found = [];
    let lowest = 0, lines = 0;
    pen.fillText = function (text, x, y, ...rest) {
      if (this.canvas === player.find("stage") && text && player.tracks.some(({ label }) => label.includes(text)))
        lowest = Math.max(lowest, y), ++lines;
      return write.call(this, text, x, y, ...rest);
    };
    for (const view of ["side", "over"])
      for (const gain of [0, 30, 100])
        for (const time of [0, 0.25, 1.2]) {
          player.find("view").value = view;
          player.find("gain").value = gain;
          player.time = time;
          lowest = lines = 0;
          player.drawStage();
          const tops = player.shown().flatMap((track) => {
            const { y } = player.views.get(track);
            return player.stack.place(track, time, player.drawnAngles(track))
              .flatMap(({ corners }) => corners.map((corner) => y(corner[1])));
          });
          found.push([lines, lowest, Math.min(...tops)]);
        }
    return found;)js");
  EXPECT_EQ(answer.complaints.size(), 0u) << answer.complaints;
  ASSERT_EQ(answer.result.size(), 18u);
  for (const nlohmann::json& frame : answer.result) {
    EXPECT_GE(frame[0].get<int>(), 2) << "motions have names";
    EXPECT_LT(frame[1].get<double>(), frame[2].get<double>());
  }
}

TEST_F(Page, EveryControlHasAName) {
  const Answer answer = ask_browser(page_, R"(
    const nameless = Array.from(document.querySelectorAll("button, input, select"), (one) =>
      one.textContent.trim() || one.labels?.[0]?.textContent.trim() || one.getAttribute("aria-label") ? "" : one.outerHTML);
    const canvas = player.find("stage");
    return { nameless: nameless.join(""), role: canvas.getAttribute("role"), words: canvas.getAttribute("aria-label"),
      focus: canvas.tabIndex };)");
  EXPECT_EQ(answer.result["nameless"], "");
  EXPECT_EQ(answer.result["role"], "img");
  EXPECT_EQ(answer.result["words"], "A made-up scene: 0.0000 s of 5.00 s, exact pattern 1a.");
  EXPECT_EQ(answer.result["focus"], 0);
}

TEST_F(Page, AnglesAreExaggeratedInThePictureAlone) {
  const Answer answer = ask_browser(page_, R"(
    player.goTo(0.25);
    const words = () => player.find("values").textContent, before = [words(), player.find("stage").toDataURL()];
    player.find("gain").value = 50;
    player.find("gain").dispatchEvent(new Event("input"));
    return { same: words() === before[0], redrawn: player.find("stage").toDataURL() !== before[1],
      gain: player.find("gain-text").textContent };)");
  EXPECT_EQ(answer.complaints.size(), 0u) << answer.complaints;
  EXPECT_TRUE(answer.result["same"].get<bool>());
  EXPECT_TRUE(answer.result["redrawn"].get<bool>());
  EXPECT_EQ(answer.result["gain"], "10");
}

}  // namespace
}  // namespace rockstack::plots
