#include "comparisons/runs/job.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <exception>

#include "analytic/solve.hpp"
#include "comparisons/measures/metrics/difference.hpp"
#include "comparisons/measures/results/files.hpp"

namespace rockstack {
namespace {

double samples_of(const Job& job) {
  const double interval = job.series != nullptr ? job.dt : sample_interval;
  return job.scene.scene.duration / std::max(interval, job.suite.history_interval);
}

/// Of all files with a line a sample.
double columns_of(const Job& job) {
  const auto blocks = static_cast<double>(job.scene.scene.blocks.size());
  const double history = 1 + 2 * blocks, difference = 1 + blocks, energy = 7, reactions = 1 + 3 * blocks;
  if (job.series == nullptr && job.variant == nullptr) return history + reactions;
  if (!job.suite.wanted.histories) return 0;
  const bool engine = job.series != nullptr;
  return history + difference + (engine && job.suite.wanted.bodies ? energy : 0) +
         (engine && job.suite.softness ? 1 + 3 * blocks : 0);
}

}  // namespace

bool is_baseline(const Job& job) {
  return job.variant != nullptr && job.variant->choice == Variant::Choice::rk4;
}

bool is_measured(const Job& job) {
  return job.variant != nullptr && job.variant->choice == Variant::Choice::measured;
}

double horizon_of(const Job& job) {
  return job.horizon.valid() ? job.horizon.get() : job.scene.scene.duration;
}

Replicates replicates_of(const Job& job) {
  Replicates replicates = job.suite.replicates;
  if (job.series == nullptr || replicates.finest == 0) return replicates;
  const std::vector<double>& steps = job.series->steps;
  const bool finest = steps.size() > 1 && job.dt == *std::min_element(steps.begin(), steps.end());
  if (finest) replicates.runs = replicates.finest;
  return replicates;
}

RunMetrics describe(const Job& job) {
  RunMetrics row;
  row.scene = job.scene.name;
  row.law = name((job.variant != nullptr ? job.variant->apply(job.scene.scene) : job.scene.scene).law);
  if (job.series != nullptr) {
    row.dt = job.dt;
    row.engine = job.series->engine->name;
    row.solver = job.series->engine->solver;
    row.settings = job.series->settings;
    row.run =
        folder_name(fmt::format("{}.{}-{}-{}-{}", row.scene, row.engine, row.solver, row.settings, job.dt));
  } else if (is_baseline(job)) {
    row.dt = job.dt;
    row.engine = job.variant->name();
    row.solver = "runge-kutta";
    row.settings = "baseline";
    row.run = fmt::format("{}.{}-{}", row.scene, row.engine, job.dt);
  } else {
    row.engine = job.variant != nullptr ? job.variant->name() : "exact";
    row.solver = is_measured(job) ? "" : "taylor";
    row.run = row.scene + "." + row.engine;
  }
  return row;
}

double predictable_time(const Scene& scene, const Replicates& replicates, double tolerance) {
  const SolveOptions options{.sample_times = regular_times(sample_interval, scene.duration)};
  const History own = solve(scene, options);
  double time = scene.duration;
  for (int i = 1; i < replicates.runs; ++i) {
    const Difference apart = difference(own, solve(replicate_scene(scene, replicates, i), options));
    if (largest(apart) > tolerance) time = std::min(time, agreement_time(apart, tolerance));
  }
  return time;
}

std::shared_future<double> horizon_of(const Suite& suite, const NamedScene& scene) {
  return std::async(std::launch::deferred, [&suite, &scene] {
    Replicates replicates = suite.replicates;
    replicates.runs = horizon_scenes;
    try {
      return predictable_time(scene.scene, replicates, suite.tolerance);
    } catch (const std::exception&) {
      return scene.scene.duration;
    }
  });
}

std::vector<Job> jobs_of(const std::vector<Suite>& suites) {
  static const Variant measured{Variant::Choice::measured};
  std::vector<Job> jobs;
  for (const Suite& suite : suites) {
    for (const NamedScene& scene : suite.scenes) {
      const auto horizon = horizon_of(suite, scene);
      jobs.push_back({suite, scene, {}, nullptr, nullptr, horizon});
      for (const Variant& variant : suite.variants)
        jobs.push_back({suite, scene, variant.step, nullptr, &variant, horizon});
      if (scene.measured && scene.measured->is_motion(scene.scene.blocks.size()))
        jobs.push_back({suite, scene, {}, nullptr, &measured, horizon});
      for (const EngineSeries& series : suite.series) {
        for (const double dt : series.steps) jobs.push_back({suite, scene, dt, &series, nullptr, horizon});
      }
    }
  }
  return jobs;
}

double history_bytes(const std::vector<Suite>& suites) {
  constexpr double number_length = 14;  // on average: 20 of an angle, few of a time or a zero
  double bytes = 0;
  for (const Job& job : jobs_of(suites)) bytes += number_length * samples_of(job) * columns_of(job);
  return bytes;
}

}  // namespace rockstack
