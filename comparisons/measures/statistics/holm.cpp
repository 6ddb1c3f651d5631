#include "comparisons/measures/statistics/holm.hpp"

#include <algorithm>

namespace rockstack {
namespace {

/// Tests that can reach one of `shares` equal shares of the level.
std::vector<std::size_t> able(const std::vector<TestChance>& tests, double level, std::size_t shares) {
  std::vector<std::size_t> indices;
  for (std::size_t i = 0; i < tests.size(); ++i)
    if (tests[i].least_p_value <= level / static_cast<double>(shares)) indices.push_back(i);
  return indices;
}

}  // namespace

AdjustedTests adjust(const std::vector<TestChance>& tests, double level) {
  std::size_t shares = 1;
  std::vector<std::size_t> counted = able(tests, level, shares);
  while (counted.size() > shares) counted = able(tests, level, ++shares);
  std::sort(counted.begin(), counted.end(),
            [&](std::size_t a, std::size_t b) { return tests[a].p_value < tests[b].p_value; });
  AdjustedTests adjusted{std::vector<double>(tests.size(), 1.0), counted.size()};
  double before = 0;
  for (std::size_t i = 0; i < counted.size(); ++i) {
    const double own = tests[counted[i]].p_value * static_cast<double>(counted.size() - i);
    before = std::min(1.0, std::max(before, own));
    adjusted.p_values[counted[i]] = before;
  }
  return adjusted;
}

}  // namespace rockstack
