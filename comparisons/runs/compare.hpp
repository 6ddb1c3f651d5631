#pragma once

#include "comparisons/measures/verdict/verdict.hpp"
#include "comparisons/runs/execution/executor.hpp"
#include "comparisons/runs/job.hpp"

namespace rockstack {

// A comparison is made in tasks, which threads or machines share: the nominal run of a job, or all its
// replicates.

/// How far a comparison has come.
struct Progress {
  std::size_t done = 0, total = 0;  ///< runs
  std::string last;                 ///< the run that was finished last; empty at the beginning
  std::string running;              ///< the run that was begun last and is not finished; empty where none is
  /// Time to go by the expected work that is left, s; unknown before a run is finished.
  std::optional<double> remaining;
};

/// What results name as their command, and what is told while they are made.
struct CompareOptions {
  std::string command = {};                                                ///< written into the results
  std::function<void(const Progress&)> progress = [](const Progress&) {};  ///< from one thread at a time
  /// Called with an engine's row as soon as it is done, without its rank.
  std::function<void(const RunMetrics&)> row = [](const RunMetrics&) {};
  /// Called with rows once all of their kind are done: those of a scene's exact solutions, and of engines
  /// those of a scene and step together, ranked.
  std::function<void(const std::vector<RunMetrics>&)> rows = [](const std::vector<RunMetrics>&) {};
};

/// Makes the tasks that FOLDER/runs does not have, scene by scene from coarse steps to fine ones, a run
/// before its replicates, and tells how far it has come, and of each job whose tasks are all there its row,
/// from one thread at a time. Replicates of a run that has failed are not made. Returns a row a job, and how
/// many nominal runs were there already. Precondition: executor.leads().
std::pair<std::vector<RunWithReplicates>, std::size_t> carry_out(
    const std::vector<Job>& jobs, const std::filesystem::path& folder, Executor& executor,
    const CompareOptions& options, const std::function<void(std::size_t job, const RunWithReplicates&)>& row);

struct CompareResult {
  std::vector<RunMetrics> rows;
  std::size_t reused = 0;  ///< rows of runs that were there already
  ComparisonVerdict verdict;
};

/// @throws InputError where suites cannot be one comparison: two scenes share a name, tolerances differ, or a
/// scene lasts too long to be sampled.
void require_comparable(const std::vector<Suite>& suites);

/// What a rank does that does not lead a comparison: makes runs and replicates as it is asked. `suites`: read
/// when the first is, so that of bad input the leader alone speaks.
void serve_comparison(Executor& executor, const std::function<std::vector<Suite>()>& suites,
                      const std::string& command);

/// Runs suites and writes DIR/runs/, DIR/ground/ (where it moves), DIR/comparison.csv, DIR/comparison.json;
/// where time steps were swept, DIR/fits.csv, where perturbed scenes are asked for, DIR/distributions.csv,
/// where replicates are, DIR/spread.csv, and where a solver has several parameter sets, DIR/ranking.csv. Runs
/// that are timed share the machine with as many others as the executor has at a time; replicates are not
/// timed and use all of it. A run that fails costs its own row. A run that is in the folder, done and of the
/// same identity, is not made again, nor are its replicates. The folder must be there (files.hpp).
/// @throws InputError as require_comparable(); std::runtime_error where a file cannot be written.
/// Precondition: executor.leads().
CompareResult compare(const std::vector<Suite>& suites, const std::filesystem::path& folder,
                      Executor& executor, const CompareOptions& options);

}  // namespace rockstack
