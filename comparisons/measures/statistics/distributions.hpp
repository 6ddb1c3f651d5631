#pragma once

#include <filesystem>

#include "comparisons/measures/results/run_metrics.hpp"
#include "comparisons/measures/statistics/samples.hpp"

namespace rockstack {

/// What a perturbed run came to.
struct MotionTally {
  std::vector<double> peaks;  ///< largest |θ| of each block, rad; none where the run failed
  int impacts = 0;            ///< above the chatter speed
  bool topples = false;

  bool failed() const { return peaks.empty(); }
};

/// Tally of the exact solution. @throws as solve().
MotionTally exact_tally(const Scene& scene);

/// Tally of an engine's history.
MotionTally observed_tally(const Scene& scene, const History& history);

/// run,peak_1,…,impacts,toppled: a line a tally, empty cells where a run failed.
std::string tallies_csv(const std::vector<MotionTally>& tallies, int blocks);

/// The tallies of a file. @throws InputError as read_table().
std::vector<MotionTally> read_tallies(const std::filesystem::path& file);

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

/// With scene, run, quantity, exact_runs, runs, exact_mean, mean, distance, critical and p_value; and back.
void to_json(Json& json, const DistributionDistance& distance);
void from_json(const Json& json, DistributionDistance& distance);

/// What is compared and how.
inline constexpr const char* distribution_definition =
    "the same slightly perturbed scenes for every answer; distance is the Kolmogorov–Smirnov distance "
    "between the engine's distribution of the quantity and the exact one, p_value the chance of that "
    "distance or more if both were one distribution and the scenes drawn anew for each, critical the "
    "distance with a chance of 5 %. peak_k is the largest angle of block k (rad), impacts counts those "
    "above the chatter speed, toppled is 1 where a block topples";

}  // namespace rockstack
