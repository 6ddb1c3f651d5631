#include "plots/pages/lesson.hpp"

#include <fmt/core.h>

#include <map>
#include <set>

#include "analytic/scene/messages/input_error.hpp"
#include "comparisons/results/files.hpp"
#include "plots/data/json_file.hpp"
#include "plots/pages/html.hpp"
#include "plots/pages/page_parts.hpp"
#include "plots/pages/player.hpp"
#include "plots/pages/template.hpp"

namespace rockstack::plots {
namespace {

namespace fs = std::filesystem;
using Values = std::map<std::string, std::string>;

/// As many digits as tell the numbers of a column apart, four at least: times of chatter need more than
/// those of swings.
int digits_of(const Json& rows, std::size_t column) {
  std::set<std::string> numbers;
  for (const Json& row : rows)
    if (const std::string cell = row.at(column).get<std::string>(); number_in(cell)) numbers.insert(cell);
  constexpr int fewest = 4, most = 9;
  for (int significant = fewest; significant < most; ++significant) {
    std::set<std::string> shown;
    for (const std::string& number : numbers)
      shown.insert(fmt::format("{:.{}g}", *number_in(number), significant));
    if (shown.size() == numbers.size()) return significant;
  }
  return most;
}

std::string lesson_table(const Json& json) {
  const auto columns = json.at("columns").get<std::vector<std::string>>();
  std::vector<int> significant;
  for (std::size_t i = 0; i < columns.size(); ++i) significant.push_back(digits_of(json.at("rows"), i));
  std::string rows;
  for (const Json& row : json.at("rows")) {
    std::string cells;
    for (std::size_t i = 0; i < columns.size(); ++i)
      cells += table_cell(columns[i], row.at(i).get<std::string>(), "", significant[i]);
    rows += element("tr", cells) + "\n";
  }
  return table(columns, rows);
}

/// Names with a colon are parts of a page; numbers have none.
void add_parts(const fs::path& results, const Comparison& comparison, const Json& start, Values& values) {
  for (std::size_t i = 0; i < comparison.scenes.size(); ++i) {
    const ComparedScene& scene = comparison.scenes[i];
    if (has_motion(comparison, scene)) values["player:" + scene.name] = player_part(comparison, i, start);
    for (const FigureKind& kind : figure_kinds())
      if (has_figure(scene, kind))
        values[fmt::format("figure:{}.{}", scene.name, kind.name)] =
            figure_part(results, comparison, i, kind);
  }
}

Values values_of(const fs::path& results, const Comparison& comparison, const Json& lesson) {
  Values values;
  for (const auto& [name, value] : lesson.at("numbers").items())
    values[name] = escaped(value.get<std::string>());
  for (const auto& [name, value] : lesson.at("tables").items()) values["table:" + name] = lesson_table(value);
  add_parts(results, comparison, lesson.value("player", Json()), values);
  return values;
}

std::string lesson_page(const fs::path& results, const Json& lesson) {
  const Comparison comparison = read_comparison(results);
  const std::string title = lesson.at("title").get<std::string>();
  const std::string text = lesson.at("text").get<std::string>();
  return page({title, "lesson",
               filled_in(lesson_html, {{"title", escaped(title)},
                                       {"number", escaped(lesson.at("number").dump())},
                                       {"count", escaped(lesson.at("count").dump())},
                                       {"text", filled_in(text, values_of(results, comparison, lesson))},
                                       {"command", escaped(comparison.command)},
                                       {"environment", definition_list(comparison.environment)}})});
}

}  // namespace

bool has_lesson(const std::filesystem::path& results) {
  return std::filesystem::exists(results / "lesson.json");
}

void write_lesson(const std::filesystem::path& results) {
  const std::filesystem::path file = results / "lesson.json";
  std::string text;
  try {
    text = lesson_page(results, read_json(file));
  } catch (const nlohmann::json::exception& error) {
    throw InputError(fmt::format("{}: {}", file.string(), error.what()));
  }
  write_file(results / "lesson.html", text);
}

}  // namespace rockstack::plots
