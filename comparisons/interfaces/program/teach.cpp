#include <fmt/format.h>

#include "analytic/scene/files/file_text.hpp"
#include "comparisons/interfaces/program/commands.hpp"
#include "comparisons/measures/results/files.hpp"
#include "comparisons/studies/lessons/course/course.hpp"
#include "comparisons/suites/shipped.hpp"
#ifdef ROCKSTACK_WITH_PLOTS
#include "plots/pages/show.hpp"
#endif

namespace rockstack {
namespace {

struct TeachArguments {
  std::string lesson;  ///< empty or "list": list them; "all": the whole course
  std::filesystem::path out;
  std::optional<std::uint64_t> sheet;  ///< a problem sheet of that seed, in the place of the lesson
  bool pdf = false;                    ///< slides as PDF too
};

namespace fs = std::filesystem;

int list_lessons(const Common& common) {
  const Json list = mapped(lessons(), [](const Lesson& one) {
    return Json{{"name", one.name}, {"title", title(one)}};
  });
  if (!print_json(list, common)) return 0;
  for (std::size_t i = 0; const Lesson& lesson : lessons())
    fmt::print("{:2}  {:<14} {}\n", ++i, lesson.name, title(lesson));
  fmt::print("\nall of them, with an index: rockstack teach all --out DIR\n");
  return 0;
}

/// {"lesson": "DIR/lesson.html", …}, or a line for each.
void print_files(const Json& paths, const Common& common) {
  if (!print_json(paths, common)) return;
  for (const auto& [name, file] : paths.items()) fmt::print("{}: {}\n", name, file.get<std::string>());
}

/// Writes the pages of a results folder with a lesson, and slides as PDF where they are asked for.
void write_pages([[maybe_unused]] const fs::path& out, bool pdf) {
#ifdef ROCKSTACK_WITH_PLOTS
  plots::show(out);
  if (pdf) plots::print_pdf(out / "slides.html", out / "slides.pdf");
#else
  if (pdf) throw InputError("--pdf: must be asked of a build with ROCKSTACK_PLOTS=ON");
#endif
}

/// The files that a lesson has made, by what they are.
Json lesson_files(const fs::path& out) {
  Json paths;
  for (const auto& [name, file] :
       {std::pair{"lesson", "lesson.html"}, {"slides", "slides.html"}, {"pdf", "slides.pdf"}})
    if (fs::exists(out / file)) paths[name] = (out / file).string();
  return paths.empty() ? Json{{"lesson", (out / "lesson.json").string()}} : paths;
}

/// What a lesson's pages are made of: this program, the scenes and the texts that come with it.
std::string sources_of(const Lesson& lesson) {
  std::uint64_t sum = checksum(file_text("/proc/self/exe", largest_results));
  for (const fs::path& folder : {shipped("scenes"), shipped("studies/lessons") / lesson.name})
    for (const auto& entry : fs::recursive_directory_iterator(folder))
      if (entry.is_regular_file())
        sum += checksum(entry.path().filename().string() + file_text(entry.path()));
  return fmt::format("{:016x}\n", sum);
}

/// In the folder of a course's lesson whose pages are there: what they were made of.
constexpr auto finished_mark = ".finished";

/// Runs a lesson into a folder of its own. Returns 1 where one of its runs failed, else 0.
int teach(const Lesson& lesson, const fs::path& out, const TeachArguments& arguments, const Common& common) {
  const ResultsFolder folder(out, Results::lesson, lesson.name, common.replace);
  fs::remove(out / finished_mark);
  const std::vector<RunMetrics> rows = run_lesson(lesson, out, arguments.lesson == "all",
                                                  {.command = common.command, .progress = progress(common)});
  write_pages(out, arguments.pdf);
  print_files(lesson_files(out), common);
  const auto is_done = [](const RunMetrics& row) { return row.status == RunStatus::done; };
  return std::ranges::all_of(rows, is_done) ? 0 : 1;
}

/// Leaves of a course's lesson what its pages lead to: histories with fewer samples. They have their figures
/// in them.
void thin_results(const fs::path& lesson) {
  constexpr double interval = 2e-2;  // s
  std::error_code none;
  for (const auto& run : fs::directory_iterator(lesson / "runs", none)) thin_run(run.path(), interval);
  fs::remove_all(lesson / "figures");
}

/// Runs a lesson of a course, unless its pages are there that would come of it.
int teach_once(const Lesson& lesson, const fs::path& out, const TeachArguments& arguments,
               const Common& common) {
  const fs::path mark = out / finished_mark;
  const std::string sources = sources_of(lesson);
  if (fs::exists(mark) && file_text(mark) == sources && (!arguments.pdf || fs::exists(out / "slides.pdf"))) {
    print_files(lesson_files(out), common);
    return 0;
  }
  const int code = teach(lesson, out, arguments, common);
  if (code != 0) return code;
  thin_results(out);
  write_file(mark, sources);
  return code;
}

int teach_all(const TeachArguments& arguments, const Common& common) {
  const ResultsFolder folder(arguments.out, Results::course);
#ifdef ROCKSTACK_WITH_PLOTS
  plots::share_solver(arguments.out);
#endif
  int code = 0;
  for (const Lesson& lesson : lessons())
    code = std::max(code, teach_once(lesson, arguments.out / lesson.name, arguments, common));
  write_file(arguments.out / "course.json", course_json());
#ifdef ROCKSTACK_WITH_PLOTS
  plots::write_study_page(arguments.out);
  print_files({{"course", (arguments.out / "index.html").string()}}, common);
#endif
  return code;
}

/// Problem sheets of one seed: each with its questions, and a key of its own.
int write_sheets(const std::vector<Lesson>& chosen, const TeachArguments& arguments, const Common& common) {
  if (arguments.pdf) throw InputError("--pdf: must be left out beside --sheet, which prints from a browser");
  const ResultsFolder folder(arguments.out, Results::sheets);
  for (const Lesson& lesson : chosen) {
    const fs::path key = arguments.out / fmt::format("{}-key-{}.json", lesson.name, *arguments.sheet);
    write_file(key, sheet_json(lesson.name, title(lesson), *arguments.sheet).dump(2) + "\n");
#ifdef ROCKSTACK_WITH_PLOTS
    const plots::SheetPages pages = plots::write_sheet(key);
    print_files({{"sheet", pages.sheet.string()}, {"key", pages.key.string()}}, common);
#else
    print_files({{"key", key.string()}}, common);
#endif
  }
  return 0;
}

int run_teach(const TeachArguments& arguments, const Common& common) {
  refuse_overrides(common, "a lesson's text is about its own scenes; `rockstack compare` takes it");
  if (arguments.lesson.empty() || arguments.lesson == "list") return list_lessons(common);
  const std::vector<Lesson> chosen =
      arguments.lesson == "all" ? lessons() : std::vector<Lesson>{find_lesson(arguments.lesson)};
  if (arguments.sheet) return write_sheets(chosen, arguments, common);
  if (arguments.lesson == "all") return teach_all(arguments, common);
  return teach(chosen.front(), arguments.out, arguments, common);
}

void add_teach(CLI::App& command, TeachArguments& arguments) {
  command.add_option("lesson", arguments.lesson, "name of a lesson, or all; left out, or list: list them");
  add_results(command, arguments.out, [&] { return arguments.lesson; });
  command.add_flag("--pdf", arguments.pdf, "slides as PDF too, by Chromium");
  command
      .add_option("--sheet", arguments.sheet,
                  "write a problem sheet instead, its numbers drawn from this seed, and its key")
      ->check(CLI::Range(std::uint64_t{0}, std::uint64_t{1} << 53U));
}

}  // namespace

Command teach_command() {
  return make_command("teach", "list the lessons, or run one and write its page and slides", add_teach,
                      run_teach);
}

}  // namespace rockstack
