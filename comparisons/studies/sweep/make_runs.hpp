#pragma once

#include "comparisons/measures/results/outcome_columns.hpp"
#include "comparisons/studies/sweep/ensemble.hpp"

namespace rockstack {

/// What becomes of a run of an ensemble; it is there while it is taken.
struct RunResult {
  std::size_t run = 0;
  const std::vector<Value>& values;  ///< of each variation
  const RunOutcome* outcome;         ///< null where its scene is out of range or cannot be solved
  std::string reason;                ///< then why
};

/// Makes the runs `first` up to and without `last`, several side by side; `take` gets what becomes of each,
/// not in order. May be called from several threads at once. What `take` throws goes through. `cancelled` as
/// of SolveOptions: a run that it ends has no outcome.
void make_runs(const Ensemble& ensemble, std::size_t first, std::size_t last, MotionLibrary& library,
               const std::function<void(const RunResult&)>& take,
               const std::function<bool()>* cancelled = nullptr);

}  // namespace rockstack
