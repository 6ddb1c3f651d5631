#include "comparisons/studies/advise/advise.hpp"

#include "analytic/scene/input/json_reader.hpp"
#include "comparisons/measures/results/files.hpp"
#include "comparisons/measures/results/provenance.hpp"
#include "comparisons/measures/results/tables.hpp"
#include "comparisons/runs/execution/executor.hpp"
#include "comparisons/runs/measure.hpp"

namespace rockstack {
namespace {

/// The steps that are tried, s.
const std::vector<double> advised_steps{2e-2, 1e-2, 5e-3, 2e-3, 1e-3, 5e-4, 2e-4, 1e-4, 5e-5, 2e-5};

Suite suite_of(const NamedScene& scene, const AdviceRequest& request) {
  Suite suite;
  suite.title = scene.scene.title;
  suite.scenes = {scene};
  suite.wanted = {.angles = true, .impacts = false, .patterns = false, .bodies = true, .histories = false};
  suite.repeats = request.repeats;
  suite.limits = request.limits;
  suite.replicates = request.replicates;
  for (const WorkerEngine* engine : request.engines)
    suite.series.push_back(make_series(*engine, "tuned", advised_steps));
  return suite;
}

/// The nominal run of a job: from the folder, or made now.
RunMetrics nominal_run(const Job& job, const std::filesystem::path& folder, const std::string& command) {
  if (const auto made = finished_run(folder, identity(job))) return *made;
  const RunFiles files = measure(job, command, 1);
  write_files(files, folder);
  return parse_json(files.at(summary_name), "summary: ").get<RunMetrics>();
}

int count_within(const std::vector<RunMetrics>& replicates, double error) {
  return static_cast<int>(
      std::ranges::count_if(replicates, [&](const RunMetrics& row) { return meets(row, error); }));
}

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// Nothing where its replicates would take longer than what is `left`, s.
std::optional<Trial> try_out(const Job& job, const AdviceRequest& request,
                             const std::filesystem::path& folder, const std::string& command, double left) {
  const auto own = folder / "runs" / describe(job).run;
  const Clock::time_point start = Clock::now();
  Trial trial{nominal_run(job, own, command)};
  trial.within = meets(trial.row, request.error) ? 1 : 0;
  if (trial.within == 0 || !is_replicated(job)) return trial;
  const double took = seconds_since(start), one = took / (1 + request.repeats);
  const int runs = request.replicates.runs + request.confirming.runs;
  if (took + runs * one / static_cast<double>(all_cores()) > left) return {};
  const auto replicates = make_replicates(job, all_cores());
  write_replicates(pack_replicates(replicates, replicates_identity(job)), trial.row, own);
  trial.replicates += static_cast<int>(replicates.rows.size());
  trial.within += count_within(replicates.rows, request.error);
  summarise(replicates.rows, trial.row);
  if (!trial.passes()) return trial;
  Suite about_the_step = job.suite;
  about_the_step.replicates = request.confirming;
  const auto confirming = make_replicates({about_the_step, job.scene, job.dt, job.series}, all_cores()).rows;
  trial.confirming = static_cast<int>(confirming.size());
  trial.confirmed = count_within(confirming, request.error);
  return trial;
}

/// Search of one series, from large to small steps.
struct Search {
  bool over = false;
  std::size_t next = 0;  ///< step
  double took = 0;       ///< the last trial, s
  double promise = 0;    ///< expected_time() after it
};

/// How long stepping would take at the step at which a row's difference comes down to an error, as if in
/// proportion, s.
double expected_time(const RunMetrics& row, double error) {
  if (row.status != RunStatus::done || !row.largest_angle_difference)
    return std::numeric_limits<double>::infinity();
  const double off = std::max(*row.largest_angle_difference, row.relative_position_difference.value_or(0));
  return row.stepping_time_minimum.value_or(0) * std::max(1.0, off / error);
}

/// The search that is expected to end soonest, or nullptr where all are over.
Search* most_promising(std::vector<Search>& searches) {
  Search* best = nullptr;
  for (Search& search : searches)
    if (!search.over && search.next < advised_steps.size() &&
        (best == nullptr || search.promise < best->promise))
      best = &search;
  return best;
}

/// Peaks, impacts and toppling of the whole scene, over the same replicates exactly and by one series.
std::vector<DistributionDistance> whole_scene(const Job& job, const Scene& scene) {
  std::vector<MotionTally> exact, other;
  for (int i = 0; i < job.suite.replicates.runs; ++i) {
    const Scene drawn = replicate_scene(scene, job.suite.replicates, i);
    const double step = replicate_step(job.dt, job.suite.replicates, i);
    try {
      other.push_back(observed_tally(
          drawn,
          simulate(*job.series->engine, drawn, step, job.series->parameters, job.suite.limits).history));
    } catch (const std::runtime_error&) {
      continue;  // the exact tally goes without it too
    }
    exact.push_back(exact_tally(drawn));
  }
  return exact.empty() ? std::vector<DistributionDistance>{} : distances(exact, other);
}

}  // namespace

bool meets(const RunMetrics& row, double error) {
  return row.status == RunStatus::done && row.largest_angle_difference &&
         *row.largest_angle_difference <= error && row.relative_position_difference.value_or(0) <= error &&
         !differ(row.toppling_verdict);
}

int cheapest(const std::vector<Trial>& trials) {
  int best = -1;
  double time = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < trials.size(); ++i) {
    const RunMetrics& row = trials[i].row;
    if (!trials[i].passes() || !(row.stepping_time_minimum.value_or(time) < time)) continue;
    time = *row.stepping_time_minimum;
    best = static_cast<int>(i);
  }
  return best;
}

