#include "comparisons/interfaces/live/live_page.hpp"

#include <fmt/format.h>

#include "analytic/scene/ground/records/record_file.hpp"
#include "analytic/scene/input/key_json.hpp"
#include "analytic/scene/input/page_scene.hpp"
#include "analytic/scene/input/scene_file.hpp"
#include "analytic/scene/input/scene_keys.hpp"
#include "comparisons/interfaces/live/live_state.hpp"
#include "comparisons/studies/lessons/lesson.hpp"
#include "comparisons/suites/shipped.hpp"
#include "plots/pages/html.hpp"
#include "plots/pages/player_data.hpp"
#include "rockstack_live_texts.hpp"

namespace rockstack::live {
namespace {

namespace fs = std::filesystem;

/// The scene of a file as pages have it; paths of its records, which are added to `records`, hold anywhere.
Json scene_of(const fs::path& file, const std::vector<std::string>& overrides,
              std::set<std::string>& records) {
  const SceneDocument document = read_document(file, overrides);
  Json scene = page_scene(document.root);
  if (!scene.contains("title")) scene["title"] = document.title;
  for (const char* axis : {"horizontal", "vertical"}) {
    const Json::json_pointer place(std::string("/ground/") + axis + "/record");
    if (!scene.contains(place)) continue;
    const std::string path = fs::absolute(document.folder / scene[place].get<std::string>());
    scene[place] = path;
    records.insert(path);
  }
  return scene;
}

Json shipped_scenes(std::set<std::string>& records) {
  return mapped(shipped_names("scenes"), [&](const std::string& name) {
    return Json{{"name", name}, {"scene", scene_of(find_file(name, "scenes"), {}, records)}};
  });
}

Json setting_json(const Setting& setting) {
  return {{"name", setting.name},       {"default", setting.default_value},
          {"tuned", setting.tuned},     {"least", setting.least},
          {"most", setting.most},       {"whole", setting.whole},
          {"choices", setting.choices}, {"unit", setting.unit}};
}

Json engine_list() {
  return mapped(engines(), [](const WorkerEngine& engine) {
    return Json{{"name", engine.full_name()}, {"settings", mapped(engine.settings, setting_json)}};
  });
}

Json lesson_list(const PageStart& start, std::set<std::string>& records) {
  Json list = Json::array();
  for (const auto& [name, scene] : start.lessons)
    list.push_back(
        {{"name", name}, {"title", title(find_lesson(name))}, {"scene", scene_of(scene, {}, records)}});
  return list;
}

Json state_json(const PageStart& start, std::set<std::string>& records) {
  return {{"scene", scene_of(start.scene, start.overrides, records)},
          {"engine", start.engine.empty() ? "" : find_engine(start.engine).full_name()},
          {"settings", "tuned"},
          {"dt", 1e-3},
          {"parameters", Json::object()},
          {"spread", 1e-3}};
}

std::map<std::string, fs::path> files_in(const fs::path& folder) {
  std::map<std::string, fs::path> files;
  try {
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder))
      if (!entry.is_symlink() && entry.is_regular_file())
        files.emplace(entry.path().lexically_relative(folder).generic_string(), fs::absolute(entry.path()));
  } catch (const fs::filesystem_error& error) {
    throw InputError(error.what());
  }
  return files;
}

/// The files that are there now; what a link leads to is none of them.
/// @throws InputError for a folder without pages, or of which not all can be read.
CourseFiles course_files(const fs::path& folder) {
  CourseFiles course;
  course.files = files_in(folder);
  for (const Lesson& lesson : lessons())
    if (const std::string page = lesson.name + "/lesson.html"; course.files.contains(page))
      course.lessons.emplace(lesson.name, page);
  for (const char* page : {"index.html", "lesson.html"})
    if (course.first.empty() && course.files.contains(page)) course.first = page;
  if (course.first.empty())
    throw InputError(
        fmt::format("{}: must hold pages; `rockstack plot` writes them from results", folder.string()));
  return course;
}

}  // namespace

LivePage make_live_page(const PageStart& start) {
  LivePage page;
  for (const auto& record : start.records) page.records.insert(fs::absolute(record));
  const Json state = state_json(start, page.records);
  MotionLibrary library;
  read_state(state, page.records, library);
  for (const auto& record : start.records) read_record(record, start.limits);
  const Json scenes = shipped_scenes(page.records), lessons = lesson_list(start, page.records);
  if (!start.course.empty()) page.course = course_files(start.course);
  const Json setup{{"start", state},
                   {"scenes", scenes},
                   {"engines", engine_list()},
                   {"records", page.records},
                   {"limits", start.limits == RecordLimits::none ? Json{{"limits", "none"}} : Json::object()},
                   {"lesson", start.lesson},
                   {"lessons", lessons},
                   {"pages", page.course.lessons},
                   {"blocks", most_blocks},
                   {"keys", mapped(scene_tables, [](const KeyTable* table) { return key_json(*table); })}};
  const std::string player =
      filled_in(plots::player_html, {{"id", "player"}, {"title", "the scene"}, {"data", "null"}});
  page.text = filled_in(
      live_html,
      {{"css", std::string(plots::page_css) + std::string(plots::player_css) + std::string(live_css)},
       {"player", player},
       {"setup", plots::for_script(setup)},
       {"player_js", plots::player_scripts()},
       {"controls_js", std::string(controls_js)},
       {"charts_js", std::string(plots::charts_js) + std::string(plots::drag_js)},
       {"js", std::string(live_js)}});
  return page;
}

}  // namespace rockstack::live
