#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "comparisons/runs/compare.hpp"
#include "comparisons/studies/lessons/lesson.hpp"

namespace rockstack {

/// Runs a lesson's suite as compare() does, and writes FOLDER/lesson.json: text, numbers, tables, and what is
/// to be predicted with its answers. `in_course`: the folders of its neighbours lie beside it.
std::vector<RunMetrics> run_lesson(const Lesson& lesson, const std::filesystem::path& folder, bool in_course,
                                   const CompareOptions& options);

/// All lessons in their order, each with aims, minutes and those that come first, as JSON.
/// @throws InputError as read_course().
std::string course_json();

}  // namespace rockstack
