#include "plots/data/scores.hpp"

#include "plots/data/selection.hpp"

namespace rockstack::plots {
namespace {

bool is_compared(const Run& run) {
  return run.done() && !run.is_variant() && !run.exact() && run.dt && run.rms_angle_difference;
}

template <auto field>
double cell(const Comparison&, const Run& run) {
  return value_of(run.*field);
}

/// Its error over the least that any set has in its scene at its step; none where the scene is at rest.
double times_the_least(const Comparison& comparison, const Run& run) {
  if (!run.error || run.motion.value_or(0) <= rest_extent) return std::nan("");
  double least = *run.error;
  for (const Run& other : comparison.runs)
    if (is_compared(other) && other.scene == run.scene && other.dt == run.dt && other.error)
      least = std::min(least, *other.error);
  return std::max(*run.error, least_error) / std::max(least, least_error);
}

/// What the smallest step leaves of the error at the largest, where that is more than rounding.
double left_of_error(const Comparison& comparison, const Run& run) {
  const auto [coarsest, finest] = step_ends(comparison, run);
  return coarsest->dt > finest->dt && coarsest->rms_angle_difference > least_error
             ? *finest->rms_angle_difference / *coarsest->rms_angle_difference
             : std::nan("");
}

}  // namespace

std::pair<const Run*, const Run*> step_ends(const Comparison& comparison, const Run& run) {
  const Run *coarsest = &run, *finest = &run;
  for (const Run& other : comparison.runs) {
    if (!is_compared(other) || other.scene != run.scene || line_label(other) != line_label(run)) continue;
    if (other.dt > coarsest->dt) coarsest = &other;
    if (other.dt < finest->dt) finest = &other;
  }
  return {coarsest, finest};
}

const std::vector<SolverQuestion>& solver_questions() {
  static const std::vector<SolverQuestion> questions{
      {"accuracy", "Which is nearest to the exact motion, scene by scene?",
       "error over the least of its scene", "", times_the_least},
      {"convergence", "What does a smaller step leave of the error?", "share of the error that is left",
       "from the largest step to the smallest", left_of_error},
      {"first-impact", "Does the first impact come in time?", "first impact off by (steps)", "",
       [](const Comparison&, const Run& run) {
         return std::abs(value_of(run.first_impact_time_difference)) / *run.dt;
       }},
      {"energy", "Do contacts make energy?", "energy gained (share of weight times height)", "",
       cell<&Run::energy_gain>},
      {"overlap", "How deep do blocks sink into each other?", "largest overlap (m)", "",
       cell<&Run::penetration>},
      {"rest", "Is what rests at rest?", "RMS angular velocity where the exact one is zero (rad/s)", "",
       cell<&Run::residual_motion>},
      {"cost", "What does a step cost?", "time of one step (s)", "",
       [](const Comparison&, const Run& run) {
         return value_of(run.stepping_time_minimum) / value_of(run.steps);
       }},
  };
  return questions;
}

std::vector<Score> scores(const Comparison& comparison, const SolverQuestion& question) {
  // The common step is that which most runs have, the smallest of such.
  std::map<double, std::size_t> counts;
  for (const Run& run : comparison.runs)
    if (is_compared(run)) ++counts[*run.dt];
  const auto common = std::ranges::max_element(counts, {}, [](const auto& count) { return count.second; });
  std::map<std::string, Score> groups;
  for (const Run& run : comparison.runs) {
    if (!is_compared(run) || run.dt != common->first) continue;
    const double value = question.value(comparison, run);
    if (!std::isfinite(value)) continue;
    Score& score = groups[line_label(run)];
    score.runs.push_back(run);
    score.values.push_back(value);
  }
  std::vector<Score> list;
  for (auto& [label, score] : groups) {
    score.median = median(score.values);
    list.push_back(std::move(score));
  }
  std::ranges::stable_sort(list, [](const Score& a, const Score& b) {
    return a.runs.size() != b.runs.size() ? a.runs.size() > b.runs.size() : a.median < b.median;
  });
  return list;
}

std::string first_of_all(const Comparison& comparison) {
  const std::vector<RankedSet>& ranking = comparison.verdict.ranking;
  std::vector<std::string> first;
  for (const RankedSet& set : ranking)
    if (set.rank == 1) first.push_back(set_name(set));
  return nearest_phrase(first, ranking.size());
}

bool has_scores(const Comparison& comparison) {
  std::set<std::string> scenes, solvers;
  for (const Run& run : comparison.runs)
    if (is_compared(run)) {
      scenes.insert(run.scene);
      solvers.insert(run.solver_name());
    }
  return scenes.size() > 2 && solvers.size() > 1;
}

}  // namespace rockstack::plots
