#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>

#include "comparisons/runs/execution/executor.hpp"
#include "comparisons/studies/sweep/ensemble.hpp"

namespace rockstack {

struct SweepOptions {
  std::filesystem::path folder;  ///< for results; must be there
  std::string command;           ///< the whole command line
  std::function<void(std::size_t done, std::size_t begun_with, std::size_t runs)> progress;  ///< of runs
  std::function<bool()> stopped;  ///< true: end after the blocks in progress
};

struct SweepResult {
  std::size_t runs = 0;
  std::size_t done = 0;      ///< before or now
  std::size_t computed = 0;  ///< now
  std::size_t failed = 0;    ///< of all, once finished
  double seconds = 0;        ///< wall time of those
  bool finished() const { return done == runs; }
};

/// Consecutive runs are computed and kept in blocks of this size.
std::size_t block_size(std::size_t runs);

/// The lines of a block of runs.
std::string block_lines(const Ensemble& ensemble, std::size_t block, MotionLibrary& library);

/// Makes the runs of an ensemble that DIR/runs.journal does not have yet. Once all are there it writes
/// runs.csv, sweep.json and summaries, whose bytes depend neither on the executor nor on interruptions, and
/// timing.json. Precondition: executor.leads().
/// @throws InputError where the folder holds another ensemble.
SweepResult sweep(const Ensemble& ensemble, MotionLibrary& library, Executor& executor,
                  const SweepOptions& options);

}  // namespace rockstack
