#pragma once

#include "comparisons/runs/compare.hpp"
#include "comparisons/studies/diff/changes.hpp"
#include "comparisons/suites/suite.hpp"

// A gate: one engine on a few small scenes, held against what it or another did before.

namespace rockstack {

/// The shipped suite `gate` for one engine in the place of its own, and, where it is given, other replicates.
Suite gate_suite(const EngineSeries& engine, const std::optional<std::uint64_t>& seed);

/// Time that its runs may take on so many cores, s.
double expected_time(const Suite& suite, std::size_t cores);

/// Makes all runs of a gate anew, in a folder that goes again, and reads what they left.
/// @throws InputError, std::runtime_error as compare().
RecordedResults run_gate(const Suite& suite, const std::function<void(const Progress&)>& progress);

/// A row, and the least change that it would have shown.
struct RowSensitivity {
  const RowChange* row;
  double error = 0;  ///< median of the old ones
  /// By how many times all its errors together must grow to be reported; empty: no growth is.
  std::optional<double> factor;
};

/// The sensitivities of all rows of an engine with replicates, each by itself: its old errors against as many
/// that are so many times as large, by the test and the level of the change. They point into `change`.
std::vector<RowSensitivity> sensitivities(const ResultsChange& change, const RecordedResults& before);

/// What the scenes of a suite do not have, so that a gate cannot see it: "stacks of more than 3 blocks".
std::vector<std::string> not_seen(const Suite& suite);

}  // namespace rockstack
