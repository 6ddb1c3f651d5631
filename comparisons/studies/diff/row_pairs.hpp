#pragma once

#include <string>
#include <vector>

#include "comparisons/studies/diff/recorded_results.hpp"

namespace rockstack {

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
