#pragma once

#include <filesystem>

namespace rockstack::plots {

/// Draws one motion, as results/figures/histories.png, .svg and .pdf, and ground-motion likewise where the
/// ground moves.
/// @throws InputError naming the file that is missing or malformed; std::runtime_error where gnuplot fails.
void draw_motion(const std::filesystem::path& results);

}  // namespace rockstack::plots