Advice advise(const NamedScene& scene, const AdviceRequest& request, const std::filesystem::path& folder,
              const std::string& command, const AdviceListener& listener) {
  const Clock::time_point start = Clock::now();
  Advice advice;
  advice.predictable_time = predictable_time(scene.scene, request.replicates, request.error);
  NamedScene predictable = scene;
  predictable.scene.duration = advice.predictable_time;
  const Suite suite = suite_of(predictable, request);
  std::vector<Search> searches(suite.series.size());
  const EngineSeries* picked = nullptr;
  while (Search* const search = most_promising(searches)) {
    const EngineSeries& series = suite.series[static_cast<std::size_t>(search - searches.data())];
    const double dt = advised_steps[search->next],
                 before = search->next > 0 ? advised_steps[search->next - 1] : dt;
    const double begin = seconds_since(start), left = request.within - begin;
    std::optional<Trial> made;
    if (search->took * before / dt <= left) {
      listener.begin(series, dt, begin);
      made = try_out({suite, suite.scenes.front(), dt, &series}, request, folder, command, left);
    }
    if (!made) {
      search->over = true;
      advice.untried.push_back({series.engine, before});
      continue;
    }
    advice.trials.push_back(*std::move(made));
    const Trial& trial = advice.trials.back();
    listener.trial(trial);
    const int pick = cheapest(advice.trials);
    if (pick != advice.pick) picked = &series;
    advice.pick = pick;
    const double best = pick < 0 ? std::numeric_limits<double>::infinity()
                                 : *advice.trials[static_cast<std::size_t>(pick)].row.stepping_time_minimum;
    ++search->next;
    search->took = seconds_since(start) - begin;
    search->promise = expected_time(trial.row, request.error);
    search->over = trial.passes() || trial.row.status == RunStatus::time_limit ||
                   trial.row.stepping_time_minimum.value_or(0) > best;
  }
  if (picked != nullptr && advice.predictable_time < scene.scene.duration) {
    const RunMetrics& row = advice.trials[static_cast<std::size_t>(advice.pick)].row;
    const double longer = scene.scene.duration / advice.predictable_time;
    const double expected = request.replicates.runs * longer * row.stepping_time_minimum.value_or(0);
    if (const double begin = seconds_since(start); begin + expected <= request.within) {
      listener.begin(*picked, *row.dt, begin);
      advice.beyond = whole_scene({suite, suite.scenes.front(), *row.dt, picked}, scene.scene);
    }
  }
  const Json json = advice_json(scene, request, advice, command);
  write_file(folder / "advice.csv", csv_of(json.at("trials")));
  write_file(folder / "advice.json", json.dump(2) + "\n");
  return advice;
}

}  // namespace rockstack
