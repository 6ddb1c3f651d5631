#pragma once

#include <filesystem>

namespace rockstack::plots {

/// True where a folder holds the results of a study of stability.
bool has_stability(const std::filesystem::path& results);

/// Draws stability.csv and steps.csv as results/figures/stability.<engine>-<solver>-<settings>.png and .svg:
/// a map of verdicts over the study's axis and the time step, with the largest stable step as a line.
/// @throws InputError naming the file that is missing or malformed; std::runtime_error where gnuplot fails.
void draw_stability(const std::filesystem::path& results);

}  // namespace rockstack::plots
