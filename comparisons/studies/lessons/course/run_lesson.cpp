#include "comparisons/studies/lessons/course/run_lesson.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

#include "analytic/scene/messages/input_error.hpp"
#include "comparisons/measures/results/files.hpp"
#include "comparisons/studies/lessons/course/answered.hpp"
#include "comparisons/suites/shipped.hpp"

namespace rockstack {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

fs::path file_of(const Lesson& lesson, const char* ending) {
  return shipped("studies/lessons") / (lesson.name + ending);
}

std::string text_of(const Lesson& lesson) {
  const fs::path file = file_of(lesson, ".html");
  std::ifstream in(file, std::ios::binary);
  if (!in) throw InputError(file.string() + ": cannot be read");
  return {std::istreambuf_iterator<char>(in), {}};
}

std::size_t place_of(const std::string& name) {
  const auto place =
      std::find_if(lessons().begin(), lessons().end(), [&](const Lesson& one) { return one.name == name; });
  return static_cast<std::size_t>(place - lessons().begin());
}

/// What a course's list says of a lesson.
Json summary(const Lesson& lesson, const CourseEntry& course) {
  Json after = Json::array();
  for (const std::string& name : course.after)
    after.push_back({{"name", name}, {"title", title(find_lesson(name))}});
  return {{"name", lesson.name},
          {"title", title(lesson)},
          {"number", place_of(lesson.name) + 1},
          {"count", lessons().size()},
          {"minutes", course.minutes},
          {"aims", course.aims},
          {"after", after}};
}

Json predictions(const CourseEntry& course, const LessonValues& values) {
  Json list = Json::array();
  for (const Problem& problem : course.predictions)
    list.push_back(to_json(answered(problem, values.measured)));
  return list;
}

/// The names of the lessons before and after; empty: none.
Json neighbours(const Lesson& lesson) {
  const std::size_t place = place_of(lesson.name);
  return {{"previous", place > 0 ? lessons()[place - 1].name : ""},
          {"next", place + 1 < lessons().size() ? lessons()[place + 1].name : ""}};
}

Json lesson_json(const Lesson& lesson, const LessonValues& values, bool in_course) {
  const CourseEntry course = read_course(lesson.name);
  Json json = summary(lesson, course);
  if (in_course) json["neighbours"] = neighbours(lesson);
  json["references"] = course.references;
  json["predictions"] = predictions(course, values);
  json["text"] = text_of(lesson);
  json["numbers"] = values.numbers;
  json["tables"] = Json::object();
  for (const auto& [name, table] : values.tables)
    json["tables"][name] = {{"columns", table.columns}, {"rows", table.rows}};
  json["player"] = {{"time", values.player.time},
                    {"speed", values.player.speed},
                    {"gain", values.player.gain},
                    {"overlaid", values.player.overlaid},
                    {"chatter", values.player.chatter}};
  return json;
}

}  // namespace

std::vector<RunMetrics> run_lesson(const Lesson& lesson, const fs::path& folder, bool in_course,
                                   const CompareOptions& options) {
  const Suite suite = read_suite(file_of(lesson, ".toml"), {});
  std::vector<RunMetrics> rows = compare({suite}, folder, options).rows;
  const LessonValues values = lesson.values(suite, rows);
  write_file(folder / "lesson.json", lesson_json(lesson, values, in_course).dump(2) + "\n");
  return rows;
}

std::string course_json() {
  Json list = Json::array();
  for (const Lesson& lesson : lessons()) list.push_back(summary(lesson, read_course(lesson.name)));
  return Json{{"lessons", list}}.dump(2) + "\n";
}

}  // namespace rockstack
