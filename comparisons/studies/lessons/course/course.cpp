#include "comparisons/studies/lessons/course/course.hpp"

#include <fmt/format.h>

#include <random>

#include "analytic/scene/files/file_text.hpp"
#include "analytic/scene/input/toml_reader.hpp"
#include "comparisons/measures/results/files.hpp"
#include "comparisons/measures/results/sentences.hpp"
#include "comparisons/suites/shipped.hpp"

namespace rockstack {
namespace {

// Keys of files that nobody but the lessons has; what they mean stands at the members that they fill.

const KeyTable course_keys{"",
                           "a lesson as part of a course",
                           {{"place"},
                            {"minutes"},
                            {"pattern"},
                            {"after"},
                            {"aims"},
                            {"references"},
                            {"predictions"},
                            {"problems"}}};

const KeyTable problem_keys{"[[problems]]",
                            "a question with its scene",
                            {{"name"}, {"text"}, {"scene"}, {"set"}, {"against"}, {"draw"}, {"parts"}}};

const KeyTable part_keys{
    "parts",
    "one thing that is asked",
    {{"ask"}, {"answer"}, {"choices"}, {"bounds"}, {"unit"}, {"digits"}, {"within"}, {"why"}}};

std::vector<std::string> texts(const Node& table, const char* key) {
  const Node* node = find(table, key);
  if (node == nullptr || node->children.empty()) return {};
  return mapped(entries(*node, "an array of texts"), text);
}

std::string text_or_none(const Node& table, const char* key) {
  const Node* node = find(table, key);
  return node == nullptr ? "" : text(*node);
}

std::vector<double> read_bounds(const Node& table, std::size_t choices) {
  const Node* node = find(table, "bounds");
  if (node == nullptr && choices == 0) return {};
  const Node& array = node == nullptr ? required(table, "bounds", "given beside choices") : *node;
  std::vector<double> bounds = numbers(array);
  if (bounds.size() + 1 != choices || !std::is_sorted(bounds.begin(), bounds.end()))
    throw wrong_value(array, "ascending numbers, one fewer than choices");
  return bounds;
}

Part read_part(const Node& table) {
  require_table(table, part_keys);
  Part part;
  part.ask = text(required(table, "ask", "a text"));
  part.answer = text(required(table, "answer", "a quantity"));
  part.choices = texts(table, "choices");
  part.bounds = read_bounds(table, part.choices.size());
  part.unit = text_or_none(table, "unit");
  if (const Node* node = find(table, "digits")) part.digits = static_cast<int>(whole_number(*node, 0, 9));
  if (const Node* node = find(table, "within")) part.within = number_above_zero(*node);
  part.why = text_or_none(table, "why");
  return part;
}

DrawnRange read_drawn_range(const Node& node) {
  const std::vector<double> values = numbers(node);
  if (values.size() != 3 || !(values[1] >= values[0]) || !(values[2] > 0))
    throw wrong_value(node, "[least, most, step] with least ≤ most and step > 0");
  return {node.name, values[0], values[1], values[2]};
}

Problem read_problem(const Node& table) {
  require_table(table, problem_keys);
  const Node* draw = find(table, "draw");
  return {
      .name = text_or_none(table, "name"),
      .text = text_or_none(table, "text"),
      .scene = text_or_none(table, "scene"),
      .changes = texts(table, "set"),
      .against = texts(table, "against"),
      .draw = mapped(draw == nullptr ? std::vector<Node>() : draw->children, read_drawn_range),
      .parts = mapped(entries(required(table, "parts", "what is asked"), "an array of tables"), read_part)};
}

std::vector<Problem> read_problems(const Node& root, const char* key) {
  return mapped(entries(required(root, key, "an array of tables"), "an array of tables"), read_problem);
}

namespace fs = std::filesystem;
using Places = std::map<std::string, std::string>;

std::vector<std::string> all_filled_in(const std::vector<std::string>& texts, const Places& places) {
  return mapped(texts, [&](const std::string& text) { return filled_in(text, places); });
}

std::size_t right_choice(const Part& part, double value) {
  const auto bound = std::lower_bound(part.bounds.begin(), part.bounds.end(), value);
  return static_cast<std::size_t>(bound - part.bounds.begin());
}

std::string shown(const Part& part, double value) {
  if (!part.choices.empty()) return part.choices[right_choice(part, value)];
  constexpr double large = 1e6;
  const std::string digits = std::abs(value) < large ? fixed(value, part.digits) : power(value, part.digits);
  return part.unit.empty() ? digits : fmt::format("{} {}", digits, part.unit);
}

Asked asked_in(const Problem& problem, const std::vector<std::string>& changes, const Places& places) {
  return problem.scene.empty() ? Asked() : asked_about(problem.scene, all_filled_in(changes, places));
}

/// Each value of the range as likely as any other, but for a share of 10⁻¹⁷ or so.
double drawn(const DrawnRange& range, std::mt19937_64& generator) {
  const auto count = static_cast<std::uint64_t>(std::floor((range.most - range.least) / range.step + 1.5));
  const double value = range.least + range.step * static_cast<double>(generator() % count);
  constexpr double digits = 1e9;  // 0.1 + 2 · 0.1 is 0.3
  return std::round(value * digits) / digits;
}

fs::path file_of(const std::string& lesson, const char* name) {
  return shipped("studies/lessons") / lesson / name;
}

std::size_t place_of(const std::string& name) {
  return static_cast<std::size_t>(std::ranges::find(lessons(), name, &Lesson::name) - lessons().begin());
}

Json summary(const Lesson& lesson, const CourseEntry& course) {
  const auto named = [](const std::string& name) {
    return Json{{"name", name}, {"title", title(find_lesson(name))}};
  };
  return {{"name", lesson.name},
          {"title", title(lesson)},
          {"number", place_of(lesson.name) + 1},
          {"count", lessons().size()},
          {"minutes", course.minutes},
          {"pattern", course.pattern},
          {"aims", course.aims},
          {"after", mapped(course.after, named)}};
}

Json lesson_json(const Lesson& lesson, const LessonValues& values, bool in_course) {
  const CourseEntry course = read_course(lesson.name);
  Json json = summary(lesson, course);
  const std::size_t place = place_of(lesson.name);
  if (in_course)
    json["neighbours"] = {{"previous", place > 0 ? lessons()[place - 1].name : ""},
                          {"next", place + 1 < lessons().size() ? lessons()[place + 1].name : ""}};
  json["references"] = course.references;
  json["predictions"] =
      mapped(course.predictions, [&](const Problem& one) { return answered(one, values.measured); });
  json["text"] = file_text(file_of(lesson.name, "text.html"));
  json["numbers"] = values.numbers;
  json["tables"] = Json::object();
  for (const auto& [name, table] : values.tables)
    json["tables"][name] = {{"columns", table.columns}, {"rows", table.rows}};
  json["player"] = {{"time", values.player.time},       {"speed", values.player.speed},
                    {"gain", values.player.gain},       {"overlaid", values.player.overlaid},
                    {"chatter", values.player.chatter}, {"finest", values.player.finest}};
  return json;
}

}  // namespace

CourseEntry read_course(const std::string& lesson) {
  const Node root = read_toml(file_of(lesson, "course.toml"));
  require_table(root, course_keys);
  constexpr double longest = 600;
  return {.aims = texts(root, "aims"),
          .minutes = static_cast<int>(whole_number(required(root, "minutes", "a whole number"), 1, longest)),
          .pattern = text(required(root, "pattern", "a pattern's name")),
          .after = texts(root, "after"),
          .references = texts(root, "references"),
          .predictions = read_problems(root, "predictions"),
          .problems = read_problems(root, "problems")};
}

Json answered(const Problem& problem, const std::map<std::string, double>& numbers) {
  Places places;
  for (const auto& [name, number] : numbers) places[name] = cell(number);
  Asked asked = asked_in(problem, problem.changes, places);
  Asked other = problem.against.empty() ? Asked() : asked_in(problem, problem.against, places);
  asked.numbers = other.numbers = numbers;
  Json parts = Json::array();
  for (Part part : problem.parts) {
    part.choices = all_filled_in(part.choices, places);
    const double divisor = problem.against.empty() ? 1 : quantity(part.answer, other);
    const double value = quantity(part.answer, asked) / divisor;
    parts.push_back({{"ask", filled_in(part.ask, places)},
                     {"choices", part.choices},
                     {"unit", part.unit},
                     {"within", part.within},
                     {"value", value},
                     {"shown", shown(part, value)},
                     {"why", part.why}});
    if (!part.choices.empty()) parts.back()["right"] = right_choice(part, value);
  }
  return {{"name", problem.name}, {"text", filled_in(problem.text, places)}, {"parts", parts}};
}

Json sheet_json(const std::string& lesson, const std::string& title, std::uint64_t seed) {
  std::mt19937_64 generator(seed ^ checksum(lesson));
  Json problems = Json::array();
  for (const Problem& problem : read_course(lesson).problems) {
    std::map<std::string, double> numbers;
    for (const DrawnRange& range : problem.draw) numbers[range.name] = drawn(range, generator);
    problems.push_back(answered(problem, numbers));
  }
  return {{"lesson", lesson}, {"title", title}, {"seed", seed}, {"problems", problems}};
}

std::vector<RunMetrics> run_lesson(const Lesson& lesson, const fs::path& folder, bool in_course,
                                   const CompareOptions& options) {
  const Suite suite = read_suite(file_of(lesson.name, "suite.toml"), {});
  std::vector<RunMetrics> rows = compare({suite}, folder, *make_threads(1), options).rows;
  const LessonValues values = lesson.values(suite, rows);
  write_file(folder / "lesson.json", lesson_json(lesson, values, in_course).dump(2) + "\n");
  return rows;
}

std::string course_json() {
  const auto list =
      mapped(lessons(), [](const Lesson& lesson) { return summary(lesson, read_course(lesson.name)); });
  return Json{{"lessons", list}}.dump(2) + "\n";
}

}  // namespace rockstack
