#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "comparisons/measures/statistics/samples.hpp"
#include "comparisons/studies/diff/quantities.hpp"
#include "comparisons/studies/diff/row_pairs.hpp"

namespace rockstack {

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
  ValueSpread old_values, new_values;
  std::optional<MannWhitney> test;         ///< where both have several values
  std::optional<double> adjusted_p_value;  ///< of it among all tests
  Turn turn = Turn::none;
};

/// From how many times on numbers are told that no test can judge; empty: none is.
struct ChangeFactors {
  std::optional<double> single = {};  ///< of single runs
  std::optional<double> cost = {};    ///< the time of a step, where no repeat of one is within the other's
};

/// The change of a quantity, tested but not yet judged by its test; empty where either has no value of it.
/// A run that is done in the one and not in the other is better or worse whatever the factors.
std::optional<QuantityChange> change_of(const TellingQuantity& quantity, const RowPair& pair,
                                        const ChangeFactors& factors);

/// The change of the wall time of a step, s; of the exact solver, that of the whole motion. Empty where runs
/// shared the machine.
std::optional<QuantityChange> cost_change(const RowPair& pair, const ChangeFactors& factors);

/// Judges by the adjusted p-value: at or below the level the number has turned to where its ranks have gone.
/// Changes of median and both quartiles by less than a hundredth, or 1e-12, stay untold.
void judge(const TellingQuantity& quantity, double level, QuantityChange& change);

}  // namespace rockstack
