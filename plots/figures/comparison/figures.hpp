#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "plots/data/results.hpp"

namespace rockstack::plots {

/// Draws every figure of every scene of a results folder, as results/figures/<scene>.<figure>.png, .svg and
/// .pdf.
/// @throws InputError naming the file that is missing or malformed; std::runtime_error where gnuplot fails.
void draw_figures(const std::filesystem::path& results);

/// One kind of figure, in the order of a report.
struct FigureKind {
  std::string name;                        ///< part of the file's name
  std::string title;                       ///< heading in the report
  std::string explanation;                 ///< how to read it
  bool (*is_there)(const ComparedScene&);  ///< whether a scene's results have what it shows
};

const std::vector<FigureKind>& figure_kinds();

/// True where a scene has that figure.
bool has_figure(const ComparedScene& scene, const FigureKind& kind);

/// Where a figure lies, without .png, .svg or .pdf.
std::filesystem::path figure_stem(const std::filesystem::path& results, const std::string& scene,
                                  const std::string& kind);

}  // namespace rockstack::plots
