#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "analytic/scene/messages/input_error.hpp"
#include "comparisons/lessons/lesson.hpp"
#include "comparisons/program/commands.hpp"
#include "comparisons/program/output.hpp"
#include "comparisons/results/results_folder.hpp"
#ifdef ROCKSTACK_WITH_PLOTS
#include "plots/figures/comparison/figures.hpp"
#include "plots/pages/lesson.hpp"
#include "plots/pages/report.hpp"
#endif

namespace rockstack {
namespace {

void list_lessons(const Common& common) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const Lesson& lesson : lessons()) list.push_back({{"name", lesson.name}, {"title", title(lesson)}});
  if (common.json) return fmt::print("{}\n", list.dump(2));
  for (std::size_t i = 0; i < list.size(); ++i)
    fmt::print("{}  {:<14} {}\n", i + 1, list[i]["name"].get<std::string>(),
               list[i]["title"].get<std::string>());
}

#ifdef ROCKSTACK_WITH_PLOTS
void print_lesson(const std::filesystem::path& folder, const Common& common) {
  const std::string page = (folder / "lesson.html").string();
  if (common.json) {
    fmt::print("{}\n", nlohmann::ordered_json{{"lesson", page}, {"folder", folder.string()}}.dump(2));
  } else if (!common.quiet) {
    fmt::print("lesson: {}\n", page);
  }
}
#endif

}  // namespace

int teach_command(const TeachArguments& arguments, const Common& common) {
  refuse_overrides(common, "a lesson's text is about its own scenes; `rockstack compare` takes it");
  if (arguments.lesson.empty()) {
    list_lessons(common);
    return 0;
  }
  const Lesson& lesson = find_lesson(arguments.lesson);
  if (arguments.out.empty()) throw InputError("--out: missing, must be a folder for the lesson's page");
  const ResultsFolder folder(arguments.out, Results::lesson);
  const std::vector<RunMetrics> rows =
      run_lesson(lesson, arguments.out, {.command = common.command, .progress = progress(common)});
#ifdef ROCKSTACK_WITH_PLOTS
  plots::draw_figures(arguments.out);
  plots::write_report(arguments.out);
  plots::write_lesson(arguments.out);
  print_lesson(arguments.out, common);
#else
  print_report(arguments.out, common);
#endif
  return std::any_of(rows.begin(), rows.end(),
                     [](const RunMetrics& row) { return row.status != RunStatus::done; })
             ? 1
             : 0;
}

}  // namespace rockstack
