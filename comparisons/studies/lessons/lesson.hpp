#pragma once

#include <string>
#include <vector>

#include "comparisons/studies/lessons/values.hpp"

namespace rockstack {

/// A lesson: a suite, NAME.toml, a text with places for values, NAME.html, and what computes the values once
/// the suite has been run. Both files are in this folder; what makes a course of them is in course/.
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

}  // namespace rockstack
