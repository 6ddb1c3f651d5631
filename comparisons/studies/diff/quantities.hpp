#pragma once

#include <optional>
#include <string>
#include <vector>

#include "comparisons/measures/results/run_metrics.hpp"

namespace rockstack {

/// A number of a run, or of a draw, that may get better or worse.
struct TellingQuantity {
  enum class Better {
    less,
    more,
    nearer_zero,
    neither,  ///< a matter of the scene
  };

  std::string name;  ///< of its column where it has one
  std::string definition;
  Better better = Better::less;
  std::optional<double> (*value)(const TellingQuantity&, const RunMetrics&);
};

/// "failed" first, 1 where a run is not done, else 0; "other_verdict", 1 where engine or exact solution
/// topples alone, else 0; then the columns that tell how near an engine is to the exact motion, one of those
/// that say the same. The numbers of a run that is not done are left empty.
const std::vector<TellingQuantity>& telling_quantities();

/// Drawn columns that are no quantities of their own: they follow from others, or are of the exact motion
/// alone.
const std::vector<std::string>& untold_columns();

}  // namespace rockstack
