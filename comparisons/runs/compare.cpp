#include "comparisons/runs/compare.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <numeric>
#include <set>
#include <thread>
#include <utility>

#include "analytic/scene/messages/input_error.hpp"
#include "comparisons/metrics/impacts.hpp"
#include "comparisons/paper/statements.hpp"
#include "comparisons/results/environment.hpp"
#include "comparisons/results/files.hpp"
#include "comparisons/results/tables.hpp"
#include "comparisons/runs/draws.hpp"
#include "comparisons/runs/identity.hpp"
#include "comparisons/runs/measure.hpp"
#include "comparisons/runs/predictability.hpp"
#include "comparisons/statistics/distributions.hpp"
#include "comparisons/statistics/fits.hpp"
#include "comparisons/statistics/ranking.hpp"

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

/// Empty where the suite asks for no draws, or the scene cannot be solved.
Json predictable_json(const Suite& suite, const Scene& scene) {
  if (suite.draws.runs < 2) return {};
  try {
    return predictable_time(scene, suite.draws, suite.tolerance);
  } catch (const std::runtime_error&) {
    return {};
  }
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
                                {"settling_duration", settling_duration(scene.scene)},
                                {"law", name(scene.scene.law)},
                                {"draws", suite.draws.runs},
                                {"draw_steps", suite.draws.steps},
                                {"draw_scene", suite.draws.scene},
                                {"draw_seed", suite.draws.seed},
                                {"predictable_time", predictable_json(suite, scene.scene)},
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

/// What is computed in one go: the nominal run of a job, or all its draws.
struct Part {
  std::size_t job;
  bool draws;
};

Part part_of(std::size_t number, std::size_t jobs) {
  return {number % jobs, number >= jobs};
}

/// Work that a part is expected to be, in engine steps; an exact run has about as much as 2000 of them.
double expected_work(const Job& job, bool draws) {
  constexpr double fixed = 2000;
  if (job.series == nullptr) return fixed;
  const int runs = draws ? job.suite.draws.runs : 1 + job.suite.repeats + job.suite.perturbations.runs;
  return fixed + runs * job.scene.scene.duration / job.dt;
}

/// Counts parts, and the work that is left.
class ProgressCounter {
 public:
  ProgressCounter(std::vector<double> work, const CompareOptions& options)
      : options_(options), work_(std::move(work)) {
    left_ = std::accumulate(work_.begin(), work_.end(), 0.0);
    for (const double one : work_) report_.total += one > 0 ? 1 : 0;
    options_.progress(report_);
  }

  /// A part that was there, or was made since.
  void finish(std::size_t part, const std::string& run, bool made) {
    ++report_.done;
    report_.last = run;
    left_ -= work_[part];
    if (made) done_ += work_[part];
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start_;
    if (done_ > 0) report_.remaining = passed.count() * left_ / done_;
    options_.progress(report_);
  }

 private:
  using Clock = std::chrono::steady_clock;

  const CompareOptions& options_;
  Clock::time_point start_ = Clock::now();
  std::vector<double> work_;  ///< of each part, 0 where there is none to do
  double left_ = 0, done_ = 0;
  Progress report_;
};

/// The text of a part, to be delivered.
std::string compute_part(const std::vector<Job>& jobs, std::size_t number, const std::string& command,
                         std::size_t at_a_time) {
  const Part part = part_of(number, jobs.size());
  const Job& job = jobs[part.job];
  if (!part.draws) return pack(measure(job, command, at_a_time));
  const std::size_t threads = std::max<std::size_t>(1, std::thread::hardware_concurrency() / at_a_time);
  return pack_draws(make_draws(job, threads), draws_identity(job));
}

std::string text_of(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// All runs of a comparison, in a results folder.
class Runs {
 public:
  Runs(const std::vector<Job>& jobs, const std::filesystem::path& folder)
      : jobs_(jobs), folder_(folder), rows_(jobs.size()) {}

  /// Takes what is there already: true where a part is.
  bool find(std::size_t number) {
    const Part part = part_of(number, jobs_.size());
    const Job& job = jobs_[part.job];
    DrawnRow& row = rows_[part.job];
    if (!part.draws) {
      const auto found = finished_run(run_folder(part.job), identity(job));
      if (found) row.nominal = *found;
      return found.has_value();
    }
    const std::string text = text_of(run_folder(part.job) / "draws.json");
    const auto found = unpack_draws(text, draws_identity(job));
    // Draws go with the files of the nominal run.
    if (!found || row.nominal.run.empty()) return false;
    row.draws = *found;
    return true;
  }

  void deliver(std::size_t number, const std::string& text) {
    const Part part = part_of(number, jobs_.size());
    DrawnRow& row = rows_[part.job];
    if (part.draws) {
      row.draws = unpack_draws(text, draws_identity(jobs_[part.job])).value();
      texts_[part.job] = text;
    } else {
      const RunFiles files = unpack(text);
      write_files(files, run_folder(part.job));
      row.nominal = metrics_in(files.at(summary_name));
    }
    if (const auto drawn = texts_.find(part.job); drawn != texts_.end() && !row.nominal.run.empty()) {
      write_draws(drawn->second, row.nominal, run_folder(part.job));
      texts_.erase(drawn);
    }
  }

  /// True for draws of a run that has failed.
  bool is_needless(std::size_t number) const {
    const Part part = part_of(number, jobs_.size());
    return part.draws && rows_[part.job].nominal.status != RunStatus::done;
  }

  /// With their draws.
  const std::vector<DrawnRow>& drawn_rows() const { return rows_; }

  /// Medians where there are draws.
  std::vector<RunMetrics> rows() const {
    std::vector<RunMetrics> list;
    for (const auto& [nominal, draws] : rows_) {
      list.push_back(nominal);
      if (!draws.empty() && nominal.status == RunStatus::done) summarise(draws, list.back());
    }
    return list;
  }

  std::string name(std::size_t number) const {
    return describe(jobs_[part_of(number, jobs_.size()).job]).run;
  }

 private:
  std::filesystem::path run_folder(std::size_t job) const {
    return folder_ / "runs" / describe(jobs_[job]).run;
  }

  const std::vector<Job>& jobs_;
  std::filesystem::path folder_;
  std::vector<DrawnRow> rows_;                ///< a nominal row without a name is not there yet
  std::map<std::size_t, std::string> texts_;  ///< draws that came before their nominal run
};

/// Makes what is not there: nominal runs first, then draws. Returns how many nominal runs were there.
std::size_t make_parts(const std::vector<Job>& jobs, Runs& runs, Executor& executor,
                       const CompareOptions& options) {
  std::vector<double> work;
  for (const bool draws : {false, true}) {
    for (const Job& job : jobs) work.push_back(draws && !is_drawn(job) ? 0 : expected_work(job, draws));
  }
  ProgressCounter progress(work, options);
  std::vector<std::size_t> parts;
  std::size_t reused = 0;
  for (std::size_t i = 0; i < work.size(); ++i) {
    if (work[i] == 0) continue;
    if (!runs.find(i)) {
      parts.push_back(i);
      continue;
    }
    if (i < jobs.size()) ++reused;
    progress.finish(i, runs.name(i), false);
  }
  const auto compute = [&](std::size_t i) {
    return compute_part(jobs, i, options.command, executor.count());
  };
  const auto deliver = [&](std::size_t i, const std::string& text) {
    runs.deliver(i, text);
    progress.finish(i, runs.name(i), true);
  };
  const auto needless = [&](std::size_t i) {
    if (!runs.is_needless(i)) return false;
    progress.finish(i, runs.name(i), false);
    return true;
  };
  executor.run(parts, {compute, deliver, [] { return false; }, needless});
  return reused;
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
            fmt::format("{}: duration = {}: must be at most {} s in a comparison, which samples every {} s",
                        scene.duration_place, scene.scene.duration, longest, sample_interval));
      }
      if (!names.insert(scene.name).second) {
        throw InputError(fmt::format(
            "scene {}: must be in a comparison once; its results would share a folder", scene.name));
      }
    }
  }
}

