#pragma once

#include <filesystem>

namespace rockstack::plots {

/// True where a folder holds the results of a sweep.
bool has_sweep(const std::filesystem::path& results);

/// Draws the summaries of a sweep that are there, as results/figures/<name>.png and .svg: fragility,
/// incremental, overturning and modes.
/// @throws InputError naming the file that is missing or malformed; std::runtime_error where gnuplot fails.
void draw_sweep(const std::filesystem::path& results);

}  // namespace rockstack::plots
