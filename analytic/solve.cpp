#include "analytic/solve.hpp"

#include <algorithm>
#include <cmath>

#include "analytic/scene/messages/number_text.hpp"
#include "analytic/solver/solver.hpp"
#include "analytic/solver/to_double.hpp"

namespace rockstack {

namespace {

template <class Real, int N>
BasicHistory<Real> solve_stack_of(const Scene& scene, const SolveOptions& options) {
  return options.integrator == Integrator::rk4 ? Solver<Real, N, Rk4Steps>(scene, options).run()
                                               : Solver<Real, N, TaylorSteps>(scene, options).run();
}

History solve_in_double(const Scene& scene, const SolveOptions& options) {
  switch (scene.blocks.size()) {
    case 1:
      return solve_stack_of<double, 1>(scene, options);
    case 2:
      return solve_stack_of<double, 2>(scene, options);
    default:
      return solve_stack_of<double, Eigen::Dynamic>(scene, options);
  }
}

}  // namespace

History solve(const Scene& scene, const SolveOptions& options) {
  validate(scene);
  try {
    return solve_in_double(scene, options);
  } catch (const IllConditioned&) {
    return to_double(solve_stack_of<long double, Eigen::Dynamic>(scene, options));
  }
}

std::vector<double> regular_times(double interval, double duration) {
  constexpr double most = 1e8;
  if (!(interval > 0 && duration / interval <= most))
    throw std::invalid_argument("interval of samples = " + number_text(interval) +
                                ": must be > 0 and at least " + number_text(duration / most) + " s");
  const auto count = static_cast<std::size_t>(std::floor(duration / interval + 1e-6));
  std::vector<double> times(count + 1);
  for (std::size_t i = 0; i <= count; ++i) times[i] = std::min(static_cast<double>(i) * interval, duration);
  return times;
}

}  // namespace rockstack
