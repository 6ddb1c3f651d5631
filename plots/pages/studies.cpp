#include "comparisons/measures/results/csv.hpp"
#include "plots/figures/studies/sweep_facts.hpp"
#include "plots/pages/html.hpp"

namespace rockstack::plots {
namespace {

/// A table of the results under its name; nothing where they have none of that name.
std::string table_of(const fs::path& results, const std::string& name) {
  if (!fs::exists(results / name)) return "";
  const Table table = read_table(results / name);
  const std::string rows =
      joined_texts(table.rows, [&](const auto& row) { return table_row(table.columns, row); });
  return element("h3", escaped(name)) + wide_table(table.columns, rows, "Table") + "\n";
}

/// The sentences that a reader came for: one, several or, in results of before, none.
std::vector<std::string> headline_of(const Json& json) {
  const Json headline = json.value("headline", Json::array());
  return headline.is_string() ? std::vector{headline.get<std::string>()}
                              : headline.get<std::vector<std::string>>();
}

/// A list that is too long to be read as its length and its ends; the file of results has all of it.
void shorten(Json& list) {
  constexpr std::size_t longest = 1000;
  if (list.is_array() && list.size() > longest)
    list = fmt::format("{} values, {} to {}", list.size(), list.front().dump(), list.back().dump());
}

/// What the page has nowhere else.
Facts other_facts(Json json) {
  if (json.contains("vary"))
    for (Json& variation : json.at("vary"))
      for (Json& part : variation) shorten(part);
  for (const char* shown : {"title", "headline", "tables", "command", "trials", "cases", "disagreements",
                            "rows", "sets", "indices"})
    json.erase(shown);
  return facts_of(json);
}

/// Two digits are enough to tell steps apart.
std::string steps_text(double steps) {
  if (steps < 0.01) return "&lt; 0.01";
  return steps < 100 ? fmt::format("{:.2g}", steps) : fmt::format("{:.0f}", steps);
}

std::string verdict_cell(const Json& answer) {
  std::string text = escaped_at(answer, "verdict"), name = text;
  std::ranges::replace(name, ' ', '-');  // the class of the style sheet: another-law
  if (answer.at("verdict") != "no run")
    text += fmt::format("<br>{} → {}", steps_text(answer.at("steps_off").front()),
                        steps_text(answer.at("steps_off").back()));
  return element("td", text, fmt::format(" class=\"{}\" title=\"{}\"", name, escaped_at(answer, "reason")));
}

std::string canon_content(const Json& canon) {
  std::vector<std::string> columns{"engine, set"};
  std::string scenes;
  for (const Json& scene : canon.at("scenes")) {
    columns.push_back(scene.at("name"));
    scenes += details(escaped(text_at(scene, "name") + ": " + text_at(scene, "title")),
                      code_block(text_at(scene, "scene_file")));
  }
  const std::string rows = joined_texts(canon.at("rows"), [](const Json& row) {
    const std::string name = escaped(solver_named(row) + ", " + text_at(row, "settings"));
    return element("tr",
                   element("th", name, " scope=\"row\"") + joined_texts(row.at("answers"), verdict_cell)) +
           "\n";
  });
  return filled_in(canon_html,
                   {{"title", escaped_at(canon, "title")},
                    {"answer", answer_box(headline_of(canon))},
                    {"coarse", fmt::format("{:g}", 1000 * canon.at("steps").front().get<double>())},
                    {"fine", fmt::format("{:g}", 1000 * canon.at("steps").back().get<double>())},
                    {"agreement", fmt::format("{:g}", canon.at("agreement").get<double>())},
                    {"replicates", canon.at("replicates").dump()},
                    {"table", table(columns, rows)},
                    {"scenes", scenes},
                    {"command", escaped_at(canon, "command")}});
}

}  // namespace

void write_study(const fs::path& results, const Json& json) {
  const std::string title = text_at(json, "title");
  // A sweep's command stands beside its results, which are the same bytes whatever it is.
  const fs::path timing = results / "timing.json";
  const std::string command =
      json.value("command", fs::exists(timing) ? read_json(timing).value("command", "") : "");
  const Facts facts = other_facts(json);
  const std::string done =
      (command.empty() ? "" : element("p", "By this command:") + code_block(command)) +
      (facts.empty() ? "" : details("Scene, values, versions and machine", definition_list(facts)));
  const std::string content = filled_in(
      study_html, {{"title", escaped(title)},
                   {"answer", answer_box(headline_of(json))},
                   {"figures", drawn_figures(results)},
                   {"files", file_links(results)},
                   {"tables", joined_texts(json.value("tables", std::vector<std::string>()),
                                           [&](const std::string& name) { return table_of(results, name); })},
                   {"done_link", done.empty() ? "" : element("li", link("#facts", "What was done"))},
                   {"done", done.empty() ? "" : section("What was done", done, " id=\"facts\"")}});
  write_file(results / "report.html", page(title, "report", content));
}

void write_canon_report(const fs::path& results, const Json& canon) {
  write_file(results / "report.html", page(canon.at("title"), "report", canon_content(canon)));
}

}  // namespace rockstack::plots
