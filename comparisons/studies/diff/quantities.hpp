#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "comparisons/measures/results/run_metrics.hpp"
#include "comparisons/measures/statistics/samples.hpp"
#include "comparisons/studies/diff/recorded_results.hpp"

namespace rockstack {

/// A number of a run, or of a draw, that may get better or worse.
struct ReportedQuantity {
  enum class Better {
    less,
    more,
    nearer_zero,
    neither,  ///< a matter of the scene
  };

  std::string name;  ///< of its column where it has one
  std::string definition;
  Better better = Better::less;
  std::function<std::optional<double>(const RunMetrics&)> value;
};

/// "failed" first, 1 where a run is not done, else 0; "other_verdict", 1 where engine or exact solution
/// topples alone, else 0; then the columns that tell how near an engine is to the exact motion, one of those
/// that say the same. The numbers of a run that is not done are left empty.
const std::vector<ReportedQuantity>& reported_quantities();

/// What has become of a number.
enum class Turn { none, better, other, worse };

/// "", "better", "changed", "worse".
std::string name(Turn turn);

/// A number over draws: the values of ranks ⌈n/4⌉, ⌈n/2⌉ and ⌈3n/4⌉; of a time over repeats its least, median
/// and greatest.
struct ValueSpread {
  double lower = 0, median = 0, upper = 0;
  std::size_t values = 0;
};

/// One number of one row in both results.
struct QuantityChange {
  std::string quantity;
  ReportedQuantity::Better better;
  ValueSpread old_values, new_values;
  std::optional<MannWhitney> test = {};         ///< where both have several values
  std::optional<double> adjusted_p_value = {};  ///< of it among all tests
  Turn turn = Turn::none;
};

/// From how many times on numbers are reported that no test can judge; empty: none is.
struct ChangeFactors {
  std::optional<double> single = {};  ///< of single runs
  std::optional<double> cost = {};    ///< the time of a step, where no repeat of one is within the other's
};

/// The change of a quantity, tested but not yet judged by its test; empty where either has no value of it.
/// A run that is done in the one and not in the other is better or worse whatever the factors.
std::optional<QuantityChange> change_of(const ReportedQuantity& quantity, const RowPair& pair,
                                        const ChangeFactors& factors);

/// The change of the wall time of a step, s; of the exact solver, that of the whole motion. Empty where runs
/// shared the machine.
std::optional<QuantityChange> cost_change(const RowPair& pair, const ChangeFactors& factors);

/// Judges by the adjusted p-value: at or below the level the number has turned to where its ranks have gone.
/// Changes of median and both quartiles by less than a hundredth, or 1e-12, are not reported.
void judge(double level, QuantityChange& change);

}  // namespace rockstack
