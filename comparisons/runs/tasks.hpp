#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "comparisons/runs/draws.hpp"
#include "comparisons/runs/execution/executor.hpp"

namespace rockstack {

// A comparison is made in tasks, which threads or machines share: the nominal run of a job, or all its draws.

/// How far a comparison has come.
struct Progress {
  std::size_t done = 0, total = 0;  ///< runs
  std::string last;                 ///< the run that was finished last; empty at the beginning
  std::string running;              ///< the run that was begun last and is not finished; empty where none is
  /// Time to go by the expected work that is left, s; unknown before a run is finished.
  std::optional<double> remaining;
};

/// The text of a task, to be delivered. Tasks are numbered: the nominal runs of all jobs, then their draws.
std::string compute_task(const std::vector<Job>& jobs, std::size_t number, const std::string& command,
                         std::size_t at_a_time);

struct DoneTasks {
  std::vector<DrawnRow> rows;  ///< one a job
  std::size_t reused = 0;      ///< nominal runs that were there already
};

/// What is told of tasks as they are made, from one thread at a time.
struct Listener {
  std::function<void(const Progress&)> progress;
  std::function<void(std::size_t job, const DrawnRow&)> row;  ///< of a job whose tasks are all there
};

/// Makes the tasks that FOLDER/runs does not have, scene by scene from coarse steps to fine ones, a run
/// before its draws, and tells how far it has come. Draws of a run that has failed are not made.
/// Precondition: executor.leads().
DoneTasks carry_out(const std::vector<Job>& jobs, const std::filesystem::path& folder, Executor& executor,
                    const std::string& command, const Listener& listener);

}  // namespace rockstack
