#include "comparisons/runs/compare.hpp"

#include <numeric>

#include "analytic/scene/input/json_reader.hpp"
#include "comparisons/runs/measure.hpp"

namespace rockstack {
namespace {

/// What is computed in one go: the nominal run of a job, or all its replicates. Tasks are numbered: the
/// nominal runs of all jobs, then their replicates.
struct Task {
  std::size_t job;
  bool replicates;
};

Task task_of(std::size_t number, std::size_t jobs) {
  return {number % jobs, number >= jobs};
}

/// Work that a task is expected to be, in engine steps; an exact run has about as much as 2000 of them.
double expected_work(const std::vector<Job>& jobs, std::size_t number) {
  constexpr double fixed = 2000;
  const Task task = task_of(number, jobs.size());
  const Job& job = jobs[task.job];
  if (job.series == nullptr || is_recorded(job)) return fixed;
  const int runs =
      task.replicates ? replicates_of(job).runs : 1 + job.suite.repeats + job.suite.perturbations.runs;
  return fixed + runs * job.scene.scene.duration / job.dt;
}

/// The numbers of all tasks that there are to do: scene by scene, from coarse steps to fine ones, so that
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
  std::ranges::stable_sort(sorted, {}, key);
  std::vector<std::size_t> tasks;
  for (const std::size_t job : sorted) {
    tasks.push_back(job);
    if (is_replicated(jobs[job])) tasks.push_back(job + jobs.size());
  }
  return tasks;
}

class ProgressCounter {
 public:
  ProgressCounter(std::size_t tasks, double work, const std::function<void(const Progress&)>& tell)
      : tell_(tell), left_(work) {
    report_.total = tasks;
    tell_(report_);
  }

  void begin(const std::string& run) {
    report_.running = run;
    tell_(report_);
  }

  /// A task that was there, or was made since.
  void finish(const std::string& run, double work, bool made) {
    ++report_.done;
    report_.last = run;
    if (report_.running == run) report_.running.clear();
    left_ -= work;
    if (made) done_ += work;
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start_;
    if (done_ > 0) report_.remaining = passed.count() * left_ / done_;
    tell_(report_);
  }

 private:
  const std::function<void(const Progress&)>& tell_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  double left_, done_ = 0;
  Progress report_;
};

/// All runs of a comparison, in a results folder.
class Runs {
 public:
  Runs(const std::vector<Job>& jobs, const std::filesystem::path& folder)
      : jobs_(jobs), folder_(folder), rows_(jobs.size()) {
    for (const Job& job : jobs) left_.push_back(is_replicated(job) ? 2 : 1);
  }

  /// Counts a task of a job as done: true where it was the last one.
  bool finish_task(std::size_t job) { return --left_[job] == 0; }

  /// Takes what is there already: true where a task is.
  bool find(std::size_t number) {
    const Task task = task_of(number, jobs_.size());
    const Job& job = jobs_[task.job];
    RunWithReplicates& row = rows_[task.job];
    if (!task.replicates) {
      const auto found = finished_run(run_folder(task.job), identity(job));
      if (found) row.nominal = *found;
      return found.has_value();
    }
    const std::string text = bytes_of(run_folder(task.job) / "draws.json");
    const auto found = unpack_replicates(text, replicates_identity(job));
    // Replicates go with the files of the nominal run.
    if (!found || row.nominal.run.empty()) return false;
    row.replicates = *found;
    return true;
  }

  void deliver(std::size_t number, const std::string& text) {
    const Task task = task_of(number, jobs_.size());
    RunWithReplicates& row = rows_[task.job];
    if (task.replicates) {
      row.replicates = unpack_replicates(text, replicates_identity(jobs_[task.job])).value();
      texts_[task.job] = text;
      std::filesystem::remove_all(run_folder(task.job) / shown_name);
    } else {
      const RunFiles files = unpack(text);
      write_files(files, run_folder(task.job));
      row.nominal = parse_json(files.at(summary_name), "summary: ").get<RunMetrics>();
    }
    if (const auto drawn = texts_.find(task.job); drawn != texts_.end() && !row.nominal.run.empty()) {
      write_replicates(drawn->second, row.nominal, run_folder(task.job));
      texts_.erase(drawn);
    }
  }