void serve_comparison(Executor& executor, const std::function<std::vector<Suite>()>& suites,
                      const std::string& command) {
  std::vector<Suite> read;
  std::vector<Job> jobs;
  executor.serve([&](std::size_t part) {
    if (jobs.empty()) {
      read = suites();
      jobs = jobs_of(read);
    }
    return compute_part(jobs, part, command, executor.count());
  });
}

CompareResult compare(const std::vector<Suite>& suites, const std::filesystem::path& folder,
                      const CompareOptions& options) {
  return compare(suites, folder, *make_threads(options.jobs), options);
}

CompareResult compare(const std::vector<Suite>& suites, const std::filesystem::path& folder,
                      Executor& executor, const CompareOptions& options) {
  require_comparable(suites);
  const std::vector<Job> jobs = jobs_of(suites);
  Runs runs(jobs, folder);
  const std::size_t reused = make_parts(jobs, runs, executor, options);
  CompareResult result{runs.rows(), reused};
  const std::vector<SeriesFit> fits = fit_runs(result.rows);
  const std::vector<DistributionDistance> apart = distances(result.rows, folder);
  write_ground(suites, folder);
  if (!apart.empty()) write_file(folder / "distributions.csv", distributions_csv(apart));
  if (!fits.empty()) write_file(folder / "fits.csv", fits_csv(fits));
  if (std::any_of(jobs.begin(), jobs.end(), is_drawn))
    write_file(folder / "spread.csv", spread_csv(runs.drawn_rows()));
  if (const auto ranking = rank_sets(result.rows); !ranking.empty())
    write_file(folder / "ranking.csv", ranking_csv(ranking));
  write_file(folder / "comparison.csv", comparison_csv(result.rows));
  write_file(folder / "comparison.json",
             comparison_json(suites, result.rows, fits, apart, options.command).dump(2) + "\n");
  return result;
}

}  // namespace rockstack
