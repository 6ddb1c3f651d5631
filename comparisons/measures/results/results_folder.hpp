#pragma once

#include <filesystem>
#include <vector>

#include "comparisons/measures/results/files.hpp"

namespace rockstack {

/// What a folder holds, by the command that fills it.
enum class Results {
  motion,
  comparison,
  lesson,
  advice,
  stability,
  impact_laws,
  sweep,
  record,
  diff,
  canon,
  course,
  sheets
};

/// A folder that this process alone fills, with results of one kind. Runs that are there stay for the command
/// to judge; tables, figures and pages that were made of them go before anything is made again, so that
/// nothing of before stands beside what is new. A folder that was made for this and that nothing has come
/// into goes again.
class ResultsFolder {
 public:
  /// @throws InputError where the folder cannot be written, is being written by another process, or holds
  /// results of another kind or files of others.
  ResultsFolder(const std::filesystem::path& folder, Results kind);
  ~ResultsFolder();
  ResultsFolder(const ResultsFolder&) = delete;
  ResultsFolder& operator=(const ResultsFolder&) = delete;

 private:
  std::filesystem::path folder_;
  std::vector<std::filesystem::path> made_;  ///< inmost first
  FolderLock lock_;
};

}  // namespace rockstack
