#include "plots/pages/pages.hpp"

#include <fmt/core.h>

#include "comparisons/measures/results/files.hpp"
#include "plots/data/results.hpp"
#include "plots/data/selection.hpp"
#include "plots/pages/html.hpp"
#include "plots/pages/page_parts.hpp"
#include "plots/pages/sections.hpp"

namespace rockstack::plots {
namespace {

namespace fs = std::filesystem;

std::string section(const std::string& title, const std::string& content) {
  return element("section", element("h2", title) + "\n" + content) + "\n";
}

std::string details(const std::string& title, const std::string& content) {
  return element("details", element("summary", title) + content) + "\n";
}

std::string drawn(const fs::path& results, const Comparison& comparison) {
  std::string text;
  for (const Figure* figure : figures_of(comparison.scenes.front()))
    text += scene_figure(results, comparison, 0, *figure);
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
                             contact_section(comparison) + section("Figures", drawn(results, comparison)) +
                             section("To run it again", again));
}

}  // namespace

void write_report(const fs::path& results, const Motion& motion) {
  write_file(results / "report.html", page({motion.comparison.title, "report", content(results, motion)}));
}

}  // namespace rockstack::plots
