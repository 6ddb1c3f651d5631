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

}  // namespace rockstack
