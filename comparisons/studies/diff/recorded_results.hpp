#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "comparisons/measures/results/run_metrics.hpp"

namespace rockstack {

/// A run as a comparison has left it.
struct RecordedRun {
  RunMetrics row;                                ///< the one run, at the step that is named
  std::vector<RunMetrics> draws;                 ///< that one and all like it; empty where it stands alone
  std::map<std::string, std::string> checksums;  ///< of its files, by their names
};

/// What a comparison has left in a folder.
struct RecordedResults {
  using Facts = std::map<std::string, std::string>;

  std::filesystem::path folder;
  Facts environment;                    ///< versions, flags, processor
  std::map<std::string, Facts> scenes;  ///< by name: what was asked, how draws were made; values as JSON
  std::vector<RecordedRun> runs;
};

/// Reads comparison.json, and of each run summary.json and, where it has draws, draws.json; nothing else has
/// to be there. @throws InputError naming the file and what is wrong in it.
RecordedResults read_recorded_results(const std::filesystem::path& folder);

/// One row of the old results with the one of the new results that answers the same question.
struct RowPair {
  const RecordedRun* old_run;
  const RecordedRun* new_run;
};

/// All rows of two comparisons.
struct RowPairs {
  std::vector<RowPair> pairs;                   ///< in the order of the old results
  std::vector<std::string> only_old, only_new;  ///< names of runs that one alone has
  std::vector<std::string> other_questions;     ///< "scene drum-column: gravity": not held together
};

/// What tells rows of one comparison apart: scene, engine, solver, settings and dt.
const std::vector<std::string>& row_names();

/// Pairs rows that agree in all row_names(), then of the others those that agree in all but `across`. Scenes
/// of one name that ask something else, or make draws another way, are left out unless `across` has "scene".
/// @throws InputError where several rows of one folder agree so, or no row has a partner.
/// The pairs point into both results.
RowPairs pair_rows(const RecordedResults& old_results, const RecordedResults& new_results,
                   const std::vector<std::string>& across);

}  // namespace rockstack
