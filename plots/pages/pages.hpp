#pragma once

#include <filesystem>

#include "plots/data/results.hpp"

namespace rockstack::plots {

// Pages of results folders whose figures are drawn. Each needs nothing beside itself, and appears whole or
// not at all. All throw InputError naming the file that is missing or malformed, and std::runtime_error where
// a page cannot be written.

/// results/report.html of a comparison.
void write_report(const std::filesystem::path& results, const Comparison& comparison);

/// Of one motion: its verdict, its player, its figures and everything that its summary says.
void write_report(const std::filesystem::path& results, const Motion& motion);

/// From sweep.json, runs.csv and the summaries that are there.
void write_sweep_report(const std::filesystem::path& results);

/// From stability.json, stability.csv and steps.csv.
void write_stability_report(const std::filesystem::path& results);

/// From advice.json.
void write_advice_report(const std::filesystem::path& results);

/// From record.json.
void write_record_report(const std::filesystem::path& results);

/// From impact-laws.json and the tables beside it.
void write_impact_law_report(const std::filesystem::path& results);

/// From canon.json: engines as rows, scenes as columns.
void write_canon_report(const std::filesystem::path& results);

/// results/index.html from course.json: all lessons with aims, time and those that come first, each with a
/// link to its folder.
void write_course(const std::filesystem::path& results);

/// results/lesson.html and results/slides.html from lesson.json and the comparison beside it: the lesson's
/// text with its numbers, tables, figures, players and predictions filled in. @throws std::logic_error too,
/// naming a place of the text that has no value.
void write_lesson(const std::filesystem::path& results, const Comparison& comparison);

/// Where a problem sheet and its key are.
struct SheetPages {
  std::filesystem::path sheet, key;
};

/// The problem sheet LESSON-sheet-SEED.html and LESSON-key-SEED.html beside their answers, the file
/// LESSON-key-SEED.json.
SheetPages write_sheet(const std::filesystem::path& answers);

/// Prints a page by the program `chromium`, the paper as the page's style says.
/// @throws InputError where there is no such program, std::runtime_error where it fails.
void print_pdf(const std::filesystem::path& page, const std::filesystem::path& pdf);

}  // namespace rockstack::plots
