#include "plots/pages/pages.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <optional>
#include <set>

#include "comparisons/measures/results/files.hpp"
#include "comparisons/measures/results/sentences.hpp"
#include "plots/data/results.hpp"
#include "plots/data/selection.hpp"
#include "plots/pages/html.hpp"
#include "plots/pages/page_parts.hpp"
#include "plots/pages/sections.hpp"
#include "plots/pages/templates.hpp"

namespace rockstack::plots {
namespace {

namespace fs = std::filesystem;

/// Matched, missed and extra impacts.
std::string counts(const std::optional<int>& matched, const std::optional<int>& missed,
                   const std::optional<int>& extra) {
  return fmt::format("{} / {} / {}", matched.value_or(0), missed.value_or(0), extra.value_or(0));
}

/// The impacts that each engine run has, beside the sampling limit (the exact motion read from samples at the
/// same steps) and the chance level; nothing where no run counted them.
std::string impacts_table(const Comparison& comparison, const std::string& scene) {
  const std::vector<std::string> columns{"run", "matched / missed / extra",
                                         "sampling limit: the exact motion at these steps",
                                         "chance level: random times", "chance level: shifted"};
  std::string rows;
  for (const Run& run : done_runs(comparison, scene)) {
    if (!run.impacts_matched || !run.impacts_matched_null || !run.dt) continue;
    rows += table_row(columns,
                      {run_label(run), counts(run.impacts_matched, run.impacts_missed, run.impacts_extra),
                       counts(run.impacts_matched_null, run.impacts_missed_null, run.impacts_extra_null),
                       fmt::format("{}", run.impacts_matched_random.value_or(0)),
                       fmt::format("{}", run.impacts_matched_shifted.value_or(0))});
  }
  if (rows.empty()) return "";
  return element("h3", "Impacts, and what reading and chance alone would give") +
         element("div", table(columns, rows), " class=\"statements\"") + "\n";
}

/// What the paper says beside what was computed; nothing where no statements were asked for.
std::string statements_section(const Comparison& comparison) {
  if (comparison.statements.empty()) return "";
  const std::vector<std::string> columns{"Figure", "The paper says", "Verdict", "It holds if", "Computed"};
  std::string rows;
  for (const PaperStatement& statement : comparison.statements)
    rows += table_row(columns, {statement.source, statement.claim, statement.verdict, statement.criterion,
                                statement.computed});
  return element("section",
                 element("h2", "What the paper says, and what was computed") + "\n" +
                     element("div", table(columns, rows), " class=\"statements\""),
                 " id=\"statements\"");
}

std::string scene_anchor(std::size_t scene) {
  return fmt::format("scene-{}", scene + 1);
}

std::string scene_section(const fs::path& results, const Comparison& comparison, std::size_t scene) {
  const ComparedScene& compared = comparison.scenes[scene];
  std::string body = element("h2", escaped(heading(compared))) + "\n";
  if (!compared.ground.empty())
    body += element("p", escaped("The ground moves by: " + compared.ground)) + "\n";
  if (has_motion(comparison, compared))
    body += element("h3", "The motion to look at") + player_part(comparison, scene) + "\n";
  for (const Figure* figure : figures_of(compared))
    body += element("h3", escaped(figure->title)) + scene_figure(results, comparison, scene, *figure) + "\n";
  body += parts_table(comparison, compared.name);
  body += impacts_table(comparison, compared.name);
  body += element("details", element("summary", fmt::format("The scene file of {}", escaped(compared.name))) +
                                 element("pre", element("code", escaped(compared.toml))));
  return element("section", "\n" + body, fmt::format(" id=\"{}\"", scene_anchor(scene))) + "\n";
}

std::optional<std::size_t> first_player(const Comparison& comparison) {
  for (std::size_t i = 0; i < comparison.scenes.size(); ++i)
    if (has_motion(comparison, comparison.scenes[i])) return i;
  return std::nullopt;
}

std::string contents_list(const Comparison& comparison) {
  const auto item = [](const std::string& anchor, const std::string& label) {
    return element("li", fmt::format("<a href=\"#{}\">{}</a>", anchor, escaped(label)));
  };
  std::string items;
  if (const std::optional<std::size_t> first = first_player(comparison))
    items += element("li", fmt::format("<a href=\"#{}\">Player</a>", player_anchor(*first)));
  items += item("summary", "Summary");
  for (std::size_t i = 0; i < comparison.scenes.size(); ++i)
    items += item(scene_anchor(i), comparison.scenes[i].title);
  if (!comparison.statements.empty()) items += item("statements", "What the paper says");
  items += item("runs", "All runs");
  items += item("parameters", "Parameters") + item("columns", "Columns") + item("again", "To run it again");
  return element("ul", items);
}

std::vector<std::string> counts_of(const Comparison& comparison) {
  const auto failed = static_cast<std::size_t>(std::count_if(comparison.runs.begin(), comparison.runs.end(),
                                                             [](const Run& run) { return !run.done(); }));
  std::vector<std::string> sentences{
      fmt::format("{} of {}; {} failed.", counted(comparison.runs.size(), "run"),
                  counted(comparison.scenes.size(), "scene"), failed == 0 ? "none" : std::to_string(failed))};
  if (!comparison.left_out.empty())
    sentences.push_back(fmt::format("This build leaves out {}.", joined(comparison.left_out)));
  return sentences;
}

std::string whole_summary(const Comparison& comparison) {
  std::string text = sentence_list(counts_of(comparison));
  for (std::size_t i = 0; i < comparison.scenes.size(); ++i) {
    const ComparedScene& scene = comparison.scenes[i];
    text += element("h3", fmt::format("<a href=\"#{}\">{}</a>", scene_anchor(i), escaped(scene.title))) +
            sentence_list(comparison.verdict.scenes[i]);
  }
  return text;
}

/// What a page begins with.
constexpr auto first_figure = "agreement";

std::string agreement_figure(const fs::path& results) {
  const std::string stem = first_figure;
  return fs::exists(results / "figures" / (stem + ".svg"))
             ? drawn_figure(results, stem, stem + "-", figure_in(stem)->title)
             : "";
}

/// Figures of the folder that belong to no scene, and those of a scene that nobody draws.
std::string further_figures(const fs::path& results, const Comparison& comparison) {
  std::set<std::string> known{first_figure};
  for (const ComparedScene& scene : comparison.scenes)
    for (const Figure* figure : figures_of(scene)) known.insert(figure_stem("", scene, *figure).filename());
  return drawn_figures(results, known);
}

std::string content(const fs::path& results, const Comparison& comparison) {
  std::string scenes;
  for (std::size_t i = 0; i < comparison.scenes.size(); ++i) scenes += scene_section(results, comparison, i);
  return filled_in(report_html, {{"title", escaped(comparison.title)},
                                 {"contents", contents_list(comparison)},
                                 {"answer", answer_box(comparison.verdict.headline)},
                                 {"first", agreement_figure(results)},
                                 {"figures", further_figures(results, comparison)},
                                 {"summary", whole_summary(comparison)},
                                 {"statements", statements_section(comparison)},
                                 {"table", runs_table(comparison)},
                                 {"contacts", contact_section(comparison)},
                                 {"remarks", remarks_section(comparison)},
                                 {"scenes", scenes},
                                 {"parameters", run_details(comparison)},
                                 {"files", file_links(results)},
                                 {"definitions", definition_list(comparison.definitions)},
                                 {"command", escaped(comparison.command)},
                                 {"environment", definition_list(comparison.environment)}});
}

}  // namespace

void write_report(const fs::path& results, const Comparison& comparison) {
  write_file(results / "report.html", page({comparison.title, "report", content(results, comparison)}));
}

}  // namespace rockstack::plots
