#include "comparisons/runs/job.hpp"

#include <fmt/format.h>

#include "analytic/solve.hpp"
#include "comparisons/measures/metrics/impacts.hpp"
#include "comparisons/measures/results/files.hpp"

namespace rockstack {
namespace {

/// Found where it is first asked for. Keeps references to the suite and the scene.
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

/// How many samples files keep: of those that lie between, none.
double samples_of(const Job& job) {
  const double interval = job.series != nullptr ? job.dt : sample_interval;
  const double kept = interval * std::max(1.0, std::ceil(job.suite.history_interval / interval - 1e-9));
  return 1 + job.scene.scene.duration / kept;
}

/// Bytes that one line of each file with a line a sample takes together. Numbers of engines have all
/// their digits; those of exact motions are nought now and then.
double line_bytes(const Job& job) {
  constexpr double time = 9, pattern = 4.5, number = 21, exact_number = 14.5, force = 8, nought = 2;
  const Scene& scene = job.scene.scene;
  const auto blocks = static_cast<double>(scene.blocks.size());
  const double angle = job.series != nullptr ? number : exact_number, history = time + 2 * blocks * angle;
  if (job.series == nullptr && job.variant == nullptr) return history + pattern + time + 3 * blocks * force;
  if (!job.suite.wanted.histories) return 0;
  double bytes = history + time + blocks * angle;
  if (job.series == nullptr) return bytes;
  const bool shaken = !scene.horizontal.empty() || !scene.vertical.empty();
  if (job.suite.wanted.bodies)
    bytes += time + exact_number + 3 * number + (shaken ? number : nought) + nought;
  if (job.suite.softness) bytes += time + 3 * blocks * number;
  if (job.suite.wanted.forces) bytes += time + 3 * blocks * force;
  return bytes;
}

/// Bytes of files with a line an event, a replicate or an instant of the band, and of a run's description.
double record_bytes(const Job& job) {
  constexpr double events_a_second = 13e3, description = 8e3, replicate = 4.1e3, band = 4600;
  if (job.series == nullptr) return events_a_second * job.scene.scene.duration;
  const Replicates replicates = replicates_of(job);
  if (replicates.runs < 2) return description;
  const auto blocks = static_cast<double>(job.scene.scene.blocks.size());
  return description + replicate * (replicates.runs - 1) +
         (job.suite.wanted.histories ? band * (1 + 2 * blocks) : 0);
}

}  // namespace

bool is_recorded(const Job& job) {
  return job.series != nullptr && job.series->files;
}

bool has_choice(const Job& job, Variant::Choice choice) {
  return job.variant != nullptr && job.variant->choice == choice;
}

double horizon_of(const Job& job) {
  return job.horizon.valid() ? job.horizon.get() : job.scene.scene.duration;
}

Replicates replicates_of(const Job& job) {
  Replicates replicates = job.suite.replicates;
  if (is_recorded(job)) set_runs(replicates, static_cast<int>(job.series->files->runs.size()));
  if (job.series == nullptr || replicates.most_steps == 0) return replicates;
  const double affordable = replicates.most_steps * job.dt / job.scene.scene.duration;
  replicates.runs = static_cast<int>(std::clamp<double>(affordable, 1, replicates.runs));
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
  } else if (has_choice(job, Variant::Choice::rk4)) {
    row.dt = job.dt;
    row.engine = job.variant->name();
    row.solver = "runge-kutta";
    row.settings = "baseline";
    row.run = fmt::format("{}.{}-{}", row.scene, row.engine, job.dt);
  } else {
    row.engine = job.variant != nullptr ? job.variant->name() : "exact";
    row.solver = has_choice(job, Variant::Choice::measured) ? "" : "taylor";
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
  if (time == scene.duration) return time;
  // What parts within the time of a fall by the stack's size after a flat landing was turned by that.
  const auto landing = flat_landing(own, time);
  if (landing && time - *landing <= 10 * settling_duration(scene))
    time = std::min(time, *landing + sample_interval);
  return time;
}

std::vector<Job> jobs_of(const std::vector<Suite>& suites) {
  static const Variant measured{Variant::Choice::measured};
  std::vector<Job> jobs;
  for (const Suite& suite : suites)
    for (const NamedScene& scene : suite.scenes) {
      const auto horizon = horizon_of(suite, scene);
      jobs.push_back({suite, scene, {}, nullptr, nullptr, horizon});
      for (const Variant& variant : suite.variants)
        jobs.push_back({suite, scene, variant.step, nullptr, &variant, horizon});
      if (scene.measured && scene.measured->is_motion(scene.scene.blocks.size()))
        jobs.push_back({suite, scene, {}, nullptr, &measured, horizon});
      for (const EngineSeries& series : suite.series) {
        if (series.files && series.files->scene != scene.name) continue;
        for (const double dt : series.steps) jobs.push_back({suite, scene, dt, &series, nullptr, horizon});
      }
    }
  return jobs;
}

double result_bytes(const std::vector<Suite>& suites) {
  double bytes = 0;
  for (const Job& job : jobs_of(suites))
    bytes += (is_replicated(job) ? 2 : 1) * samples_of(job) * line_bytes(job) + record_bytes(job);
  return bytes;
}

}  // namespace rockstack
