#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "comparisons/studies/diff/changes.hpp"

namespace rockstack {

/// Everything that was held together, for programs: what diff.json holds.
nlohmann::ordered_json changes_json(const ResultsChange& result);

/// A line a row and number:
/// scene,engine,solver,dt,old_settings,new_settings,old_run,new_run,bits,quantity,turn,
/// old_lower,old_median,old_upper,old_values,new_…,superiority,p_value,adjusted_p_value.
std::string changes_csv(const ResultsChange& result);

/// A number of a row that has turned.
struct TurnedNumber {
  const RowChange* row;
  const QuantityChange* change;

  /// The new median over the old one; infinite over 0.
  double ratio() const;
};

/// All of them, worst first: worse ones, then changed ones, then better ones, each by how much. They point
/// into the result.
std::vector<TurnedNumber> turned_numbers(const ResultsChange& result);

/// Steps that cost as much as before, or more or less, over all rows of engines that tell times: the ratio of
/// medians, its median over rows, and its least and greatest; no values where there is none.
ValueSpread cost_ratio(const ResultsChange& result);

}  // namespace rockstack
