#pragma once

#include <functional>
#include <variant>

#include "analytic/scene/input/json.hpp"
#include "comparisons/measures/metrics/run_outcome.hpp"

namespace rockstack {

/// A column of what came out of motions.
struct OutcomeColumn {
  using Measure = std::function<std::optional<double>(const RunOutcome&)>;
  using Count = std::function<std::size_t(const RunOutcome&)>;
  using Mode = MotionMode RunOutcome::*;
  using Value = std::variant<std::monostate, Measure, Count, Mode>;

  std::string name, meaning;
  Value value;  ///< of a motion that did not fail; none of the columns that say whether and why it did
  bool sampled = false;  ///< whether an engine's samples tell it as well
};

/// All of them for a stack of so many blocks, in the order of a sweep's runs.csv: those of each block have
/// its number behind their name.
std::vector<OutcomeColumn> outcome_columns(std::size_t blocks);

/// A motion's fields by the names of columns; of an engine's those that samples tell. What it does not have,
/// or is infinite, is null.
Json outcome_json(const RunOutcome& outcome, bool sampled = false);

}  // namespace rockstack
