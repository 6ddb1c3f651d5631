#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "comparisons/results/run_metrics.hpp"
#include "comparisons/suites/suite.hpp"

namespace rockstack {

/// What is wanted of an engine.
struct Wish {
  double error = 1e-3;  ///< largest difference of any angle from the exact one, rad, > 0
  Limits limits = {};   ///< of each run
  int repeats = 3;      ///< timed runs
};

/// The answer: all runs that were made, in their order, and the one to take.
struct Advice {
  std::vector<RunMetrics> rows;
  int pick = -1;  ///< of rows; −1: no run comes within the error
};

/// The steps that are tried, from large to small, s.
std::vector<double> advised_steps();

/// True where a run is done, topples as the exact solution does, and stays within the error.
bool meets(const RunMetrics& row, double error);

/// The cheapest row within the error by its least time of stepping; −1 where there is none.
int cheapest(const std::vector<RunMetrics>& rows, double error);

/// Tries every solver with its tuned parameters from large to small steps until it comes within the error, or
/// takes longer than the cheapest that did. Writes FOLDER/runs/ and FOLDER/advice.csv, the columns of
/// comparison.csv.
/// @throws std::runtime_error where a file cannot be written or the scene has no exact solution.
Advice advise(const NamedScene& scene, const Wish& wish, const std::filesystem::path& folder,
              const std::string& command);

}  // namespace rockstack
