#include "comparisons/studies/advise/advise.hpp"

#include <fmt/format.h>

#include "analytic/scene/input/json_reader.hpp"
#include "analytic/scene/messages/number_text.hpp"
#include "comparisons/measures/results/files.hpp"
#include "comparisons/measures/results/provenance.hpp"
#include "comparisons/measures/results/sentences.hpp"
#include "comparisons/measures/results/tables.hpp"
#include "comparisons/measures/statistics/ranking.hpp"
#include "comparisons/measures/statistics/samples.hpp"
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

Json untried_json(const SkippedTrial& one) {
  return {{"engine", one.engine->name}, {"solver", one.engine->solver}, {"below", one.below}};
}

Json trial_json(const Trial& trial) {
  Json cells = trial.row;
  cells["draws_tried"] = trial.replicates;
  cells["draws_within"] = trial.within;
  cells["confirming_draws_tried"] = trial.confirming;
  cells["confirming_draws_within"] = trial.confirmed;
  cells["passes"] = trial.passes();
  return cells;
}

std::optional<double> distance_of(const Trial& trial) {
  return std::max(trial.row.largest_angle_difference, trial.row.relative_position_difference);
}

std::string solver_at_step(const Trial& trial) {
  return fmt::format("{}:{} at {}", trial.row.engine, trial.row.solver,
                     quantity_text(trial.row.dt.value_or(0), "s"));
}

/// Which trial came nearest; nothing where none has numbers.
std::string nearest(const std::vector<Trial>& trials) {
  const Trial* best = nullptr;
  for (const Trial& trial : trials)
    if (distance_of(trial) && (best == nullptr || *distance_of(trial) < *distance_of(*best))) best = &trial;
  return best == nullptr
             ? ""
             : fmt::format(" The nearest is {}, off by {:.2g}.", solver_at_step(*best), *distance_of(*best));
}

double share_within(const Trial& trial) {
  return static_cast<double>(trial.within + trial.confirmed) / (trial.replicates + trial.confirming);
}

/// Whether replicates about a step, and those that confirm it where both have some, tell two trials apart by
/// how many are within.
bool can_tell_apart(const Trial& one, const Trial& other) {
  const auto outcomes = [](int within, int all) {
    std::vector<double> values(static_cast<std::size_t>(all), 0.0);
    std::fill_n(values.begin(), within, 1.0);
    return values;
  };
  std::vector<Stratum> strata{
      {outcomes(one.within, one.replicates), outcomes(other.within, other.replicates)}};
  if (one.confirming > 0 && other.confirming > 0)
    strata.push_back({outcomes(one.confirmed, one.confirming), outcomes(other.confirmed, other.confirming)});
  return mann_whitney(strata).p_value <= separation_level;
}

/// The best of the cheaper trials that were turned down and do not differ from the pick, in words; nothing
/// where there is none. Of a trial of one run nothing is known.
std::string as_good(const std::vector<Trial>& trials, const Trial& pick) {
  const Trial* best = nullptr;
  for (const Trial& trial : trials) {
    if (trial.passes() || trial.replicates < 2 || can_tell_apart(trial, pick)) continue;
    if (!(trial.row.stepping_time_minimum < pick.row.stepping_time_minimum)) continue;
    if (best == nullptr || share_within(trial) > share_within(*best)) best = &trial;
  }
  if (best == nullptr) return "";
  return fmt::format(
      "{} is cheaper and was turned down, with {} of {} within: replicates cannot tell it from the one advised.",
      capitalised(solver_at_step(*best)), best->within + best->confirmed,
      best->replicates + best->confirming);
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

std::vector<std::string> advice_sentences(const AdviceRequest& request, const Advice& advice,
                                          double duration) {
  std::vector<std::string> sentences;
  const std::string error =
      fmt::format("{} of the exact angles and {:g} % of the least block height of the exact centres",
                  quantity_text(request.error, "rad"), 100 * request.error);
  if (advice.pick < 0) {
    sentences.push_back(
        fmt::format("No solver stays within {}, at a step that was tried.{}", error, nearest(advice.trials)));
  } else {
    const Trial& pick = advice.trials[static_cast<std::size_t>(advice.pick)];
    sentences.push_back(
        fmt::format("Take {} with tuned settings: of all that was tried the cheapest that stays within {}.",
                    solver_at_step(pick), error));
    sentences.push_back(fmt::format("{} of {} replicates at nearby steps are within; nine of ten must be.",
                                    pick.within + pick.confirmed, pick.replicates + pick.confirming));
    if (std::string other = as_good(advice.trials, pick); !other.empty())
      sentences.push_back(std::move(other));
  }
  if (advice.predictable_time < duration)
    sentences.push_back(
        fmt::format("This holds until {:.4g} s, the horizon of predictability.", advice.predictable_time));
  const auto untried =
      mapped(advice.untried, [](const SkippedTrial& one) { return one.engine->full_name(); });
  if (!untried.empty())
    sentences.push_back(
        fmt::format("In {:g} s the search has not come to smaller steps of {}; --within gives it more.",
                    request.within, joined_up_to(2, untried)));
  return sentences;
}

Json advice_json(const NamedScene& scene, const AdviceRequest& request, const Advice& advice,
                 const std::string& command) {
  Json json{{"title", scene.scene.title},
            {"headline", advice_sentences(request, advice, scene.scene.duration)},
            {"tables", {"advice.csv"}},
            {"error", request.error},
            {"within", request.within},
            {"duration", scene.scene.duration},
            {"predictable_time", advice.predictable_time},
            {"pick", nullptr},
            {"untried", mapped(advice.untried, untried_json)},
            {"beyond", advice.beyond},
            {"trials", mapped(advice.trials, trial_json)}};
  if (advice.pick >= 0) json["pick"] = json["trials"][static_cast<std::size_t>(advice.pick)];
  json["environment"] = environment(request.engines);
  json["command"] = command;
  return json;
}

}  // namespace rockstack
