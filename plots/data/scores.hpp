#pragma once

#include "plots/data/results.hpp"

namespace rockstack::plots {

/// What every solver of a comparison is asked, scene by scene; the less the better.
struct SolverQuestion {
  std::string name;      ///< of its figure, behind "solvers."
  std::string question;  ///< "Which is …?"
  std::string axis;      ///< what is shown, with its unit
  std::string steps;     ///< which of a series it is of; empty: the common one
  /// The answer of a run at the common step; NaN where it has none.
  double (*value)(const Comparison& comparison, const Run& run);
};

const std::vector<SolverQuestion>& solver_questions();

/// One solver with its settings: its answer to one question in each scene.
struct Score {
  std::vector<Run> runs;       ///< one a scene, those with an answer
  std::vector<double> values;  ///< of these runs
  double median = 0;

  /// The run with the largest answer. Precondition: there is one.
  const Run& worst() const {
    return runs[static_cast<std::size_t>(std::ranges::max_element(values) - values.begin())];
  }
};

/// The scores of all solvers, those with answers in most scenes first, then by rising median.
std::vector<Score> scores(const Comparison& comparison, const SolverQuestion& question);

/// The runs with the largest and the smallest step of a run's scene, solver and set.
std::pair<const Run*, const Run*> step_ends(const Comparison& comparison, const Run& run);

/// The sets that share the verdict's first rank, in words that say whether replicates tell them apart.
std::string first_of_all(const Comparison& comparison);

/// Whether several solvers stand beside each other in several scenes, so that scores say something.
bool has_scores(const Comparison& comparison);

}  // namespace rockstack::plots
