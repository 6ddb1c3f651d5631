#include "comparisons/lessons/lesson.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

#include "analytic/scene/messages/input_error.hpp"
#include "comparisons/results/files.hpp"
#include "comparisons/suites/shipped.hpp"

namespace rockstack {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

fs::path file_of(const Lesson& lesson, const char* ending) {
  return shipped("lessons") / (lesson.name + ending);
}

std::string text_of(const Lesson& lesson) {
  const fs::path file = file_of(lesson, ".html");
  std::ifstream in(file, std::ios::binary);
  if (!in) throw InputError(file.string() + ": cannot be read");
  return {std::istreambuf_iterator<char>(in), {}};
}

Json lesson_json(const Lesson& lesson, const Suite& suite, const LessonValues& values) {
  const auto place = std::find_if(lessons().begin(), lessons().end(),
                                  [&](const Lesson& one) { return one.name == lesson.name; });
  Json json{{"name", lesson.name},
            {"number", place - lessons().begin() + 1},
            {"count", lessons().size()},
            {"title", suite.title},
            {"text", text_of(lesson)},
            {"numbers", values.numbers},
            {"tables", Json::object()},
            {"player",
             {{"time", values.player.time},
              {"speed", values.player.speed},
              {"gain", values.player.gain},
              {"overlaid", values.player.overlaid},
              {"chatter", values.player.chatter}}}};
  for (const auto& [name, table] : values.tables)
    json["tables"][name] = {{"columns", table.columns}, {"rows", table.rows}};
  return json;
}

}  // namespace

const std::vector<Lesson>& lessons() {
  static const std::vector<Lesson> list{
      {"housner", housner_values},
      {"projection", projection_values},
      {"separation", separation_values},
      {"still-base", still_base_values},
      {"soft-contacts", soft_contacts_values},
      {"steps", steps_values},
      {"chatter", chatter_values},
      {"sensitivity", sensitivity_values},
      {"limits", limits_values},
      {"friction", friction_values},
      {"lift-off", lift_off_values},
      {"contact-models", contact_models_values},
  };
  return list;
}

std::string title(const Lesson& lesson) {
  return read_suite(file_of(lesson, ".toml"), {}).title;
}

const Lesson& find_lesson(const std::string& name) {
  std::string names;
  for (const Lesson& lesson : lessons()) {
    if (lesson.name == name) return lesson;
    names += (names.empty() ? "" : ", ") + lesson.name;
  }
  throw InputError(fmt::format("teach {}: must be one of {}", name, names));
}

std::vector<RunMetrics> run_lesson(const Lesson& lesson, const fs::path& folder,
                                   const CompareOptions& options) {
  const Suite suite = read_suite(file_of(lesson, ".toml"), {});
  std::vector<RunMetrics> rows = compare({suite}, folder, options).rows;
  const LessonValues values = lesson.values(suite, rows);
  write_file(folder / "lesson.json", lesson_json(lesson, suite, values).dump(2) + "\n");
  return rows;
}

}  // namespace rockstack