  /// Makes the files of the replicate that stands for a job's row, unless they are there or are the nominal
  /// run's.
  void show_representative(std::size_t job) {
    RunWithReplicates& row = rows_[job];
    if (row.replicates.empty() || !jobs_[job].suite.wanted.histories) return;
    row.shown = representative(row);
    const std::filesystem::path folder = run_folder(job) / shown_name;
    constexpr const char* last = "history.csv";
    if (row.shown == 0 || std::filesystem::exists(folder / last)) return;
    if (const RunFiles files = replicate_files(jobs_[job], *row.shown); files.contains(last))
      write_files(files, folder, last);
    else
      row.shown = 0;
  }

  /// True for replicates of a run that has failed.
  bool is_needless(std::size_t number) const {
    const Task task = task_of(number, jobs_.size());
    return task.replicates && rows_[task.job].nominal.status != RunStatus::done;
  }

  const std::vector<RunWithReplicates>& rows() const { return rows_; }

  std::string name(std::size_t number) const {
    return describe(jobs_[task_of(number, jobs_.size()).job]).run;
  }

 private:
  std::filesystem::path run_folder(std::size_t job) const {
    return folder_ / "runs" / describe(jobs_[job]).run;
  }

  const std::vector<Job>& jobs_;
  std::filesystem::path folder_;
  std::vector<int> left_;                     ///< tasks of each job
  std::vector<RunWithReplicates> rows_;       ///< a nominal row without a name is not there yet
  std::map<std::size_t, std::string> texts_;  ///< replicates that came before their nominal run
};

/// The text of a task, to be delivered.
std::string compute_task(const std::vector<Job>& jobs, std::size_t number, const std::string& command,
                         std::size_t at_a_time) {
  const Task task = task_of(number, jobs.size());
  const Job& job = jobs[task.job];
  if (!task.replicates) return pack(measure(job, command, at_a_time));
  const std::size_t threads = std::max<std::size_t>(1, all_cores() / at_a_time);
  return pack_replicates(make_replicates(job, threads), replicates_identity(job));
}

}  // namespace

void serve_comparison(Executor& executor, const std::function<std::vector<Suite>()>& suites,
                      const std::string& command) {
  std::vector<Suite> read;
  std::vector<Job> jobs;
  executor.serve([&](std::size_t task) {
    if (jobs.empty()) {
      read = suites();
      jobs = jobs_of(read);
    }
    return compute_task(jobs, task, command, executor.count());
  });
}

std::pair<std::vector<RunWithReplicates>, std::size_t> carry_out(
    const std::vector<Job>& jobs, const std::filesystem::path& folder, Executor& executor,
    const CompareOptions& options,
    const std::function<void(std::size_t job, const RunWithReplicates&)>& row) {
  Runs runs(jobs, folder);
  const std::vector<std::size_t> order = order_of(jobs);
  double work = 0;
  for (const std::size_t i : order) work += expected_work(jobs, i);
  ProgressCounter progress(order.size(), work, options.progress);
  const auto finish = [&](std::size_t task, bool made) {
    progress.finish(runs.name(task), expected_work(jobs, task), made);
    const std::size_t job = task_of(task, jobs.size()).job;
    if (!runs.finish_task(job)) return;
    runs.show_representative(job);
    row(job, runs.rows()[job]);
  };
  std::vector<std::size_t> tasks;
  std::size_t reused = 0;
  for (const std::size_t i : order) {
    if (!runs.find(i)) {
      tasks.push_back(i);
      continue;
    }
    if (i < jobs.size()) ++reused;
    finish(i, false);
  }
  const auto compute = [&](std::size_t i) {
    return compute_task(jobs, i, options.command, executor.count());
  };
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
  executor.run(tasks, {compute, deliver, [] { return false; }, needless});
  return {runs.rows(), reused};
}

}  // namespace rockstack
