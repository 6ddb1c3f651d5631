#include <fmt/format.h>

#include "analytic/scene/messages/number_text.hpp"
#include "comparisons/measures/results/provenance.hpp"
#include "comparisons/measures/results/sentences.hpp"
#include "comparisons/measures/statistics/ranking.hpp"
#include "comparisons/measures/statistics/samples.hpp"
#include "comparisons/studies/advise/advise.hpp"

// What advice comes to, in sentences and as JSON.

namespace rockstack {
namespace {

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
