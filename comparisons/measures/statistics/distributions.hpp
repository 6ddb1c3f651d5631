#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "comparisons/measures/results/run_metrics.hpp"
#include "comparisons/measures/statistics/kolmogorov_smirnov.hpp"
#include "comparisons/measures/statistics/tally.hpp"

namespace rockstack {

/// How one quantity of perturbed scenes is distributed in a run's answer and in the exact one.
struct DistributionDistance {
  std::string scene, run;
  std::string quantity;              ///< "peak_1", … (rad), "impacts" or "toppled"
  std::size_t exact = 0, other = 0;  ///< tallies: perturbed scenes less those that failed
  double exact_mean = 0, other_mean = 0;
  KolmogorovSmirnov apart;
};

/// All quantities of two lists of tallies of one scene. Precondition: neither is empty.
std::vector<DistributionDistance> distances(const std::vector<MotionTally>& exact,
                                            const std::vector<MotionTally>& other);

/// Those of every row of a comparison with FOLDER/runs/<run>/perturbed.csv beside that of its scene's exact
/// run.
std::vector<DistributionDistance> distances(const std::vector<RunMetrics>& rows,
                                            const std::filesystem::path& folder);

/// scene,run,quantity,exact_runs,runs,exact_mean,mean,distance,critical,p_value.
std::string distributions_csv(const std::vector<DistributionDistance>& distances);

/// The same as objects.
nlohmann::ordered_json distributions_json(const std::vector<DistributionDistance>& distances);

/// The distances that distributions_json() gave.
std::vector<DistributionDistance> distances_from(const nlohmann::ordered_json& list);

/// What is compared and how.
std::string distribution_definition();

}  // namespace rockstack
