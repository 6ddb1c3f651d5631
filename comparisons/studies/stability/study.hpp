#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "comparisons/runs/compare.hpp"
#include "comparisons/studies/stability/verdict.hpp"

namespace rockstack {

/// What is varied beside the time step: keys of a scene, or one parameter of the engines.
struct StabilityAxis {
  std::string name;            ///< with its unit
  std::string parameter;       ///< of the engines; empty: scenes
  std::vector<double> values;  ///< one a scene, in the suite's order
};

/// Which solvers are sound at which steps, along an axis.
struct StabilityStudy {
  Suite suite;
  StabilityAxis axis;
  StabilityLimits limits;
  std::string text;  ///< the file as it was read
};

/// True where a file asks for such a study. @throws InputError for a file that is not TOML.
bool is_stability_study(const std::filesystem::path& file);

/// Reads a study. @throws InputError with file:line, key, value and what is allowed.
StabilityStudy read_stability_study(const std::filesystem::path& file,
                                    const std::vector<std::string>& overrides);

/// One run with its verdict.
struct StabilityRun {
  RunMetrics row;
  double value = 0;  ///< on the axis
  StabilityVerdict verdict;
};

/// The largest steps of one solver at one value of the axis up to which all smaller ones of the study hold
/// too; 0: not even the smallest. s.
struct LargestSteps {
  std::string engine, solver, settings;
  double value = 0;
  double sound = 0;
  double stable = 0;  ///< sound or inexact
};

/// In the order of the rows. Exact runs are passed over.
std::vector<LargestSteps> largest_steps(const std::vector<StabilityRun>& rows);

/// Makes the runs that are not there yet, as compare(), and writes besides stability.csv, steps.csv and
/// stability.json. @throws as compare().
std::vector<StabilityRun> run_stability(const StabilityStudy& study, const std::filesystem::path& folder,
                                        Executor& executor, const CompareOptions& options);

}  // namespace rockstack
