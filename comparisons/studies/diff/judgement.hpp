#pragma once

#include "comparisons/studies/diff/changes.hpp"

namespace rockstack {

/// What tells the set of a row from others: engine, solver and settings of both results.
std::vector<std::string> set_of(const RowChange& row);

/// Judges all numbers by their tests: the foremost each by itself, and so the others, but those of a row that
/// by themselves could show nothing all together (joint_chances()). What they are is told by sizes and ties
/// of both samples together alone, so that the level holds. Precondition: the rows are those of the pairs.
void judge_all(const std::vector<RowPair>& pairs, ResultsChange& result);

/// Names what no test has judged: numbers in doubt, more failures than before, and rows of which nothing can
/// be said; and how many replicates would do.
void find_undecided(const ChangeOptions& options, ResultsChange& result);

}  // namespace rockstack
