#include <fmt/format.h>

#include "analytic/scene/messages/number_text.hpp"
#include "comparisons/measures/results/sentences.hpp"
#include "comparisons/studies/advise/advise.hpp"

namespace rockstack {
namespace {

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
  }
  if (advice.predictable_time < duration)
    sentences.push_back(
        fmt::format("This holds until {:.4g} s, the horizon of predictability.", advice.predictable_time));
  const auto untried = each_of(advice.untried, [](const Untried& one) { return one.engine->full_name(); });
  if (!untried.empty())
    sentences.push_back(
        fmt::format("In {:g} s the search has not come to smaller steps of {}; --within gives it more.",
                    request.within, joined_up_to(2, untried)));
  return sentences;
}

}  // namespace rockstack
