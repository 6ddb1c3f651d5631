#pragma once

#include "comparisons/studies/diff/changes.hpp"

namespace rockstack {

/// A bound on a number of every row, whatever it was before.
struct UpperBound {
  const ReportedQuantity* quantity;
  double value = 0;  ///< SI, or a share
};

/// Reads "angles=10mrad": a quantity's words, with - for blanks, or its column, and a value with its unit; of
/// those that are better the less they are. @throws InputError with what is allowed.
UpperBound read_upper_bound(const std::string& text);

/// A row and a bound that it was held to.
struct BoundedRow {
  const RecordedRun* run;
  const UpperBound* bound;
  std::optional<double> median;  ///< over replicates; empty where the run is not done

  /// Whether it is above, or has no number because it is not done.
  bool above() const { return !median || *median > bound->value; }
  /// "angles are 49 mrad, above 10 mrad".
  std::string text() const;
};

/// Holds every row of an engine to every bound whose quantity it has; the result points into both.
/// @throws InputError for a quantity that no row has.
std::vector<BoundedRow> bounded_rows(const std::vector<UpperBound>& bounds, const RecordedResults& results);

}  // namespace rockstack
