#include "comparisons/runs/measure.hpp"

#include <fmt/format.h>

#include "analytic/scene/input/json_reader.hpp"
#include "analytic/scene/input/page_scene.hpp"
#include "comparisons/measures/metrics/branches.hpp"
#include "comparisons/measures/results/files.hpp"
#include "comparisons/measures/results/outcome_columns.hpp"
#include "comparisons/measures/results/provenance.hpp"
#include "comparisons/measures/results/tables.hpp"
#include "comparisons/measures/statistics/distributions.hpp"
#include "engines/scene_setup.hpp"

namespace rockstack {
namespace {

/// `json`: the cells of a row.
Json summary(Json json, const NamedScene& scene, const Json& parameters,
             const std::vector<const WorkerEngine*>& engines, const std::string& command) {
  json["title"] = scene.scene.title;
  json["parameters"] = parameters;
  json["scene_file"] = scene.text;
  json["environment"] = environment(engines);
  json["command"] = command;
  return json;
}

/// That really acts, of each interface from the ground up.
std::vector<double> acting_friction(const EngineSeries& series, const Scene& scene) {
  std::vector<double> friction = friction_of(scene);
  for (double& coefficient : friction) coefficient = series.engine->friction(coefficient);
  return friction;
}

/// Every number that shapes an engine run, with the friction that acts: of each interface, or one number
/// where all are alike.
Json all_parameters(const EngineSeries& series, const Scene& scene) {
  if (series.files) return {{"file", series.files->runs.front().file.string()}};
  const std::vector<double> friction = acting_friction(series, scene);
  const bool alike = std::ranges::adjacent_find(friction, std::not_equal_to<>()) == friction.end();
  Json parameters = with_restitution(*series.engine, scene, series.parameters);
  if (!scene.kinetic_friction.empty() && series.engine->capabilities.kinetic_friction)
    parameters["kinetic_friction"] = scene.kinetic_friction;
  parameters["friction"] = alike ? Json(friction.front()) : Json(friction);
  return parameters;
}

void add_validity(const Scene& scene, const History& history, Json& json) {
  json["validity"] = validity_json(history);
  json["validity_warnings"] = validity_warnings(scene, history);
  if (leaves_pivots(scene.law)) json["contact"] = contact_json(history);
}

/// Wall times of solving without samples, after a warm-up, s.
std::vector<double> time_solving(const Scene& scene, int repeats, const SolveOptions& options) {
  solve(scene, options);
  std::vector<double> seconds;
  for (int i = 0; i < repeats; ++i) {
    const auto start = std::chrono::steady_clock::now();
    solve(scene, options);
    seconds.push_back(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  }
  return seconds;
}

/// `seconds`: wall times of stepping, one or more; `motion`: the time that was simulated, s.
void set_time(const std::vector<double>& seconds, double motion, RunMetrics& row) {
  const auto [least, most] = std::ranges::minmax(seconds);
  row.stepping_time_minimum = least;
  row.stepping_time_median = median(seconds);
  row.stepping_time_spread = most - least;
  row.repeats = static_cast<int>(seconds.size());
  row.real_time_factor = motion / least;
}

void add_history(const History& history, RunFiles& files) {
  files["history.csv"] = history_csv(history);
  files["events.csv"] = events_csv(history);
}

/// Writes the files of one motion by itself; what shows it needs the scene as it was run.
void write_motion(const NamedScene& scene, const History& history, const SupportLoss& support, Json summary,
                  RunFiles files, const std::filesystem::path& folder) {
  add_history(history, files);
  if (scene.scene.horizontal.accelerates() || scene.scene.vertical.accelerates())
    files["ground.csv"] = ground_csv(scene.scene);
  summary.update(outcome_json(run_outcome(scene.scene, history), summary.at("engine") != "exact"));
  if (summary.at("status") == name(RunStatus::done))
    summary["verdict"] = motion_verdict(scene.scene, history, support);
  summary["scene_as_run"] = {{"ground", ground_words(scene.scene)}};
  summary["page"] = page_text(scene.document, scene.scene);
  // The longest first: where the disk is full, none is left behind.
  const auto longest = files.extract("history.csv");
  write_file(folder / longest.key(), longest.mapped());
  for (const auto& [name, text] : files) write_file(folder / name, text);
  write_file(folder / summary_name, summary.dump(2) + "\n");
}

/// `failure`: why the motion was not followed to its end, or nothing.
void write_solved(const SolveJob& asked, const History& history, const std::string& failure,
                  const std::filesystem::path& folder) {
  const bool baseline = asked.options.integrator == Integrator::rk4;
  RunMetrics row = describe({{}, asked.scene, {}});
  row.solver = baseline ? "rk4" : "taylor";
  if (!failure.empty()) row.status = RunStatus::failed;
  row.reason = failure;
  Json json = summary(motion_cells(row), asked.scene,
                      baseline ? Parameters{{"step", asked.options.step}} : Parameters{}, {}, asked.command);
  add_validity(asked.scene.scene, history, json);
  write_motion(asked.scene, history, {}, std::move(json),
               histories_csv(asked.scene.scene, history, asked.histories), folder);
}

/// Makes the runs of perturbed scenes, where they are asked for; one that fails leaves an empty tally.
void run_perturbed(const Job& job, const std::function<MotionTally(const Scene&)>& run, RunFiles& files) {
  const Perturbations& around = job.suite.perturbations;
  std::vector<MotionTally> tallies;
  for (int i = 0; i < around.runs; ++i) {
    try {
      tallies.push_back(run(perturbed(job.scene.scene, around, i)));
    } catch (const std::exception&) {
      tallies.emplace_back();
    }
  }
  if (tallies.empty()) return;
  files["perturbed.csv"] = tallies_csv(tallies, static_cast<int>(job.scene.scene.blocks.size()));
}

/// Why a scene can be compared up to a flat landing alone, if that is so.
std::string jump_of(const Scene& scene, const History& history, double horizon) {
  const auto landing = flat_landing(history, horizon);
  if (!landing || horizon >= scene.duration || horizon - *landing > 2 * sample_interval) return "";
  return fmt::format(
      "that of a block which lands exactly flat, at {:.4g} s: the least tilt would turn it there, so that engines "
      "can be compared up to that landing",
      *landing);
}

/// The exact solver's run, or that of a variant of it, which is compared with it.
Json run_solver(const Job& job, RunMetrics& row, const std::string& command, RunFiles& files) {
  const auto as_run = [&](const Scene& asked) {
    return job.variant != nullptr ? job.variant->apply(asked) : asked;
  };
  const Scene scene = as_run(job.scene.scene);
  SolveOptions timed;
  if (has_choice(job, Variant::Choice::rk4)) timed = {.integrator = Integrator::rk4, .step = job.dt};
  SolveOptions options = timed;
  options.sample_times = regular_times(sample_interval, scene.duration);
  options.validity = true;
  History history;
  try {
    history = solve(scene, options);
  } catch (const Unfinished& unfinished) {
    add_history(unfinished.history, files);  // what is known of it
    throw;
  }
  row.toppled = reported_toppling(history);
  const auto impacts = reported_impacts(scene, history, chatter_speed(scene));
  if (job.variant != nullptr) {
    compare_with_exact(job.scene.scene, job.suite, {history, sample_interval, impacts, !row.toppled.empty()},
                       horizon_of(job), row, files);
    files["events.csv"] = events_csv(history);
  } else {
    row.horizon = horizon_of(job);
    row.outcome = doubt_of(scene, history);
    if (row.outcome.empty()) row.outcome = jump_of(scene, history, *row.horizon);
    row.impacts = static_cast<int>(impacts.size());
    if (!impacts.empty()) {
      row.first_impact_time = impacts.front().time;
      row.first_impact_speed = impacts.front().approach;
    }
    row.slower_impacts = static_cast<int>(reported_impacts(scene, history, 0).size()) - *row.impacts;
    add_history(history, files);
    files["reactions.csv"] = reactions_csv(scene, history);
  }
  compare_with_test(job, scene, history, {}, row, files);
  run_perturbed(
      job, [&](const Scene& other) { return exact_tally(as_run(other)); }, files);
  set_time(time_solving(scene, job.suite.repeats, timed),
           row.toppled.empty() ? scene.duration : history.events.back().time, row);
  Json json = summary(row, job.scene, Json::object(), {}, command);
  add_validity(scene, history, json);
  return json;
}

/// What a test has measured, in the place of a run.
Json run_measured(const Job& job, RunMetrics& row, const std::string& command, RunFiles& files) {
  const History history = motion_of(*job.scene.measured);
  const std::size_t steps = history.size() - 1;
  row.steps = static_cast<int>(steps);
  row.toppled = observed_toppling(job.scene.scene, history);
  const double interval = (history.times.back() - history.times.front()) / static_cast<double>(steps);
  const auto impacts = observed_impacts(job.scene.scene, history, chatter_speed(job.scene.scene));
  compare_with_exact(job.scene.scene, job.suite, {history, interval, impacts, !row.toppled.empty()},
                     horizon_of(job), row, files);
  return summary(row, job.scene, Json::object(), {}, command);
}

Json run_engine(const Job& job, RunMetrics& row, const std::string& command, RunFiles& files) {
  const Scene& scene = job.scene.scene;
  const EngineSeries& series = *job.series;
  const int sharing = *row.runs_at_a_time;
  row = engine_metrics(job, 0, job.suite.repeats, files);
  row.runs_at_a_time = sharing;
  if (row.status == RunStatus::done && !is_recorded(job)) {
    const SolveOptions sampled{.sample_times = regular_times(job.dt, scene.duration)};
    row.exact_sampled_time = std::ranges::min(time_solving(scene, job.suite.repeats, sampled));
    run_perturbed(
        job,
        [&](const Scene& other) {
          return observed_tally(
              other, simulate(*series.engine, other, job.dt, series.parameters, job.suite.limits).history);
        },
        files);
  }
  return summary(row, job.scene, all_parameters(series, scene), {series.engine}, command);
}

/// One run of a series: its scene, its step and what came of it.
struct ReplicateRun {
  Scene scene;
  double dt = 0;  ///< s
  WorkerRun made = {};
};

/// By the engine's worker, or what another program has recorded.
ReplicateRun run_replicate(const Job& job, int replicate, int repeats) {
  const bool bodies = job.suite.wanted.bodies || job.suite.wanted.angles;
  if (is_recorded(job)) {
    const auto& [file, sum, dt, trajectory] = job.series->files->runs.at(static_cast<std::size_t>(replicate));
    ReplicateRun run{job.scene.scene, dt};
    run.made.status = name(RunStatus::done);
    run.made.run =
        engine_run_of(run.scene, set_up(run.scene, dt, {}), trajectory, bodies && !trajectory.bodies.empty());
    return run;
  }
  const Replicates replicates = replicates_of(job);
  ReplicateRun run{replicate_scene(job.scene.scene, replicates, replicate),
                   replicate_step(job.dt, replicates, replicate)};
  run.made = run_in_worker(*job.series->engine, run.scene, run.dt, job.series->parameters, repeats,
                           job.suite.limits, bodies, job.suite.wanted.forces);
  return run;
}

}  // namespace

RunMetrics engine_metrics(const Job& job, int replicate, int repeats, RunFiles& files, History* motion) {
  const auto [scene, dt, made] = run_replicate(job, replicate, repeats);
  RunMetrics row = describe(job);
  row.dt = dt;
  if (!is_recorded(job)) row.processor_time = made.processor_time;
  if (made.peak_memory > 0) row.peak_memory = made.peak_memory;
  row.status = run_status(made.status);
  row.reason = made.reason;
  if (row.status != RunStatus::done) return row;
  const auto& [history, warnings, bodies] = made.run;
  row.steps = static_cast<int>(history.size() - 1);
  row.warnings = static_cast<int>(warnings);
  row.toppled = observed_toppling(scene, history);
  if (bodies) row.fallen = support_of(bodies->penetration, bodies->unsupported_since).fallen;
  compare_with_exact(
      scene, job.suite,
      {history, dt, observed_impacts(scene, history, chatter_speed(scene)),
       !row.toppled.empty() || !row.fallen.empty(), bodies, acting_friction(*job.series, scene)},
      horizon_of(job), row, files);
  compare_with_test(job, scene, history, bodies, row, files);
  if (!made.seconds.empty()) set_time(made.seconds, history.times.back(), row);
  if (made.cold) row.timed_cold = 1;
  if (motion != nullptr) *motion = history;
  return row;
}

RunFiles measure(const Job& job, const std::string& command, std::size_t runs_at_a_time) {
  RunMetrics row = describe(job);
  row.runs_at_a_time = static_cast<int>(runs_at_a_time);
  const auto make = job.series != nullptr                        ? run_engine
                    : has_choice(job, Variant::Choice::measured) ? run_measured
                                                                 : run_solver;
  RunFiles files;
  Json json;
  try {
    json = make(job, row, command, files);
  } catch (const std::exception& failure) {
    row = describe(job);
    row.status = RunStatus::failed;
    row.reason = failure.what();
    json = summary(row, job.scene, Json::object(), {}, command);
  }
  thin_histories(files, job.suite.history_interval);
  json["identity"] = identity(job);
  json["files"] = checksums(files);
  files[summary_name] = json.dump(2) + "\n";
  return files;
}

History solve_into(const SolveJob& job) {
  try {
    History history = solve(job.scene.scene, job.options);
    write_solved(job, history, "", job.folder);
    return history;
  } catch (const Unfinished& unfinished) {
    write_solved(job, unfinished.history, unfinished.what(), job.folder);
    throw std::runtime_error(
        fmt::format("{}; the motion up to there is in {}", unfinished.what(), job.folder.string()));
  }
}

BranchTree solve_branches_into(const SolveJob& job, std::size_t most) {
  BranchTree tree = solve_branches(job.scene.scene, job.options, most);
  for (std::size_t i = 0; i < tree.branches.size(); ++i) {
    const auto own = i == 0 ? job.folder : job.folder / "branches" / std::to_string(i + 1);
    std::filesystem::create_directories(own);
    write_solved(job, tree.branches[i].history, tree.branches[i].unfinished, own);
  }
  write_file(job.folder / "branches.csv", csv_of(branches_json(job.scene.scene, tree)));
  return tree;
}

std::pair<History, SupportLoss> simulate_into(const NamedScene& scene, const EngineSeries& series, double dt,
                                              const std::filesystem::path& folder, const std::string& command,
                                              const std::vector<std::string>& histories) {
  auto [history, warnings, bodies] =
      simulate(*series.engine, scene.scene, dt, series.parameters, {}, true, !histories.empty());
  if (!histories.empty() && history.reactions.empty())
    throw InputError(fmt::format("--histories {}: must be left out of {}, which tells none",
                                 histories.front(), series.engine->full_name()));
  const SupportLoss support = support_of(bodies->penetration, bodies->unsupported_since);
  RunMetrics row = describe({{}, scene, dt, &series});
  row.steps = static_cast<int>(history.size() - 1);
  row.warnings = static_cast<int>(warnings);
  history.patterns = sampled_patterns(scene.scene, history);
  row.fallen = support.fallen;
  write_motion(
      scene, history, support,
      summary(motion_cells(row), scene, all_parameters(series, scene.scene), {series.engine}, command),
      histories_csv(scene.scene, history, histories), folder);
  return {std::move(history), support};
}

}  // namespace rockstack
