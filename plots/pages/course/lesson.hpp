#pragma once

#include <filesystem>

namespace rockstack::plots {

/// True where a results folder is that of a lesson: it has lesson.json.
bool has_lesson(const std::filesystem::path& results);

/// Writes results/lesson.html and results/slides.html from lesson.json and the comparison beside it: the
/// lesson's text with its numbers, tables, figures, players and predictions filled in. Precondition: the
/// figures are drawn.
/// @throws InputError naming the file that is missing or malformed; std::logic_error naming a place of the
/// text that has no value.
void write_lesson(const std::filesystem::path& results);

}  // namespace rockstack::plots
