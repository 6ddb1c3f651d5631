#include "analytic/solve.hpp"

#include <algorithm>
#include <cmath>

namespace rockstack {

History solve(const Scene& scene, const SolveOptions& options) {
  validate(scene);
  return Solver<double>(scene, options).run();
}

std::vector<double> regular_times(double interval, double duration) {
  const auto count = static_cast<std::size_t>(std::floor(duration / interval + 1e-6));
  std::vector<double> times(count + 1);
  for (std::size_t i = 0; i <= count; ++i) times[i] = std::min(static_cast<double>(i) * interval, duration);
  return times;
}

}  // namespace rockstack
