#include "comparisons/suites/compare_choice.hpp"

#include <fmt/format.h>

#include <cmath>
#include <functional>

#include "analytic/scene/lists.hpp"
#include "analytic/scene/messages/number_text.hpp"

namespace rockstack {

void require_valid(const CompareChoice& choice, const CompareNames& names) {
  for (const double step : choice.scenes.steps) require_above_zero(names.steps, step);
  if (choice.replicates && !(*choice.replicates >= 1 && *choice.replicates <= most_replicates))
    throw InputError(names.replicates + " = " + std::to_string(*choice.replicates) +
                     ": must be a whole number from 1 to " + std::to_string(most_replicates));
  if (!choice.history_interval) return;
  require_above_zero(names.history_interval, *choice.history_interval);
  require_between(names.history_interval, *choice.history_interval, 0);
}

void apply(const CompareChoice& choice, Suite& suite) {
  if (choice.replicates) set_runs(suite.replicates, *choice.replicates);
  if (choice.history_interval) suite.history_interval = *choice.history_interval;
}

void refuse(const SceneChoice& choice, const std::string& study, const std::string& prefix) {
  const auto all = [](const auto& list, const auto& text) { return joined_texts(list, text, ", "); };
  const auto step_text = [](double step) { return number_text(step); };
  const auto name = [](const NamedTrajectory& one) { return one.name; };
  const std::pair<bool, std::string> chosen[] = {
      {!choice.engines.empty(), "engine " + all(choice.engines, std::identity())},
      {!choice.steps.empty(), "dt " + all(choice.steps, step_text)},
      {choice.quick, "quick"},
      {choice.softness, "softness"},
      {choice.forces, "forces"},
      {!choice.trajectories.empty(), "trajectory " + all(choice.trajectories, name)}};
  for (const auto& [is_chosen, words] : chosen)
    if (is_chosen)
      throw InputError(
          fmt::format("{}{}: must be left out of {}, a suite or study says its own", prefix, words, study));
}

void require_above_zero(const std::string& name, double value) {
  if (!(value > 0) || !std::isfinite(value))
    throw InputError(name + " = " + number_text(value) + ": must be a finite number > 0");
}

}  // namespace rockstack
