#include "analytic/solve.hpp"

#include "analytic/solver/solver.hpp"
#include "analytic/solver/to_double.hpp"
#include "analytic/unilateral/solve_contacts.hpp"

namespace rockstack {
namespace {

constexpr double most_steps = 1e8;

template <class Real, int N, template <class, int> class Steps>
BasicHistory<Real> run(const Scene& scene, const SolveOptions& options, Branching* branching) {
  Solver<Real, N, Steps> solver(scene, options, branching);
  try {
    return solver.run();
  } catch (const std::runtime_error& failure) {
    throw Unfinished(failure.what(), to_double(solver.recorder().so_far()));
  }
}

template <class Real, int N>
BasicHistory<Real> solve_stack_of(const Scene& scene, const SolveOptions& options, Branching* branching) {
  return options.integrator == Integrator::rk4 ? run<Real, N, Rk4Steps>(scene, options, branching)
                                               : run<Real, N, TaylorSteps>(scene, options, branching);
}

History solve_in_double(const Scene& scene, const SolveOptions& options, Branching* branching) {
  const std::size_t blocks = scene.blocks.size();
  if (blocks == 1) return solve_stack_of<double, 1>(scene, options, branching);
  if (blocks == 2) return solve_stack_of<double, 2>(scene, options, branching);
  if (blocks == 3) return solve_stack_of<double, 3>(scene, options, branching);
  return solve_stack_of<double, Eigen::Dynamic>(scene, options, branching);
}

template <class Real>
History contacts_in(const Scene& scene, const SolveOptions& options, Branching* branching) {
  try {
    return to_double(solve_contacts<Real>(scene, options, branching));
  } catch (const UnfinishedContacts<Real>& unfinished) {
    throw Unfinished(unfinished.what(), to_double(unfinished.history));
  }
}

}  // namespace

History solve(const Scene& scene, const SolveOptions& options, Branching* branching) {
  validate(scene);
  if (options.integrator == Integrator::rk4 && scene.duration / options.step > most_steps)
    throw std::invalid_argument("step = " + number_text(options.step) + ": must be at least " +
                                number_text(scene.duration / most_steps) + " s, or there are too many");
  if (options.integrator != Integrator::taylor && !scene.restraints.empty())
    throw std::invalid_argument("integrator = rk4: must be taylor beside restraint");
  if (leaves_pivots(scene.law)) {
    validate(options);
    if (options.integrator != Integrator::taylor)
      throw std::invalid_argument("integrator = rk4: must be taylor under law " +
                                  std::string(name(scene.law)));
    return double_does(scene) ? contacts_in<double>(scene, options, branching)
                              : contacts_in<long double>(scene, options, branching);
  }
  try {
    return solve_in_double(scene, options, branching);
  } catch (const IllConditioned&) {
    return to_double(solve_stack_of<long double, Eigen::Dynamic>(scene, options, branching));
  }
}

std::vector<double> regular_times(double interval, double duration) {
  constexpr double most = 1e7;
  if (!(interval > 0 && duration / interval <= most))
    throw std::invalid_argument("interval of samples = " + number_text(interval) +
                                ": must be > 0 and at least " + number_text(duration / most) + " s");
  const auto count = static_cast<std::size_t>(std::floor(duration / interval + 1e-6));
  std::vector<double> times(count + 1);
  for (std::size_t i = 0; i <= count; ++i) times[i] = std::min(static_cast<double>(i) * interval, duration);
  return times;
}

}  // namespace rockstack
