#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "plots/figures/figure.hpp"

namespace rockstack::plots {

/// All figures, in the order of pages.
const std::vector<Figure>& figures();

/// The figures that a scene's results have data for.
std::vector<const Figure*> figures_of(const ComparedScene& scene);

/// The figure that a file is of, by its name without folder and ending; null where nobody draws such a file.
const Figure* figure_in(const std::string& stem);

/// Where a figure of a scene lies, without .png, .svg or .pdf.
std::filesystem::path figure_stem(const std::filesystem::path& results, const ComparedScene& scene,
                                  const Figure& figure);

/// Draws all figures of a comparison, or of one motion, as results/figures/<scene>.<figure>.png, .svg and
/// .pdf.
/// @throws InputError naming the file that is missing or malformed; std::runtime_error where gnuplot fails.
void draw_figures(const std::filesystem::path& results, const Comparison& comparison);

/// Draws the figures of what is neither, whose files are there, as results/figures/<figure>.png, .svg and
/// .pdf. @throws likewise.
void draw_figures(const std::filesystem::path& results);

}  // namespace rockstack::plots
