#include <fmt/format.h>

#include <random>

#include "analytic/scene/files/file_text.hpp"
#include "comparisons/measures/results/files.hpp"
#include "comparisons/measures/results/sentences.hpp"
#include "comparisons/studies/lessons/course/course.hpp"
#include "comparisons/suites/shipped.hpp"

namespace rockstack {
namespace {

namespace fs = std::filesystem;
using Places = std::map<std::string, std::string>;

std::vector<std::string> all_filled_in(const std::vector<std::string>& texts, const Places& places) {
  return each_of(texts, [&](const std::string& text) { return filled_in(text, places); });
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

fs::path file_of(const Lesson& lesson, const char* ending, const char* folder = "") {
  return shipped("studies/lessons") / folder / (lesson.name + ending);
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
          {"after", each_of(course.after, named)}};
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
      each_of(course.predictions, [&](const Problem& one) { return answered(one, values.measured); });
  json["text"] = file_text(file_of(lesson, ".html"));
  json["slides"] = file_text(file_of(lesson, ".html", "slides"));
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
  const Suite suite = read_suite(file_of(lesson, ".toml"), {});
  std::vector<RunMetrics> rows = compare({suite}, folder, options).rows;
  const LessonValues values = lesson.values(suite, rows);
  write_file(folder / "lesson.json", lesson_json(lesson, values, in_course).dump(2) + "\n");
  return rows;
}

std::string course_json() {
  const auto list =
      each_of(lessons(), [](const Lesson& lesson) { return summary(lesson, read_course(lesson.name)); });
  return Json{{"lessons", list}}.dump(2) + "\n";
}

}  // namespace rockstack
