#include "comparisons/runs/compare.hpp"

#include <fmt/format.h>

#include <tuple>

#include "analytic/scene/input/page_scene.hpp"
#include "comparisons/measures/metrics/bodies.hpp"
#include "comparisons/measures/results/files.hpp"
#include "comparisons/measures/results/provenance.hpp"
#include "comparisons/measures/results/tables.hpp"
#include "comparisons/runs/paper_statements.hpp"

namespace rockstack {
namespace {

void add_evidence(const RunMetrics& run, ReplicatedRow& row) {
  const bool done = run.status == RunStatus::done && run.error;
  row.errors.push_back(done ? *run.error : std::numeric_limits<double>::infinity());
  if (!done || !run.peak_angle) return;
  row.peaks.push_back(*run.peak_angle);
  row.exact_peaks.push_back(*run.exact_peak_angle);
}

std::vector<JudgedScene> judged_scenes(const std::vector<Suite>& suites) {
  std::vector<JudgedScene> scenes;
  for (const Suite& suite : suites)
    for (const NamedScene& scene : suite.scenes)
      scenes.push_back({scene.name, least_height(scene.scene.blocks), scene.scene.duration, suite.tolerance});
  return scenes;
}

/// Rows as they are reported: medians over replicates, with what stands behind them, what becomes of them in
/// words, and their ranks among those of their scene and step.
std::vector<ReplicatedRow> reported_rows(const std::vector<RunWithReplicates>& rows,
                                         const std::vector<JudgedScene>& scenes) {
  std::vector<ReplicatedRow> reported;
  reported.reserve(rows.size());
  std::map<std::pair<std::string, double>, std::vector<ReplicatedRow*>> cells;
  for (const auto& [nominal, replicates, shown] : rows) {
    ReplicatedRow& one = reported.emplace_back(ReplicatedRow{nominal, {}});
    add_evidence(nominal, one);
    for (const RunMetrics& replicate : replicates) add_evidence(replicate, one);
    if (!replicates.empty() && nominal.status == RunStatus::done) summarise(replicates, one);
    one.shown_replicate = shown;
    if (!is_engine(one)) continue;
    std::vector<RunMetrics> runs{nominal};
    runs.insert(runs.end(), replicates.begin(), replicates.end());
    one.events = events_of(runs, part_named(scenes, nominal.scene));
    one.outcome = outcome(runs, part_named(scenes, nominal.scene));
    cells[{nominal.scene, *nominal.dt}].push_back(&one);
  }
  for (const auto& [cell, own] : cells)
    for (const RankedSet& set : rank_all(mapped(own, [](const ReplicatedRow* row) { return *row; })))
      for (ReplicatedRow* one : own)
        if (set_name(*one) == set_name(set) && one->status == RunStatus::done) one->rank = set.rank;
  return reported;
}

/// Tells rows as CompareOptions has them, those that are told together the nearest first. Keeps references.
auto row_reporter(const std::vector<Job>& jobs, const std::vector<JudgedScene>& scenes,
                  const CompareOptions& options) {
  struct Cell {
    std::size_t left = 0;  ///< rows that are still to come
    std::vector<RunWithReplicates> rows = {};
  };
  std::map<std::pair<std::string, double>, Cell> cells;  // by scene and step, 0 of the exact solutions
  const auto key_of = [](const Job& job) {
    return std::pair(job.scene.name, job.series == nullptr ? 0 : job.dt);
  };
  for (const Job& job : jobs) ++cells[key_of(job)].left;
  return [&, key_of, cells](std::size_t job, const RunWithReplicates& row) mutable {
    Cell& cell = cells[key_of(jobs[job])];
    cell.rows.push_back(row);
    if (jobs[job].series != nullptr) options.row(reported_rows({row}, scenes).front());
    if (--cell.left > 0) return;
    std::vector<ReplicatedRow> rows = reported_rows(std::exchange(cell.rows, {}), scenes);
    const auto place = [](const RunMetrics& one) {
      return std::tuple(one.status != RunStatus::done, one.rank.value_or(0), one.error.value_or(0));
    };
    std::ranges::stable_sort(rows, {}, place);
    options.rows({rows.begin(), rows.end()});
  };
}

/// Empty where the scene cannot be solved.
Json predictable_json(const std::string& scene, const std::vector<RunMetrics>& rows) {
  const auto exact = std::ranges::find_if(
      rows, [&](const RunMetrics& row) { return row.scene == scene && row.engine == "exact"; });
  return exact != rows.end() && exact->horizon ? Json(*exact->horizon) : Json();
}

Json statements_json(const std::vector<Suite>& suites) {
  Json list = Json::array();
  for (const Suite& suite : suites) {
    if (!suite.statements) continue;
    for (const Statement& statement : judge(gather(suite)))
      list.push_back({{"source", statement.source},
                      {"claim", statement.claim},
                      {"verdict", name(statement.verdict)},
                      {"criterion", statement.criterion},
                      {"computed", statement.computed}});
  }
  return list;
}

std::vector<const WorkerEngine*> engines_of(const std::vector<Suite>& suites) {
  std::vector<const WorkerEngine*> list;
  for (const Suite& suite : suites)
    for (const EngineSeries& series : suite.series) list.push_back(series.engine);
  return list;
}

Json comparison_json(const std::vector<Suite>& suites, const CompareResult& result,
                     const ComparisonEvidence& evidence, const std::string& command) {
  const std::vector<RunMetrics>& rows = result.rows;
  Json json;
  json["scenes"] = Json::array();
  for (const Suite& suite : suites)
    for (const NamedScene& scene : suite.scenes)
      json["scenes"].push_back({{"name", scene.name},
                                {"ground", ground_words(scene.scene)},
                                {"draws", suite.replicates.runs},
                                {"draw_steps", suite.replicates.steps},
                                {"draw_scene", suite.replicates.scene},
                                {"draw_seed", suite.replicates.seed},
                                {"predictable_time", predictable_json(scene.name, rows)},
                                {"measured", scene.measured ? Json{{"columns", scene.measured->columns},
                                                                   {"unit", scene.measured->unit()}}
                                                            : Json()},
                                {"results", names_of(suite.wanted)},
                                {"perturbations", suite.perturbations.runs},
                                {"perturbation_size", suite.perturbations.size},
                                {"perturbation_seed", suite.perturbations.seed},
                                {"toml", scene.text},
                                {"page", page_text(scene.document, scene.scene)}});
  json["title"] = fmt::format("{}", fmt::join(mapped(suites, &Suite::title), "; "));
  json["verdict"] = verdict_json(result.verdict, judged_scenes(suites));
  for (const Column& column : columns()) json["definitions"][column.name] = column.definition;
  json["tolerance_rad"] = suites.front().tolerance;
  json["left_out"] = engines_left_out(suites);
  for (const Suite& suite : suites)
    if (!suite.print.empty() && !json.contains("figures")) json["figures"] = suite.print;
  json["environment"] = environment(engines_of(suites));
  json["command"] = command;
  json["statements"] = statements_json(suites);
  json["fit_definition"] = fit_definition;
  json["fits"] = evidence.fits;
  json["distribution_definition"] = distribution_definition;
  json["distributions"] = evidence.distances;
  json["rows"] = rows;
  return json;
}

void write_ground(const std::vector<Suite>& suites, const std::filesystem::path& folder) {
  for (const Suite& suite : suites)
    for (const NamedScene& scene : suite.scenes) {
      if (!scene.scene.horizontal.accelerates() && !scene.scene.vertical.accelerates()) continue;
      std::filesystem::create_directories(folder / "ground");
      write_file(folder / "ground" / (scene.name + ".csv"), ground_csv(scene.scene));
    }
}

/// A step that is longer than one scene costs its rows there, one that is longer than all is a mistake.
void require_short_steps(const Suite& suite) {
  double longest = 0;
  for (const NamedScene& scene : suite.scenes) longest = std::max(longest, scene.scene.duration);
  for (const EngineSeries& series : suite.series)
    for (const double dt : series.steps)
      if (dt > longest && !suite.scenes.empty())
        throw InputError(fmt::format("{}: dt = {} s: must be at most {} s, the duration of the longest scene",
                                     series.engine->full_name(), dt, longest));
}

}  // namespace

void require_comparable(const std::vector<Suite>& suites) {
  std::set<std::string> names;
  for (const Suite& suite : suites) {
    if (suite.tolerance != suites.front().tolerance)
      throw InputError(fmt::format("tolerance = {}: must be the same in all suites of one comparison, {}",
                                   suite.tolerance, suites.front().tolerance));
    std::set<std::tuple<std::string, std::string, double>> runs;
    for (const EngineSeries& series : suite.series) {
      const std::string engine = series.engine->full_name();
      for (const double dt : series.steps)
        if (!runs.emplace(engine, series.settings, dt).second)
          throw InputError(fmt::format(
              "engine {}: must be in a comparison once; its results would share a folder", engine));
    }
    require_short_steps(suite);
    for (const NamedScene& scene : suite.scenes) {
      constexpr double longest = 1e7 * sample_interval;
      if (scene.scene.duration > longest)
        throw InputError(
            fmt::format("{}: duration = {}: must be at most {} s in a comparison, which samples every {} s",
                        scene.duration_place, scene.scene.duration, longest, sample_interval));
      if (!names.insert(scene.name).second)
        throw InputError(fmt::format(
            "scene {}: must be in a comparison once; its results would share a folder", scene.name));
    }
  }
}

CompareResult compare(const std::vector<Suite>& suites, const std::filesystem::path& folder,
                      Executor& executor, const CompareOptions& options) {
  require_comparable(suites);
  const std::vector<Job> jobs = jobs_of(suites);
  const std::vector<JudgedScene> scenes = judged_scenes(suites);
  const auto [made, reused] = carry_out(jobs, folder, executor, options, row_reporter(jobs, scenes, options));
  ComparisonEvidence evidence{reported_rows(made, scenes), {}, {}};
  CompareResult result{{evidence.rows.begin(), evidence.rows.end()}, reused, {}};
  evidence.fits = fit_runs(result.rows);
  evidence.distances = distances(result.rows, folder);
  result.verdict = verdict_of(evidence, scenes);
  write_ground(suites, folder);
  if (!evidence.distances.empty()) write_file(folder / "distributions.csv", csv_of(evidence.distances));
  if (!evidence.fits.empty()) write_file(folder / "fits.csv", csv_of(evidence.fits));
  if (std::ranges::any_of(jobs, is_replicated)) write_file(folder / "spread.csv", spread_csv(made));
  if (const auto ranking = rank_sets(evidence.rows); !ranking.empty())
    write_file(folder / "ranking.csv", ranking_csv(ranking));
  write_file(folder / "comparison.csv", csv_of(result.rows));
  write_file(folder / "comparison.json",
             comparison_json(suites, result, evidence, options.command).dump(2) + "\n");
  return result;
}

}  // namespace rockstack
