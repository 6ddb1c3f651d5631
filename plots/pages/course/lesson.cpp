#include "plots/pages/pages.hpp"

#include <fmt/core.h>

#include <map>
#include <set>

#include "comparisons/measures/results/csv.hpp"
#include "comparisons/measures/results/files.hpp"
#include "plots/data/results.hpp"
#include "plots/pages/course/predictions.hpp"
#include "plots/pages/html.hpp"
#include "plots/pages/page_parts.hpp"
#include "plots/pages/player.hpp"
#include "plots/pages/templates.hpp"

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
    for (const Figure* figure : figures_of(scene))
      values[fmt::format("figure:{}.{}", scene.name, figure->name)] =
          scene_figure(results, comparison, i, *figure);
  }
}

Values values_of(const fs::path& results, const Comparison& comparison, const Json& lesson) {
  Values values;
  for (const auto& [name, value] : lesson.at("numbers").items())
    values[name] = escaped(value.get<std::string>());
  const Values numbers = values;
  for (const auto& [name, value] : lesson.at("tables").items()) values["table:" + name] = lesson_table(value);
  for (const Json& question : lesson.at("predictions"))
    values["predict:" + question.at("name").get<std::string>()] = prediction_part(question, numbers);
  add_parts(results, comparison, lesson.value("player", Json()), values);
  return values;
}

std::string list_of(const Json& texts) {
  std::string items;
  for (const Json& text : texts) items += element("li", text.get<std::string>()) + "\n";
  return element("ul", items);
}

std::string link(const std::string& name, const std::string& words) {
  return fmt::format("<a href=\"../{}/lesson.html\">{}</a> ", escaped(name), words);
}

/// To the course and the lessons beside this one, where they are.
std::string navigation(const Json& lesson) {
  if (!lesson.contains("neighbours")) return "";
  const Json& beside = lesson.at("neighbours");
  const auto previous = beside.at("previous").get<std::string>(), next = beside.at("next").get<std::string>();
  std::string links = "<a href=\"../index.html\">All lessons</a> ";
  if (!previous.empty()) links += link(previous, "◀ the one before");
  if (!next.empty()) links += link(next, "the next one ▶");
  return element("nav", links, " class=\"bar\" aria-label=\"Course\"");
}

std::string titles_after(const Json& lesson) {
  std::string titles;
  for (const Json& one : lesson.at("after"))
    titles += fmt::format("{}<code>{}</code>", titles.empty() ? " · after " : ", ",
                          escaped(one.at("name").get<std::string>()));
  return titles;
}

/// The first scene's motion, where the text does not show it anyway.
std::string picture(const fs::path& results, const Comparison& comparison, const std::string& text) {
  const ComparedScene& scene = comparison.scenes.front();
  for (const Figure* figure : figures_of(scene))
    if (figure->name == "histories" &&
        text.find(fmt::format("{{{{figure:{}.histories}}}}", scene.name)) == std::string::npos)
      return scene_figure(results, comparison, 0, *figure);
  return "";
}

/// What a lesson's page and its slides share.
Values lesson_values(const fs::path& results, const Comparison& comparison, const Json& lesson) {
  const auto words = [&](const char* key) { return escaped(lesson.at(key).get<std::string>()); };
  const auto text = lesson.at("text").get<std::string>();
  return {{"title", words("title")},
          {"name", words("name")},
          {"number", lesson.at("number").dump()},
          {"count", lesson.at("count").dump()},
          {"minutes", lesson.at("minutes").dump()},
          {"after", titles_after(lesson)},
          {"navigation", navigation(lesson)},
          {"aims", list_of(lesson.at("aims"))},
          {"references", list_of(lesson.at("references"))},
          {"picture", picture(results, comparison, text)},
          {"text", filled_in(text, values_of(results, comparison, lesson))},
          {"command", escaped(comparison.command)},
          {"environment", definition_list(comparison.environment)}};
}

std::string page_of(const std::string& title, Values values, const char* kind, std::string_view content,
                    std::string_view css, std::string_view script) {
  values["css"] = css;
  values["script"] = script;
  return page({title, kind, filled_in(content, values)});
}

}  // namespace

void write_lesson(const std::filesystem::path& results, const Comparison& comparison) {
  read_json(results / "lesson.json", [&](const Json& lesson) {
    const Values values = lesson_values(results, comparison, lesson);
    const auto title = lesson.at("title").get<std::string>();
    const std::string slides = page_of(title, values, "slides", slides_html, slides_css, slides_js);
    write_file(results / "lesson.html", page_of(title, values, "lesson", lesson_html, "", lesson_js));
    write_file(results / "slides.html", slides);
  });
}

}  // namespace rockstack::plots
