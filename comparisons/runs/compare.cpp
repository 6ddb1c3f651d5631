#include "comparisons/runs/compare.hpp"

#include <fmt/format.h>

#include <chrono>
#include <nlohmann/json.hpp>
#include <numeric>
#include <set>

#include "analytic/scene/messages/input_error.hpp"
#include "comparisons/metrics/impacts.hpp"
#include "comparisons/paper/statements.hpp"
#include "comparisons/results/environment.hpp"
#include "comparisons/results/files.hpp"
#include "comparisons/results/tables.hpp"
#include "comparisons/runs/executor.hpp"
#include "comparisons/runs/identity.hpp"
#include "comparisons/runs/measure.hpp"
#include "comparisons/statistics/distributions.hpp"
#include "comparisons/statistics/fits.hpp"

namespace rockstack {
namespace {

using Json = nlohmann::ordered_json;

std::vector<Job> jobs_of(const std::vector<Suite>& suites) {
  std::vector<Job> jobs;
  for (const Suite& suite : suites) {
    for (const NamedScene& scene : suite.scenes) {
      jobs.push_back({suite, scene, {}});
      for (const Variant& variant : suite.variants)
        jobs.push_back({suite, scene, variant.step, nullptr, &variant});
      for (const EngineSeries& series : suite.series) {
        for (const double dt : series.steps) jobs.push_back({suite, scene, dt, &series});
      }
    }
  }
  return jobs;
}

std::string ground_of(const Scene& scene) {
  std::string text = scene.horizontal.source;
  if (!scene.vertical.empty()) text += (text.empty() ? "" : "; ") + scene.vertical.source + ", vertical";
  return text;
}

/// Sizes and masses as they were run, overrides included; SI units, bottom to top.
Json stack_json(const Scene& scene) {
  Json list = Json::array();
  for (const Block& block : scene.blocks) {
    list.push_back({{"width", 2 * block.half_width},
                    {"height", 2 * block.half_height},
                    {"mass", block.mass},
                    {"inertia", block.inertia}});
  }
  return list;
}

Json statements_json(const std::vector<Suite>& suites) {
  Json list = Json::array();
  for (const Suite& suite : suites) {
    if (!suite.statements) continue;
    for (const Statement& statement : judge(gather(suite))) {
      list.push_back({{"source", statement.source},
                      {"claim", statement.claim},
                      {"verdict", name(statement.verdict)},
                      {"criterion", statement.criterion},
                      {"computed", statement.computed}});
    }
  }
  return list;
}

std::vector<const WorkerEngine*> engines_of(const std::vector<Suite>& suites) {
  std::vector<const WorkerEngine*> list;
  for (const Suite& suite : suites) {
    for (const EngineSeries& series : suite.series) list.push_back(series.engine);
  }
  return list;
}

Json comparison_json(const std::vector<Suite>& suites, const std::vector<RunMetrics>& rows,
                     const std::vector<SeriesFit>& fits, const std::vector<DistributionDistance>& apart,
                     const std::string& command) {
  Json json;
  std::vector<std::string> titles;
  json["scenes"] = Json::array();
  for (const Suite& suite : suites) {
    titles.push_back(suite.title);
    for (const NamedScene& scene : suite.scenes) {
      json["scenes"].push_back({{"name", scene.name},
                                {"title", scene.scene.title},
                                {"blocks", scene.scene.blocks.size()},
                                {"stack", stack_json(scene.scene)},
                                {"gravity", scene.scene.gravity},
                                {"duration", scene.scene.duration},
                                {"ground", ground_of(scene.scene)},
                                {"chatter_speed", chatter_speed(scene.scene)},
                                {"matching_window", matching_window(scene.scene)},
                                {"results", names_of(suite.wanted)},
                                {"perturbations", suite.perturbations.runs},
                                {"perturbation_size", suite.perturbations.size},
                                {"perturbation_seed", suite.perturbations.seed},
                                {"toml", scene.text}});
    }
  }
  json["title"] = fmt::format("{}", fmt::join(titles, "; "));
  for (const Column& column : columns()) json["definitions"][column.name] = column.definition;
  json["tolerance_rad"] = suites.front().tolerance;
  json["left_out"] = engines_left_out();
  json["environment"] = environment(engines_of(suites));
  json["command"] = command;
  json["statements"] = statements_json(suites);
  json["fit_definition"] = fit_definition();
  json["fits"] = fits_json(fits);
  json["distribution_definition"] = distribution_definition();
  json["distributions"] = distributions_json(apart);
  json["rows"] = Json::array();
  for (const RunMetrics& row : rows) json["rows"].push_back(metrics_json(row));
  return json;
}

void write_ground(const std::vector<Suite>& suites, const std::filesystem::path& folder) {
  for (const Suite& suite : suites) {
    for (const NamedScene& scene : suite.scenes) {
      if (scene.scene.horizontal.empty() && scene.scene.vertical.empty()) continue;
      prepare_folder(folder / "ground");
      write_file(folder / "ground" / (scene.name + ".csv"), ground_csv(scene.scene));
    }
  }
}

/// Work that a run is expected to be, in engine steps; an exact run has about as much as 2000 of them.
double expected_work(const Job& job) {
  constexpr double fixed = 2000;
  if (job.series == nullptr) return fixed;
  const int runs = 1 + job.suite.repeats + job.suite.perturbations.runs;
  return fixed + runs * job.scene.scene.duration / job.dt;
}

/// Counts runs, and the work that is left.
class ProgressCounter {
 public:
  ProgressCounter(const std::vector<Job>& jobs, const CompareOptions& options) : options_(options) {
    for (const Job& job : jobs) work_.push_back(expected_work(job));
    left_ = std::accumulate(work_.begin(), work_.end(), 0.0);
    report_.total = jobs.size();
    options_.progress(report_);
  }

