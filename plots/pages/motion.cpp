#include "plots/pages/motion.hpp"

#include <fmt/core.h>

#include "comparisons/measures/results/files.hpp"
#include "plots/data/motion.hpp"
#include "plots/data/selection.hpp"
#include "plots/pages/html.hpp"
#include "plots/pages/page_parts.hpp"
#include "plots/pages/runs_table.hpp"

namespace rockstack::plots {
namespace {

namespace fs = std::filesystem;

std::string section(const std::string& title, const std::string& content) {
  return element("section", element("h2", title) + "\n" + content) + "\n";
}

std::string details(const std::string& title, const std::string& content) {
  return element("details", element("summary", title) + content) + "\n";
}

std::string figures(const fs::path& results, const ComparedScene& scene) {
  std::string text =
      drawn_figure(results / "figures" / "histories.svg", "histories-", "Angles over time",
                   "Angles of the blocks, clockwise positive. Where events are known, ticks along "
                   "the upper edge are impacts under that block, and the band names the pattern.");
  if (scene.slips)
    text += drawn_figure(results / "figures" / "slip.svg", "slip-", "Slip and gap",
                         "How far each block has slipped to the right along what is below it, and its "
                         "distance from it where there ever is one.");
  if (!scene.ground_motion.empty())
    text += drawn_figure(results / "figures" / "ground-motion.svg", "ground-", "Ground acceleration",
                         "What shakes the blocks, to the right and upwards positive.");
  return text;
}

std::string content(const fs::path& results, const Motion& motion) {
  const Comparison& comparison = motion.comparison;
  const ComparedScene& scene = comparison.scenes.front();
  const Run& run = comparison.runs.front();
  const std::string contents =
      element("ul", element("li", fmt::format("<a href=\"#{}\">Player</a>", player_anchor(0))));
  const std::string header = element("h1", escaped(heading(scene))) +
                             element("nav", contents, " aria-label=\"Parts of this page\"") +
                             answer_box({fmt::format("{}: {}.", run_label(run), motion.verdict)});
  const std::string ground =
      scene.ground.empty() ? "" : element("p", escaped("The ground moves by: " + scene.ground));
  const std::string again = element("pre", element("code", escaped(comparison.command))) +
                            details("The scene file", element("pre", element("code", escaped(scene.toml)))) +
                            details("The summary", definition_list(motion.summary)) +
                            element("p", "The tables as files: " + file_links(results));
  return element("header", header) + "\n" +
         element("main", "\n" + section("The motion", ground + player_part(comparison, 0)) +
                             contact_section(comparison) + section("Figures", figures(results, scene)) +
                             section("To run it again", again));
}

}  // namespace

void write_motion_report(const fs::path& results) {
  const Motion motion = read_motion(results);
  write_file(results / "report.html", page({motion.comparison.title, "report", content(results, motion)}));
}

}  // namespace rockstack::plots
