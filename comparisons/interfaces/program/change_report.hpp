#pragma once

#include "comparisons/interfaces/program/commands.hpp"
#include "comparisons/studies/diff/reports.hpp"

namespace rockstack {

/// What `diff` and `gate` ask of a change alike, and write of it.
struct ChangeArguments {
  ChangeOptions options;
  std::vector<std::string> fail_above;                               ///< as read_upper_bound() takes them
  std::size_t most_lines = std::numeric_limits<std::size_t>::max();  ///< of numbers that are printed
  std::filesystem::path junit, markdown, save;                       ///< files; empty: none is written
};

void add_change_options(CLI::App& command, ChangeArguments& arguments);

/// Reads the bounds, and checks the level. @throws InputError
std::vector<UpperBound> read_upper_bounds(const ChangeArguments& arguments);

/// Writes new results as one file, where that is asked for.
void save_results(const RecordedResults& results, const ChangeArguments& arguments);

/// Holds rows to bounds, writes JUnit XML and Markdown, and prints the change with its headline behind
/// `more`, or all of it as JSON, to which `json` is added. Returns the exit code.
int report_change(const ResultsChange& change, const RecordedResults& now, const ChangeArguments& arguments,
                  const Common& common, Json json, const std::function<void()>& more);

}  // namespace rockstack
