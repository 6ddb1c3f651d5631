#include "comparisons/suites/compare_choice.hpp"

#include <cmath>

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

void require_above_zero(const std::string& name, double value) {
  if (!(value > 0) || !std::isfinite(value))
    throw InputError(name + " = " + number_text(value) + ": must be a finite number > 0");
}

}  // namespace rockstack
