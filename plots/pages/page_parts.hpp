#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "plots/data/results.hpp"
#include "plots/figures/table.hpp"

namespace rockstack::plots {

// What pages are made of.

/// What pages differ in.
struct PageParts {
  std::string title;    ///< as plain text
  std::string kind;     ///< for the style sheet: "report" or "lesson"
  std::string content;  ///< header and main part
};

/// A page that needs nothing beside itself: its content in the frame, style and script of all pages.
std::string page(const PageParts& parts);

/// The sentences that a reader came for, in a box of their own; nothing where there are none.
std::string answer_box(const std::vector<std::string>& sentences);

/// Plain sentences as a list.
std::string sentence_list(const std::vector<std::string>& sentences);

/// A table of rows whose headings sort it.
std::string table(const std::vector<std::string>& columns, const std::string& rows);

/// A row of cells as table_cell() makes them. `attributes` starts with a space where there are any.
/// Precondition: as many cells as columns.
std::string table_row(const std::vector<std::string>& columns, const std::vector<std::string>& cells,
                      const std::string& attributes = "");

/// Names and texts, one under the other.
std::string definition_list(const Facts& facts);

/// A cell of a table, of a class where one is named. Counts stand as they are, other numbers with
/// `significant` digits; the whole number is kept for sorting and as a tooltip.
std::string table_cell(const std::string& column, const std::string& cell, const std::string& kind = "",
                       int significant = 4);

/// A column's heading, which sorts when chosen: "rms_angle_difference" as words that may break into lines.
std::string heading(std::string column, const std::string& kind = "");

/// A figure results/figures/STEM.svg that has been drawn, with its question and how to read it; every id in
/// it begins with `prefix`, and `label` is for those who do not see it.
/// @throws InputError naming the file that is missing.
std::string drawn_figure(const std::filesystem::path& results, const std::string& stem,
                         const std::string& prefix, const std::string& label);

/// All figures that have been drawn without those that are `known`, each under its title.
std::string drawn_figures(const std::filesystem::path& results, const std::set<std::string>& known = {});

/// The figure of a scene, likewise.
std::string scene_figure(const std::filesystem::path& results, const Comparison& comparison,
                         std::size_t scene, const Figure& figure);

/// Links to the tables and descriptions of a folder, CSV and JSON, that stand beside its page.
std::string file_links(const std::filesystem::path& results);

/// The id of the picture in a scene's player, which takes keys.
std::string player_anchor(std::size_t scene);

/// The player of a scene. Precondition: has_motion().
/// `start` is how it stands at first, by the names of lesson.json; null: at the beginning.
std::string player_part(const Comparison& comparison, std::size_t scene, const Json& start = {});

}  // namespace rockstack::plots
