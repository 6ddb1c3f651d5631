#include "comparisons/runs/parts.hpp"

#include <algorithm>
#include <chrono>
#include <fstream>
#include <iterator>
#include <limits>
#include <map>
#include <numeric>
#include <thread>
#include <utility>

#include "comparisons/runs/identity.hpp"
#include "comparisons/runs/measure.hpp"

namespace rockstack {
namespace {

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
  const int runs = draws ? draws_of(job).runs : 1 + job.suite.repeats + job.suite.perturbations.runs;
  return fixed + runs * job.scene.scene.duration / job.dt;
}

/// Of all parts, 0 where there is none to do.
std::vector<double> work_of(const std::vector<Job>& jobs) {
  std::vector<double> work;
  for (const bool draws : {false, true}) {
    for (const Job& job : jobs) work.push_back(draws && !is_drawn(job) ? 0 : expected_work(job, draws));
  }
  return work;
}

/// The numbers of all parts that there are to do: scene by scene, from coarse steps to fine ones, so that
/// what takes little is known soon.
std::vector<std::size_t> order_of(const std::vector<Job>& jobs) {
  std::vector<std::size_t> sorted(jobs.size());
  std::iota(sorted.begin(), sorted.end(), 0);
  std::map<std::string, std::size_t> scenes;
  for (const Job& job : jobs) scenes.emplace(job.scene.name, scenes.size());
  const auto key = [&](std::size_t i) {
    const Job& job = jobs[i];
    return std::pair(scenes.at(job.scene.name),
                     job.series == nullptr ? -std::numeric_limits<double>::infinity() : -job.dt);
  };
  std::stable_sort(sorted.begin(), sorted.end(),
                   [&](std::size_t a, std::size_t b) { return key(a) < key(b); });
  std::vector<std::size_t> parts;
  for (const std::size_t job : sorted) {
    parts.push_back(job);
    if (is_drawn(jobs[job])) parts.push_back(job + jobs.size());
  }
  return parts;
}

/// Counts parts, and the work that is left.
class ProgressCounter {
 public:
  ProgressCounter(std::vector<double> work, const std::function<void(const Progress&)>& tell)
      : tell_(tell), work_(std::move(work)) {
    left_ = std::accumulate(work_.begin(), work_.end(), 0.0);
    for (const double one : work_) report_.total += one > 0 ? 1 : 0;
    tell_(report_);
  }

  void begin(const std::string& run) {
    report_.running = run;
    tell_(report_);
  }

  /// A part that was there, or was made since.
  void finish(std::size_t part, const std::string& run, bool made) {
    ++report_.done;
    report_.last = run;
    if (report_.running == run) report_.running.clear();
    left_ -= work_[part];
    if (made) done_ += work_[part];
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start_;
    if (done_ > 0) report_.remaining = passed.count() * left_ / done_;
    tell_(report_);
  }

 private:
  using Clock = std::chrono::steady_clock;

  const std::function<void(const Progress&)>& tell_;
  Clock::time_point start_ = Clock::now();
  std::vector<double> work_;  ///< of each part, 0 where there is none to do
  double left_ = 0, done_ = 0;
  Progress report_;
};

std::string text_of(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// All runs of a comparison, in a results folder.
class Runs {
 public:
  Runs(const std::vector<Job>& jobs, const std::filesystem::path& folder)
      : jobs_(jobs), folder_(folder), rows_(jobs.size()) {
    for (const Job& job : jobs) left_.push_back(is_drawn(job) ? 2 : 1);
  }

  /// Counts a part of a job as done: true where it was the last one.
  bool finish_part(std::size_t job) { return --left_[job] == 0; }

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

  const std::vector<DrawnRow>& rows() const { return rows_; }

  std::string name(std::size_t number) const {
    return describe(jobs_[part_of(number, jobs_.size()).job]).run;
  }

 private:
  std::filesystem::path run_folder(std::size_t job) const {
    return folder_ / "runs" / describe(jobs_[job]).run;
  }

  const std::vector<Job>& jobs_;
  std::filesystem::path folder_;
  std::vector<int> left_;                     ///< parts of each job
  std::vector<DrawnRow> rows_;                ///< a nominal row without a name is not there yet
  std::map<std::size_t, std::string> texts_;  ///< draws that came before their nominal run
};

}  // namespace

std::vector<Job> jobs_of(const std::vector<Suite>& suites) {
  std::vector<Job> jobs;
  for (const Suite& suite : suites) {
    for (const NamedScene& scene : suite.scenes) {
      const auto horizon = std::make_shared<const Horizon>(suite, scene);
      jobs.push_back({suite, scene, {}, nullptr, nullptr, horizon});
      for (const Variant& variant : suite.variants)
        jobs.push_back({suite, scene, variant.step, nullptr, &variant, horizon});
      for (const EngineSeries& series : suite.series) {
        for (const double dt : series.steps) jobs.push_back({suite, scene, dt, &series, nullptr, horizon});
      }
    }
  }
  return jobs;
}

std::string compute_part(const std::vector<Job>& jobs, std::size_t number, const std::string& command,
                         std::size_t at_a_time) {
  const Part part = part_of(number, jobs.size());
  const Job& job = jobs[part.job];
  if (!part.draws) return pack(measure(job, command, at_a_time));
  const std::size_t threads = std::max<std::size_t>(1, std::thread::hardware_concurrency() / at_a_time);
  return pack_draws(make_draws(job, threads), draws_identity(job));
}

MadeParts make_parts(const std::vector<Job>& jobs, const std::filesystem::path& folder, Executor& executor,
                     const std::string& command, const Listener& listener) {
  Runs runs(jobs, folder);
  const std::vector<std::size_t> order = order_of(jobs);
  ProgressCounter progress(work_of(jobs), listener.progress);
  const auto finish = [&](std::size_t part, bool made) {
    progress.finish(part, runs.name(part), made);
    const std::size_t job = part_of(part, jobs.size()).job;
    if (runs.finish_part(job)) listener.row(job, runs.rows()[job]);
  };
  std::vector<std::size_t> parts;
  std::size_t reused = 0;
  for (const std::size_t i : order) {
    if (!runs.find(i)) {
      parts.push_back(i);
      continue;
    }
    if (i < jobs.size()) ++reused;
    finish(i, false);
  }
  const auto compute = [&](std::size_t i) { return compute_part(jobs, i, command, executor.count()); };
  const auto deliver = [&](std::size_t i, const std::string& text) {
    runs.deliver(i, text);
    finish(i, true);
  };
  const auto needless = [&](std::size_t i) {
    if (!runs.is_needless(i)) {
      progress.begin(runs.name(i));
      return false;
    }
    finish(i, false);
    return true;
  };
  executor.run(parts, {compute, deliver, [] { return false; }, needless});
  return {runs.rows(), reused};
}

}  // namespace rockstack
