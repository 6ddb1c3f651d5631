#include "comparisons/runs/predictability.hpp"

#include <algorithm>
#include <exception>

#include "analytic/solve.hpp"
#include "comparisons/measures/metrics/difference.hpp"

namespace rockstack {

double predictable_time(const Scene& scene, const Draws& draws, double tolerance) {
  const SolveOptions options{.sample_times = regular_times(sample_interval, scene.duration)};
  const History own = solve(scene, options);
  double time = scene.duration;
  for (int i = 1; i < draws.runs; ++i) {
    const Difference apart = difference(own, solve(drawn_scene(scene, draws, i), options));
    if (largest(apart) > tolerance) time = std::min(time, agreement_time(apart, tolerance));
  }
  return time;
}

double Horizon::time() const {
  std::call_once(found_, [this] {
    Draws draws = suite_.draws;
    draws.runs = horizon_scenes;
    try {
      time_ = predictable_time(scene_.scene, draws, suite_.tolerance);
    } catch (const std::exception&) {
      time_ = scene_.scene.duration;
    }
  });
  return time_;
}

}  // namespace rockstack
