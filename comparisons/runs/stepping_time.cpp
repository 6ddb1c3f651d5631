#include "comparisons/runs/stepping_time.hpp"

#include <algorithm>

namespace rockstack {

SteppingTime stepping_time(std::vector<double> seconds) {
  std::sort(seconds.begin(), seconds.end());
  const double median = 0.5 * (seconds[(seconds.size() - 1) / 2] + seconds[seconds.size() / 2]);
  return {seconds.front(), median, seconds.back() - seconds.front(), static_cast<int>(seconds.size())};
}

}  // namespace rockstack
