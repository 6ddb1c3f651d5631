#include "comparisons/runs/job.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "comparisons/measures/results/files.hpp"

namespace rockstack {

bool is_baseline(const Job& job) {
  return job.variant != nullptr && job.variant->choice == Variant::Choice::rk4;
}

double horizon_of(const Job& job) {
  return job.horizon ? job.horizon->time() : job.scene.scene.duration;
}

Draws draws_of(const Job& job) {
  Draws draws = job.suite.draws;
  if (job.series == nullptr || draws.finest == 0) return draws;
  const std::vector<double>& steps = job.series->steps;
  const bool finest = steps.size() > 1 && job.dt == *std::min_element(steps.begin(), steps.end());
  if (finest) draws.runs = draws.finest;
  return draws;
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
    row.solver = "taylor";
    row.run = row.scene + "." + row.engine;
  }
  return row;
}

}  // namespace rockstack
