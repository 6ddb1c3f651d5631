#pragma once

#include <vector>

namespace rockstack {

/// Repeated wall times of one job, s.
struct SteppingTime {
  double minimum = 0;
  double median = 0;
  double spread = 0;  ///< largest less smallest
  int repeats = 0;    ///< after a warm-up that is not counted
};

/// Precondition: at least one.
SteppingTime stepping_time(const std::vector<double>& seconds);

}  // namespace rockstack
