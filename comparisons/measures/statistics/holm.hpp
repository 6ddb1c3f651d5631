#pragma once

#include <cstddef>
#include <vector>

namespace rockstack {

/// What one of many tests says.
struct TestChance {
  double p_value = 1;
  double least_p_value = 1;  ///< the least that its samples could have had, whatever the test says
};

/// Many tests at once.
struct AdjustedTests {
  std::vector<double> p_values;  ///< of each: the level from which on it is shown; 1 where it cannot be
  std::size_t counted = 0;       ///< tests that could show anything at the level
};

/// p-values for many tests, such that where nothing has changed the chance that any is at or below `level` is
/// at most `level`, however the tests hang together (S. Holm, "A simple sequentially rejective multiple test
/// procedure", Scand. J. Statist. 6, 1979). Tests whose samples could never reach their share of the level do
/// not count (R. E. Tarone, "A modified Bonferroni method for discrete data", Biometrics 46, 1990).
AdjustedTests adjust(const std::vector<TestChance>& tests, double level);

}  // namespace rockstack
