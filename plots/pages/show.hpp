#pragma once

#include "plots/data/results.hpp"

namespace rockstack::plots {

/// Whether a folder holds what `compare` or `teach` has run, and no study of it.
inline bool has_runs(const fs::path& results) {
  return fs::exists(results / "comparison.json") && !fs::exists(results / "stability.json");
}

/// Draws the figures of a results folder and writes its pages, whatever it is of.
/// @throws InputError naming the file that is missing or malformed, or the folder where it holds no results
/// that can be shown; std::runtime_error where gnuplot fails.
void show(const fs::path& results);

// Pages of results folders whose figures are drawn. Each needs nothing beside itself, and appears whole or
// not at all. All throw InputError naming the file that is missing or malformed, and std::runtime_error where
// a page cannot be written.

/// report.html of what is neither a comparison nor one motion; of a course index.html: all lessons with aims,
/// time and those that come first, each with a link to its folder. False where there is no such thing.
bool write_study_page(const fs::path& results);

/// Writes the solver that pages of a course share; those that are written into its folders from then on have
/// none of their own. Nothing where this build has none.
void share_solver(const fs::path& course);

/// report.html of a comparison.
void write_report(const fs::path& results, const Comparison& comparison);

/// lesson.html and slides.html from lesson.json and the comparison beside it: the lesson's text with its
/// numbers, tables, figures, players and predictions filled in. @throws std::logic_error too, naming a place
/// of the text that has no value.
void write_lesson(const fs::path& results, const Comparison& comparison);

/// Where a problem sheet and its key are.
struct SheetPages {
  fs::path sheet, key;
};

/// LESSON-sheet-SEED.html and LESSON-key-SEED.html beside their answers, the file LESSON-key-SEED.json.
SheetPages write_sheet(const fs::path& answers);

/// Prints a page by the program `chromium`, the paper as the page's style says.
/// @throws InputError where there is no such program, std::runtime_error where it fails.
void print_pdf(const fs::path& page, const fs::path& pdf);

}  // namespace rockstack::plots
