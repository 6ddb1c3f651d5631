#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "comparisons/measures/results/run_metrics.hpp"
#include "comparisons/measures/verdict/verdict.hpp"
#include "comparisons/runs/tasks.hpp"
#include "comparisons/suites/suite.hpp"

namespace rockstack {

/// How runs are made, which changes no result but times.
struct CompareOptions {
  std::string command = {};  ///< written into the results
  std::size_t jobs =
      1;  ///< runs at a time, ≥ 1; with more than one, times are those of runs that share the machine
  std::function<void(const Progress&)> progress = [](const Progress&) {};  ///< from one thread at a time
  /// Likewise of rows as soon as they are done: those of a scene's exact solutions, and of engines those of a
  /// scene and step together, ranked.
  std::function<void(const std::vector<RunMetrics>&)> rows = [](const std::vector<RunMetrics>&) {};
};

struct CompareResult {
  std::vector<RunMetrics> rows;
  std::size_t reused = 0;  ///< rows of runs that were there already
  ComparisonVerdict verdict;
};

/// @throws InputError where suites cannot be one comparison: two scenes share a name, tolerances differ, or a
/// scene lasts too long to be sampled.
void require_comparable(const std::vector<Suite>& suites);

/// What a rank does that does not lead a comparison: makes runs and draws as it is asked. `suites`: read when
/// the first is, so that of bad input the leader alone speaks.
void serve_comparison(Executor& executor, const std::function<std::vector<Suite>()>& suites,
                      const std::string& command);

/// Runs suites and writes DIR/runs/, DIR/ground/ (where it moves), DIR/comparison.csv, DIR/comparison.json;
/// where time steps were swept, DIR/fits.csv, where perturbed scenes are asked for,
/// DIR/distributions.csv, where draws are, DIR/spread.csv, and where a
/// solver has several parameter sets, DIR/ranking.csv. Runs that are timed share the machine with as
/// many others as the executor has at a time; draws are not timed and use all of it. A run that fails costs
/// its own row. A run that is in the folder, done and of the same identity, is not made again, nor are its
/// draws. The folder must be there (files.hpp).
/// @throws InputError as require_comparable(); std::runtime_error where a file cannot be written.
CompareResult compare(const std::vector<Suite>& suites, const std::filesystem::path& folder,
                      const CompareOptions& options);

/// The same by an executor of any kind, whatever options.jobs. Precondition: executor.leads().
CompareResult compare(const std::vector<Suite>& suites, const std::filesystem::path& folder,
                      Executor& executor, const CompareOptions& options);

}  // namespace rockstack
