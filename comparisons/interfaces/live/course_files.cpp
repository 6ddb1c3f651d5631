#include "comparisons/interfaces/live/course_files.hpp"

#include <fmt/format.h>

#include "analytic/scene/messages/input_error.hpp"
#include "comparisons/studies/lessons/lesson.hpp"

namespace rockstack::live {
namespace {

namespace fs = std::filesystem;

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

}  // namespace

bool has_course_files(const fs::path& folder) {
  return fs::exists(folder / "course.json") || fs::exists(folder / "lesson.json");
}

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

}  // namespace rockstack::live