  /// A run that was there, or was made since.
  void finish(std::size_t job, const std::string& run, bool made) {
    ++report_.done;
    report_.last = run;
    left_ -= work_[job];
    if (made) done_ += work_[job];
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start_;
    if (done_ > 0) report_.remaining = passed.count() * left_ / done_;
    options_.progress(report_);
  }

 private:
  using Clock = std::chrono::steady_clock;

  const CompareOptions& options_;
  Clock::time_point start_ = Clock::now();
  std::vector<double> work_;
  double left_ = 0, done_ = 0;
  Progress report_;
};

CompareResult make_runs(const std::vector<Job>& jobs, const std::filesystem::path& folder,
                        const CompareOptions& options) {
  CompareResult result{std::vector<RunMetrics>(jobs.size()), 0};
  ProgressCounter progress(jobs, options);
  std::vector<std::size_t> parts;
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    const std::string run = describe(jobs[i]).run;
    if (const auto row = finished_run(folder / "runs" / run, identity(jobs[i]))) {
      result.rows[i] = *row;
      ++result.reused;
      progress.finish(i, run, false);
    } else {
      parts.push_back(i);
    }
  }
  const auto compute = [&](std::size_t i) {
    result.rows[i] = measure(jobs[i], folder, options.command, options.jobs);
    return std::string();
  };
  const auto deliver = [&](std::size_t i, const std::string& /*text*/) {
    progress.finish(i, result.rows[i].run, true);
  };
  make_threads(options.jobs)->run(parts, {compute, deliver, [] { return false; }});
  return result;
}

}  // namespace

void require_comparable(const std::vector<Suite>& suites) {
  std::set<std::string> names;
  for (const Suite& suite : suites) {
    if (suite.tolerance != suites.front().tolerance) {
      throw InputError(fmt::format("tolerance = {}: must be the same in all suites of one comparison, {}",
                                   suite.tolerance, suites.front().tolerance));
    }
    for (const NamedScene& scene : suite.scenes) {
      constexpr double longest = 1e7 * sample_interval;
      if (scene.scene.duration > longest) {
        throw InputError(
            fmt::format("scene {}: duration = {}: must be at most {} s in a comparison, which samples "
                        "every {} s",
                        scene.name, scene.scene.duration, longest, sample_interval));
      }
      if (!names.insert(scene.name).second) {
        throw InputError(fmt::format(
            "scene {}: must be in a comparison once; its results would share a folder", scene.name));
      }
    }
  }
}

CompareResult compare(const std::vector<Suite>& suites, const std::filesystem::path& folder,
                      const CompareOptions& options) {
  require_comparable(suites);
  CompareResult result = make_runs(jobs_of(suites), folder, options);
  const std::vector<SeriesFit> fits = fit_runs(result.rows);
  const std::vector<DistributionDistance> apart = distances(result.rows, folder);
  write_ground(suites, folder);
  if (!apart.empty()) write_file(folder / "distributions.csv", distributions_csv(apart));
  if (!fits.empty()) write_file(folder / "fits.csv", fits_csv(fits));
  write_file(folder / "comparison.csv", comparison_csv(result.rows));
  write_file(folder / "comparison.json",
             comparison_json(suites, result.rows, fits, apart, options.command).dump(2) + "\n");
  return result;
}

}  // namespace rockstack
