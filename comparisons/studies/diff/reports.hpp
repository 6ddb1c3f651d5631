#pragma once

#include "comparisons/studies/diff/upper_bounds.hpp"

namespace rockstack {

/// What two results come to for a service that builds and tests: changes, and bounds on new rows.
struct JudgedChange {
  const ResultsChange& change;
  const std::vector<BoundedRow>& bounds;

  /// In one sentence: rows that are above a bound, and the headline of the changes.
  std::string headline() const;
  /// 1 where something is worse or above a bound, 3 where that is undecided, else 0.
  int exit_code() const;
};

/// JUnit XML: a suite a row, a test case each of its numbers that counts, that is, could show a change, has
/// changed or is bounded; a failure says by how much. Where it is undecided one more case has an error.
std::string junit_xml(const JudgedChange& judged);

/// Markdown for a change that is to be merged: the headline, rows with the numbers that headlines tell, and
/// what else has turned.
std::string summary_markdown(const JudgedChange& judged);

}  // namespace rockstack
