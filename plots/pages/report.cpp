#include "plots/pages/sections.hpp"
#include "plots/pages/show.hpp"

namespace rockstack::plots {
namespace {

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
  return titled_table("Impacts, and what reading and chance alone would give", columns, rows);
}

/// What the paper says beside what was computed; nothing where no statements were asked for.
std::string statements_section(const Comparison& comparison) {
  if (comparison.statements.empty()) return "";
  const std::vector<std::string> columns{"Figure", "The paper says", "Verdict", "It holds if", "Computed"};
  const std::string rows =
      joined_texts(comparison.statements, [&](const auto& cells) { return table_row(columns, cells); });
  return section("What the paper says, and what was computed",
                 element("div", table(columns, rows), " class=\"statements\""), " id=\"statements\"");
}

std::string scene_anchor(std::size_t scene) {
  return fmt::format("scene-{}", scene + 1);
}

std::string ground_of(const ComparedScene& scene) {
  return scene.ground.empty() ? "" : element("p", escaped("The ground moves by: " + scene.ground)) + "\n";
}

/// The first scene that has a motion to look at, or how many scenes there are.
std::size_t first_motion(const Comparison& comparison) {
  const auto found = std::ranges::find_if(
      comparison.scenes, [&](const ComparedScene& scene) { return has_motion(comparison, scene); });
  return static_cast<std::size_t>(found - comparison.scenes.begin());
}

std::size_t count_solvers(const std::vector<StepLine>& lines) {
  std::set<std::string> names;
  for (const StepLine& line : lines) names.insert(line.front().solver_name());
  return names.size();
}

/// Section of any but the first motion, which stands where the page begins.
std::string scene_section(const fs::path& results, const Comparison& comparison, std::size_t scene) {
  const ComparedScene& compared = comparison.scenes[scene];
  std::string body = ground_of(compared);
  if (has_motion(comparison, compared) && scene != first_motion(comparison))
    body += element("h3", "The motion to look at") + player_section(comparison, scene) + "\n";
  if (count_solvers(shown_lines(comparison, compared.name)) <
      count_solvers(step_lines(comparison, compared.name)))
    body += element(
        "p", "Figures over time show the solver of each engine that comes nearest at its finest step.");
  for (const Figure* figure : figures_of(compared))
    body += element("h3", escaped(figure->title)) + scene_figure(results, comparison, scene, *figure) + "\n";
  body += terms_table(comparison, compared.name) + impacts_table(comparison, compared.name) +
          details(fmt::format("The scene file of {}", escaped(compared.name)), code_block(compared.toml));
  return section(compared.heading, body, fmt::format(" id=\"{}\"", scene_anchor(scene)));
}

std::string contents_list(const Comparison& comparison) {
  std::string items;
  const auto add = [&](const std::string& anchor, const std::string& label) {
    items += element("li", link("#" + anchor, escaped(label)));
  };
  if (const std::size_t first = first_motion(comparison); first < comparison.scenes.size())
    add(player_anchor(first), "Player");
  add("summary", "Summary");
  for (std::size_t i = 0; i < comparison.scenes.size(); ++i) add(scene_anchor(i), comparison.scenes[i].title);
  if (!comparison.statements.empty()) add("statements", "What the paper says");
  add("runs", "All runs");
  add("parameters", "Parameters");
  add("columns", "Columns");
  add("again", "To run it again");
  return element("ul", items);
}

std::string whole_summary(const Comparison& comparison) {
  const auto failed = static_cast<std::size_t>(
      std::ranges::count_if(comparison.runs, [](const Run& run) { return !run.done(); }));
  std::vector<std::string> sentences{
      fmt::format("{} of {}; {} failed.", counted(comparison.runs.size(), "run"),
                  counted(comparison.scenes.size(), "scene"), failed == 0 ? "none" : std::to_string(failed))};
  if (!comparison.left_out.empty())
    sentences.push_back(fmt::format("This build leaves out {}.", joined(comparison.left_out)));
  std::string text = sentence_list(sentences);
  for (std::size_t i = 0; i < comparison.scenes.size(); ++i) {
    const ComparedScene& scene = comparison.scenes[i];
    text += element("h3", link("#" + scene_anchor(i), escaped(scene.title))) +
            sentence_list(comparison.verdict.scenes[i]);
  }
  return text;
}

/// What a page begins with, and what its words mean.
constexpr auto first_figure = "agreement";
constexpr auto first_words =
    "Default: the library's own parameters. Tuned: those that came nearest on other scenes. Replicates: the same "
    "run with its step and its scene changed a little.";

/// The verdict and its figure, and beside them the first motion to look at.
std::string first_screen(const fs::path& results, const Comparison& comparison) {
  const std::string stem = first_figure;
  std::string verdict = answer_box(comparison.verdict.headline);
  if (fs::exists(results / "figures" / (stem + ".svg")))
    verdict += element("p", first_words, " class=\"hint\"") +
               drawn_figure(results, stem, stem + "-", figure_in(stem)->title);
  std::string parts = element("div", verdict);
  if (const std::size_t scene = first_motion(comparison); scene < comparison.scenes.size())
    parts += element(
        "div", element("h2", escaped(comparison.scenes[scene].heading)) + player_section(comparison, scene));
  return element("div", parts, " class=\"first\"");
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
                                 {"first", first_screen(results, comparison)},
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

std::string content(const fs::path& results, const Motion& motion) {
  const Comparison& comparison = motion.comparison;
  const ComparedScene& scene = comparison.scenes.front();
  const std::string contents = element("ul", element("li", link("#" + player_anchor(0), "Player")));
  const std::string header =
      element("h1", escaped(scene.heading)) + element("nav", contents, " aria-label=\"Parts of this page\"") +
      answer_box({fmt::format("{}: {}.", run_label(comparison.runs.front()), motion.verdict)});
  std::string drawn;
  for (const Figure* figure : figures_of(scene)) drawn += scene_figure(results, comparison, 0, *figure);
  drawn += further_figures(results, comparison);
  const std::string again = code_block(comparison.command) +
                            details("The scene file", code_block(scene.toml)) +
                            details("The summary", definition_list(motion.summary)) +
                            element("p", "The tables as files: " + file_links(results));
  return element("header", header) + "\n" +
         element("main", "\n" + section("The motion", ground_of(scene) + player_section(comparison, 0)) +
                             contact_section(comparison) + section("Figures", drawn) +
                             section("To run it again", again));
}

}  // namespace

void write_report(const fs::path& results, const Comparison& comparison) {
  write_file(results / "report.html",
             page(comparison.title, "report", content(results, comparison), shared_solver(results)));
}

/// Writes the report of one motion.
void write_report(const fs::path& results, const Motion& motion) {
  write_file(results / "report.html", page(motion.comparison.title, "report", content(results, motion)));
}

}  // namespace rockstack::plots
