#pragma once

#include "comparisons/measures/results/files.hpp"
#include "comparisons/measures/results/sentences.hpp"
#include "plots/figures/figure.hpp"
#include "rockstack_plots_texts.hpp"

namespace rockstack::plots {

// What pages are made of. Where there are attributes, they start with a space.

/// Text for use inside an element or a quoted attribute.
std::string escaped(std::string_view text);

/// <name>content</name>, the content as it is.
inline std::string element(const std::string& name, const std::string& content,
                           const std::string& attributes = "") {
  return fmt::format("<{0}{1}>{2}</{0}>", name, attributes, content);
}

/// The parts of a text that semicolons set apart.
std::vector<std::string> parts_of(const std::string& text);

/// What a description says under a name, as it is and for use in a page.
inline std::string text_at(const Json& json, const char* key) {
  return json.at(key).get<std::string>();
}
inline std::string escaped_at(const Json& json, const char* key) {
  return escaped(text_at(json, key));
}

/// The solver that a row or trial names, "bullet:nncg".
inline std::string solver_named(const Json& row) {
  return text_at(row, "engine") + ":" + text_at(row, "solver");
}

/// A link; "#id" leads to a place of the page itself. `words` are markup.
inline std::string link(const std::string& to, const std::string& words) {
  return element("a", words, fmt::format(" href=\"{}\"", to));
}

/// What is seen when its summary is chosen; both are markup.
inline std::string details(const std::string& summary, const std::string& content,
                           const std::string& attributes = "") {
  return element("details", element("summary", summary) + content, attributes) + "\n";
}

/// A section under its title, which is text.
inline std::string section(const std::string& title, const std::string& content,
                           const std::string& attributes = "") {
  return element("section", "\n" + element("h2", escaped(title)) + "\n" + content, attributes) + "\n";
}

inline std::string code_block(const std::string& text) {
  return element("pre", element("code", escaped(text)));
}

/// The part of an SVG file that stands inside a page: without its preamble, every id begun with `prefix`,
/// with `label` as its text for those who do not see it.
std::string inline_svg(const std::string& file, const std::string& prefix, const std::string& label);

/// Scripts of players.
inline std::string player_scripts() {
  return std::string(stack_js) + std::string(film_js) + std::string(player_js);
}

/// A page that needs nothing beside itself, or where it solves the script `solver` alone: its header and main
/// section in the frame, style and script of all pages. `title` is plain text, `kind` is for the style sheet:
/// "report" or "lesson".
std::string page(const std::string& title, const std::string& kind, const std::string& content,
                 const std::string& solver = "");

/// Address of the solver that a course's pages share, for those in a folder of it: "solver.js" or
/// "../solver.js". Empty where pages of the folder have their own, or the one there is another program's.
std::string shared_solver(const fs::path& folder);

/// The exact solver and the engine that pages hold, or the script that pages share, and then scripts that ask
/// them, for the end of a body.
std::string solving_scripts(std::initializer_list<std::string_view> list, const std::string& shared = "");

/// The sentences that a reader came for, in a box of their own; nothing where there are none.
std::string answer_box(const std::vector<std::string>& sentences);

std::string sentence_list(const std::vector<std::string>& sentences);

/// A table of rows whose headings sort it.
std::string table(const std::vector<std::string>& columns, const std::string& rows);

/// Table in an element that scrolls by itself, as `label` calls it, and of sentences under a title, with
/// what stands between.
inline std::string wide_table(const std::vector<std::string>& columns, const std::string& rows,
                              const std::string& label) {
  return element("div", table(columns, rows),
                 fmt::format(" class=\"scroll\" tabindex=\"0\" role=\"region\" aria-label=\"{}\"", label));
}
inline std::string titled_table(const std::string& title, const std::vector<std::string>& columns,
                                const std::string& rows, const std::string& between = "") {
  return element("h3", title) + between + element("div", table(columns, rows), " class=\"statements\"") +
         "\n";
}

/// A row of cells as table_cell() makes them. Precondition: as many cells as columns.
std::string table_row(const std::vector<std::string>& columns, const std::vector<std::string>& cells,
                      const std::string& attributes = "");

/// Names and texts, one under the other.
std::string definition_list(const Facts& facts);

/// A cell of a table, of a class where one is named. Counts stand as they are, other numbers with
/// `significant` digits; the whole number is kept for sorting and as a tooltip.
std::string table_cell(const std::string& column, const std::string& cell, const std::string& kind = "",
                       int significant = 4);

/// A column's heading, which sorts when chosen: "rms_angle_difference" as words that may break into lines.
/// One without words does not.
std::string heading(std::string column, const std::string& kind = "");

/// A figure results/figures/STEM.svg that has been drawn, with its question and how to read it; every id in
/// it begins with `prefix`, and `label` is for those who do not see it.
/// @throws InputError naming the file that is missing.
std::string drawn_figure(const fs::path& results, const std::string& stem, const std::string& prefix,
                         const std::string& label);

/// Files of a folder with one of these endings, sorted; none where there is no folder.
std::set<std::string> names_in(const fs::path& folder, const std::set<std::string>& endings);

/// All figures that have been drawn without those that are `known`, each under its title.
std::string drawn_figures(const fs::path& results, const std::set<std::string>& known = {});

/// The figure of a scene, likewise.
std::string scene_figure(const fs::path& results, const Comparison& comparison, std::size_t scene,
                         const Figure& figure);

/// Links to the tables and descriptions of a folder, CSV and JSON, that stand beside its page.
std::string file_links(const fs::path& results);

}  // namespace rockstack::plots
