#include "analytic/solve.hpp"

#include <algorithm>
#include <cmath>

namespace rockstack {

namespace {

template <int N>
History solve_stack_of(const Scene& scene, const SolveOptions& options) {
  return options.integrator == Integrator::rk4 ? Solver<double, N, Rk4Steps>(scene, options).run()
                                               : Solver<double, N, TaylorSteps>(scene, options).run();
}

}  // namespace

History solve(const Scene& scene, const SolveOptions& options) {
  validate(scene);
  switch (scene.blocks.size()) {
    case 1:
      return solve_stack_of<1>(scene, options);
    case 2:
      return solve_stack_of<2>(scene, options);
    default:
      return solve_stack_of<Eigen::Dynamic>(scene, options);
  }
}

std::vector<double> regular_times(double interval, double duration) {
  const auto count = static_cast<std::size_t>(std::floor(duration / interval + 1e-6));
  std::vector<double> times(count + 1);
  for (std::size_t i = 0; i <= count; ++i) times[i] = std::min(static_cast<double>(i) * interval, duration);
  return times;
}

}  // namespace rockstack
