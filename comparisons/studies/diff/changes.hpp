#pragma once

#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "comparisons/studies/diff/quantities.hpp"

namespace rockstack {

struct ChangeOptions {
  double level = 0.01;  ///< chance that anything is reported where nothing has changed, between 0 and 1
  ChangeFactors factors = {};
  std::vector<std::string> across = {};  ///< of row_names(): as pair_rows()
};

/// Whether two runs left the same bytes in the files that both kept.
enum class SameBits { same, different, unknown };

/// "same", "different", or "" where nothing was kept.
std::string name(SameBits bits);

/// One row in both results.
struct RowChange {
  RunMetrics old_row, new_row;
  SameBits bits = SameBits::unknown;
  bool drawn = false;  ///< whether both have draws
  std::vector<QuantityChange> quantities;

  Turn worst() const;
};

/// Two results held against each other.
struct ResultsChange {
  std::vector<RowChange> rows;
  std::vector<std::string> only_old, only_new, other_questions;  ///< as RowPairs
  std::vector<std::string> other_environment;                    ///< "compiler: GNU 12.2.0, GNU 13.1.0"
  std::size_t tests = 0;    ///< numbers that have draws on both sides, and vary
  std::size_t counted = 0;  ///< of them, those that could show a change at the level
  double level = 0;

  bool worse() const;

  /// Draws on each side with which all tests could show a change.
  std::size_t draws_needed() const;
};

/// Holds new results against old ones. A number of draws is reported as changed where its test, corrected for
/// how many there are, says so at the level; a run by itself where the factors say so. Times are reported on
/// one processor alone. @throws InputError as pair_rows().
ResultsChange hold_against(const RecordedResults& old_results, const RecordedResults& new_results,
                           const ChangeOptions& options);

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
