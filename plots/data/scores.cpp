#include "plots/data/scores.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "plots/data/selection.hpp"

namespace rockstack::plots {
namespace {

bool is_compared(const Run& run) {
  return run.done() && !is_variant(run) && !run.exact() && !std::isnan(run.dt) &&
         !std::isnan(run.rms_angle_difference);
}

template <double Run::*field>
double value_of(const Comparison&, const Run& run) {
  return run.*field;
}

bool same_series(const Run& a, const Run& b) {
  return a.scene == b.scene && solver_name(a) == solver_name(b) && a.settings == b.settings;
}

/// What the smallest step leaves of the error at the largest, where that is more than rounding.
double left_of_error(const Comparison& comparison, const Run& run) {
  const auto [coarsest, finest] = step_ends(comparison, run);
  return coarsest->dt > finest->dt && coarsest->rms_angle_difference > least_error
             ? finest->rms_angle_difference / coarsest->rms_angle_difference
             : std::nan("");
}

double middle(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : (values[half - 1] + values[half]) / 2;
}

}  // namespace

StepEnds step_ends(const Comparison& comparison, const Run& run) {
  StepEnds ends{&run, &run};
  for (const Run& other : comparison.runs) {
    if (!is_compared(other) || !same_series(other, run)) continue;
    if (other.dt > ends.coarsest->dt) ends.coarsest = &other;
    if (other.dt < ends.finest->dt) ends.finest = &other;
  }
  return ends;
}

const std::vector<SolverQuestion>& solver_questions() {
  static const std::vector<SolverQuestion> questions{
      {"accuracy", "Which is nearest to the exact motion?", "RMS angle difference (rad)", "",
       value_of<&Run::rms_angle_difference>},
      {"convergence", "What does a smaller step leave of the error?", "share of the error that is left",
       "from the largest step to the smallest", left_of_error},
      {"first-impact", "Does the first impact come in time?", "first impact off by (steps)", "",
       [](const Comparison&, const Run& run) { return std::abs(run.first_impact_time_difference) / run.dt; }},
      {"energy", "Do contacts make energy?", "energy gained (share of weight times height)", "",
       value_of<&Run::energy_gain>},
      {"overlap", "How deep do blocks sink into each other?", "largest overlap (m)", "",
       value_of<&Run::penetration>},
      {"rest", "Is what rests at rest?", "RMS angular velocity where the exact one is zero (rad/s)", "",
       value_of<&Run::residual_motion>},
      {"cost", "What does a step cost?", "time of one step (s)", "",
       [](const Comparison&, const Run& run) { return run.stepping_time / run.steps; }},
  };
  return questions;
}

const Run& Score::worst() const {
  return runs[static_cast<std::size_t>(std::max_element(values.begin(), values.end()) - values.begin())];
}

double common_step(const Comparison& comparison) {
  std::map<double, std::size_t> counts;
  for (const Run& run : comparison.runs)
    if (is_compared(run)) ++counts[run.dt];
  if (counts.empty()) return std::nan("");
  return std::max_element(counts.begin(), counts.end(),
                          [](const auto& a, const auto& b) { return a.second < b.second; })
      ->first;
}

std::vector<Score> scores(const Comparison& comparison, const SolverQuestion& question) {
  const double dt = common_step(comparison);
  std::map<std::string, Score> groups;
  for (const Run& run : comparison.runs) {
    if (!is_compared(run) || run.dt != dt) continue;
    const double value = question.value(comparison, run);
    if (!std::isfinite(value)) continue;
    Score& score = groups[line_label(run)];
    score.runs.push_back(run);
    score.values.push_back(value);
  }
  std::vector<Score> list;
  for (auto& [label, score] : groups) {
    score.median = middle(score.values);
    list.push_back(std::move(score));
  }
  std::stable_sort(list.begin(), list.end(), [](const Score& a, const Score& b) {
    return a.runs.size() != b.runs.size() ? a.runs.size() > b.runs.size() : a.median < b.median;
  });
  return list;
}

bool has_scores(const Comparison& comparison) {
  std::set<std::string> scenes, solvers;
  for (const Run& run : comparison.runs)
    if (is_compared(run)) {
      scenes.insert(run.scene);
      solvers.insert(solver_name(run));
    }
  return scenes.size() > 2 && solvers.size() > 1;
}

}  // namespace rockstack::plots
