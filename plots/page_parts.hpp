#pragma once

#include <filesystem>
#include <string>

#include "plots/figures.hpp"
#include "plots/results.hpp"

namespace rockstack::plots {

// What pages are made of.

/// Names and texts, one under the other.
std::string definition_list(const Facts& facts);

/// A cell of a table. Counts stand as they are, other numbers with four digits; the whole number is kept for
/// sorting and as a tooltip.
std::string table_cell(const std::string& column, const std::string& cell);

/// A column's heading, which sorts when chosen: "rms_angle_difference" as words that may break into lines.
std::string heading(std::string column);

/// A figure that has been drawn, with how to read it.
/// @throws InputError naming the file that is missing.
std::string figure_part(const std::filesystem::path& results, const Comparison& comparison, std::size_t scene,
                        const FigureKind& kind);

/// The player of a scene. Precondition: has_player().
std::string player_part(const Comparison& comparison, std::size_t scene);

/// Writes a page whole or not at all. @throws std::runtime_error naming the file.
void write_page(const std::filesystem::path& file, const std::string& text);

}  // namespace rockstack::plots
