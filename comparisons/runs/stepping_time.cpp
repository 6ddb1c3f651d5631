#include "comparisons/runs/stepping_time.hpp"

#include <algorithm>

#include "comparisons/measures/statistics/samples.hpp"

namespace rockstack {

SteppingTime stepping_time(const std::vector<double>& seconds) {
  const auto [least, most] = std::minmax_element(seconds.begin(), seconds.end());
  return {*least, median(seconds), *most - *least, static_cast<int>(seconds.size())};
}

}  // namespace rockstack
