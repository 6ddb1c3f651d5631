#include "comparisons/measure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "analytic/solve.hpp"
#include "comparisons/environment.hpp"
#include "comparisons/files.hpp"

namespace rockstack {
namespace {

using Json = nlohmann::ordered_json;

Json summary(const Row& row, const NamedScene& scene, const Parameters& parameters,
             const std::string& command) {
  Json json;
  for (const Column& column : columns()) json[column.name] = column.cell(row);
  json["title"] = scene.scene.title;
  json["parameters"] = parameters;
  json["scene_file"] = scene.text;
  json["environment"] = environment();
  json["command"] = command;
  return json;
}

std::string toppled(const History& history) {
  if (history.events.empty() || history.events.back().kind != EventKind::topple) return "";
  return fmt::format("block {} at {} s", history.events.back().interface, history.events.back().time);
}

/// An engine's history ends early only where a block has toppled; the block and the time are those of its
/// last sample.
std::string toppled(const Scene& scene, const History& history) {
  const auto last = history.angles_at(history.size() - 1);
  for (std::size_t k = 0; k < last.size(); ++k) {
    if (std::abs(last[k]) <= toppling_angle(scene, static_cast<int>(k))) continue;
    return fmt::format("block {} at {} s", k + 1, history.times.back());
  }
  return "";
}

/// Wall times of solving without samples, after a warm-up.
void time_solving(const Scene& scene, double step, int repeats, Row& row) {
  const SolveOptions options{step, {}};
  solve(scene, options);
  std::vector<double> seconds;
  for (int i = 0; i < repeats; ++i) {
    const auto start = std::chrono::steady_clock::now();
    solve(scene, options);
    seconds.push_back(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  }
  std::sort(seconds.begin(), seconds.end());
  row.stepping_time_minimum = seconds.front();
  row.stepping_time_median = 0.5 * (seconds[(seconds.size() - 1) / 2] + seconds[seconds.size() / 2]);
  row.repeats = repeats;
}

void write_history(const std::filesystem::path& folder, const History& history) {
  write_file(folder / "history.csv", history_csv(history));
  write_file(folder / "events.csv", events_csv(history));
}

void run_exact(const Job& job, const std::filesystem::path& folder, Row& row) {
  const Scene& scene = job.scene->scene;
  const History history = solve(scene, {job.dt, regular_times(1e-3, scene.duration)});
  row.toppled = toppled(history);
  time_solving(scene, job.dt, job.suite->repeats, row);
  write_history(folder, history);
}

void run_engine(const Job& job, const std::filesystem::path& folder, Row& row) {
  const Scene& scene = job.scene->scene;
  const EngineSeries& series = *job.series;
  const History history = simulate(*series.engine, scene, job.dt, series.parameters);
  const History exact = solve(scene, {job.suite->exact_step, history.times});
  const Difference apart = difference(exact, history);
  const double slowest = chatter_speed(scene);
  const auto expected = reported_impacts(exact, slowest);
  const auto observed = observed_impacts(history, slowest);
  const auto alignment = align(expected, observed, matching_window(scene));
  const AlignmentCounts counts = count(alignment);
  row.steps = static_cast<int>(history.size() - 1);
  row.largest_angle_difference = largest(apart);
  row.rms_angle_difference = root_mean_square(apart);
  row.agreement_time = agreement_time(apart, job.suite->tolerance);
  if (!expected.empty() && !observed.empty()) {
    row.first_impact_time_difference = observed.front().time - expected.front().time;
  }
  row.impacts_matched = counts.matched;
  row.impacts_missed = counts.missed;
  row.impacts_extra = counts.extra;
  row.toppled = toppled(scene, history);
  const SteppingTime time =
      time_stepping(*series.engine, scene, job.dt, series.parameters, job.suite->repeats);
  row.stepping_time_minimum = time.minimum;
  row.stepping_time_median = time.median;
  row.repeats = time.repeats;
  write_history(folder, history);
  write_file(folder / "difference.csv", difference_csv(apart));
  write_file(folder / "impacts.csv", impacts_csv(alignment));
}

}  // namespace

Row describe(const Job& job) {
  Row row;
  row.scene = job.scene->name;
  row.engine = job.series == nullptr ? "exact" : job.series->engine->name();
  row.solver = job.series == nullptr ? "rk4" : job.series->engine->solver();
  row.dt = job.dt;
  row.run = row.scene + ".exact";
  if (job.series != nullptr) {
    row.settings = job.series->settings;
    row.run = fmt::format("{}.{}-{}-{}-{}", row.scene, row.engine, row.solver, row.settings, job.dt);
  }
  return row;
}

Row measure(const Job& job, const std::filesystem::path& folder, const std::string& command) {
  Row row = describe(job);
  const auto own = folder / "runs" / row.run;
  std::filesystem::create_directories(own);
  try {
    job.series == nullptr ? run_exact(job, own, row) : run_engine(job, own, row);
  } catch (const std::exception& failure) {
    row = describe(job);
    row.status = "failed";
    row.reason = failure.what();
  }
  const Parameters parameters = job.series == nullptr ? Parameters{{"step", job.dt}} : job.series->parameters;
  write_file(own / "summary.json", summary(row, *job.scene, parameters, command).dump(2) + "\n");
  return row;
}

History solve_into(const NamedScene& scene, double step, double interval, const std::filesystem::path& folder,
                   const std::string& command) {
  const History history = solve(scene.scene, {step, regular_times(interval, scene.scene.duration)});
  const Suite suite;
  Row row = describe({&suite, &scene, nullptr, step});
  row.toppled = toppled(history);
  write_history(folder, history);
  write_file(folder / "summary.json", summary(row, scene, {{"step", step}}, command).dump(2) + "\n");
  return history;
}

History simulate_into(const NamedScene& scene, const EngineSeries& series, double dt,
                      const std::filesystem::path& folder, const std::string& command) {
  const History history = simulate(*series.engine, scene.scene, dt, series.parameters);
  const Suite suite;
  Row row = describe({&suite, &scene, &series, dt});
  row.steps = static_cast<int>(history.size() - 1);
  row.toppled = toppled(scene.scene, history);
  write_history(folder, history);
  write_file(folder / "summary.json", summary(row, scene, series.parameters, command).dump(2) + "\n");
  return history;
}

}  // namespace rockstack
