// Curves of a page's figures as charts, in a headless browser.

#include <gtest/gtest.h>

#include "plots/figures/figure.hpp"
#include "plots/pages/show.hpp"
#include "rockstack_plots_texts.hpp"
#include "tests/plots/browser.hpp"
#include "tests/plots/sample.hpp"

namespace rockstack::plots {
namespace {

std::string report_of(const testing::Sample& sample) {
  const fs::path folder = testing::fresh_folder();
  testing::write_sample(folder, sample);
  show(folder);
  return testing::bytes_of(folder / "report.html");
}

TEST(Curves, AreLoadedWhereAPageHasSome) {
  const std::string with = report_of({.blocks = 1, .results = {"histories"}}),
                    without = report_of({.blocks = 1, .results = {"angles"}});
  const bool built = !uplot_js.empty();
  EXPECT_EQ(with.find("class=\"curves\"") != std::string::npos, built);
  EXPECT_EQ(with.find("var uPlot=") != std::string::npos, built);
  EXPECT_EQ(without.find("var uPlot="), std::string::npos);
  EXPECT_NE(with.find("<svg"), std::string::npos);
}

TEST(Curves, TellTheirValuesZoomTogetherAndAreSwitched) {
  if (uplot_js.empty()) GTEST_SKIP() << "npm has brought no uPlot";
  if (!testing::has_browser()) GTEST_SKIP() << "no browser is there";
  const testing::Answer answer =
      testing::ask_browser(report_of({.blocks = 2, .steps = {1e-2}, .results = {"histories"}}), R"js(
    const figure = document.querySelector("figure:has(script.curves)"), svg = figure.querySelector("svg");
    const before = getComputedStyle(svg).display;
    figure.querySelector(".explore").click();
    await wait(500);
    const charts = figure.querySelector(".charts").charts, [first, second] = charts;
    const labels = [...first.root.querySelectorAll(".u-legend .u-label")].map((one) => one.textContent);
    const time = 1, values = first.root.querySelectorAll(".u-legend .u-value");
    first.setCursor({ left: first.valToPos(time, "x"), top: 20 });
    await wait(100);
    const told = [...values].map((one) => Number(one.textContent.replace("−", "-")));
    const over = first.over.getBoundingClientRect();
    const mouse = (type, x) => first.over.dispatchEvent(new MouseEvent(type,
      { clientX: over.left + x, clientY: over.top + 30, movementX: 1, bubbles: true, button: 0, buttons: 1 }));
    mouse("mousemove", 50); mouse("mousedown", 50); mouse("mousemove", 250); mouse("mouseup", 250);
    await wait(300);
    const zoomed = charts.map((chart) => [chart.scales.x.min, chart.scales.x.max]);
    first.root.querySelector(".u-legend .u-series:nth-child(3) .u-label").click();
    await wait(100);
    const switched = first.series[2].show;
    figure.querySelector(".explore").click();
    return { before, after: getComputedStyle(svg).display, count: charts.length, labels, told, zoomed, switched,
      whole: first.data[0].at(-1), within: document.documentElement.scrollWidth <= innerWidth };)js");
  EXPECT_EQ(answer.complaints.size(), 0U) << answer.complaints;
  const nlohmann::json& found = answer.result;
  EXPECT_EQ(found.at("before"), "block");
  EXPECT_EQ(found.at("after"), "block");
  EXPECT_EQ(found.at("count"), 2);
  EXPECT_EQ(found.at("labels").at(1), "exact");
  EXPECT_EQ(found.at("labels").size(), 3U);
  EXPECT_NEAR(found.at("told").at(0).get<double>(), 1, 0.02);
  for (const auto& range : found.at("zoomed")) {
    EXPECT_EQ(range, found.at("zoomed").at(0));
    EXPECT_LT(range.at(1).get<double>() - range.at(0).get<double>(), 0.5 * found.at("whole").get<double>());
  }
  EXPECT_FALSE(found.at("switched"));
  EXPECT_TRUE(found.at("within"));
}

}  // namespace
}  // namespace rockstack::plots
