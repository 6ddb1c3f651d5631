#pragma once

#include <string>
#include <vector>

#include "comparisons/measures/results/run_metrics.hpp"

namespace rockstack {

/// One parameter set of a solver among all of that solver, over the scenes and steps of a comparison.
struct RankedSet {
  std::string engine, solver, settings;
  int rank = 0;  ///< from 1 within the solver
  double score =
      0;  ///< geometric mean, over scenes and steps, of its RMS angle difference over the least of the solver
  double worst = 0;  ///< the largest of those ratios
  int cells = 0;     ///< scenes and steps that count
  int failed = 0;    ///< of those, where its run is not done: each counts as a hundred times the least
};

/// Ranks the sets of every solver that has several, best first. A scene and step counts where a set of the
/// solver is done there; numbers are the rows' own, medians where there are draws.
std::vector<RankedSet> rank_sets(const std::vector<RunMetrics>& rows);

/// engine,solver,rank,settings,score,worst,cells,failed.
std::string ranking_csv(const std::vector<RankedSet>& sets);

}  // namespace rockstack
