#pragma once

#include <filesystem>

namespace rockstack::plots {

/// True where a results folder is that of a course: it has course.json.
bool has_course(const std::filesystem::path& results);

/// Writes results/index.html from course.json: all lessons with aims, time and those that come first, each
/// with a link to its folder. @throws InputError naming the file that is missing or malformed.
void write_course(const std::filesystem::path& results);

}  // namespace rockstack::plots
