#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "comparisons/studies/sweep/ensemble.hpp"
#include "comparisons/studies/sweep/run_outcome.hpp"

namespace rockstack {

/// What becomes of a run of an ensemble; it is there while it is taken.
struct RunResult {
  std::size_t run = 0;
  const std::vector<Value>& values;  ///< of each variation
  const RunOutcome* outcome;         ///< null where its scene is out of range or cannot be solved
  std::string reason;                ///< then why
};

/// Makes the runs `first` up to and without `last`, several side by side; `take` gets what becomes of each,
/// not in order. May be called from several threads at once. What `take` throws goes through. `unwanted` as
/// of SolveOptions: a run that it ends has no outcome.
void make_runs(const Ensemble& ensemble, std::size_t first, std::size_t last, MotionLibrary& library,
               const std::function<void(const RunResult&)>& take,
               const std::function<bool()>* unwanted = nullptr);

/// A column of runs.csv and what it means.
using ColumnMeaning = std::pair<std::string, std::string>;

/// All columns in order: the run's number, a column a variation, then what came out.
std::vector<ColumnMeaning> run_columns(const Ensemble& ensemble);

/// The first line of runs.csv.
std::string header_line(const Ensemble& ensemble);

/// Runs `first` up to and without `last`, one line each. A run whose scene is out of range or that the solver
/// cannot finish says so in its line. May be called from several threads at once.
std::string run_lines(const Ensemble& ensemble, std::size_t first, std::size_t last, MotionLibrary& library);

}  // namespace rockstack
