#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "comparisons/lessons/values.hpp"
#include "comparisons/runs/compare.hpp"

namespace rockstack {

/// A lesson: a suite, NAME.toml, a text with places for values, NAME.html, and what computes the values once
/// the suite has been run. Both files are in this folder.
struct Lesson {
  std::string name;
  LessonValues (*values)(const Suite& suite, const std::vector<RunMetrics>& rows);
};

/// In the order in which to read them.
const std::vector<Lesson>& lessons();

/// The lesson's title, from its suite. @throws InputError as read_suite().
std::string title(const Lesson& lesson);

/// @throws InputError naming what was asked for and what there is.
const Lesson& find_lesson(const std::string& name);

/// Runs a lesson's suite as compare() does, and writes FOLDER/lesson.json: text, numbers and tables.
std::vector<RunMetrics> run_lesson(const Lesson& lesson, const std::filesystem::path& folder,
                                   const CompareOptions& options);

}  // namespace rockstack
