#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "comparisons/measures/results/run_metrics.hpp"
#include "comparisons/measures/statistics/step_fit.hpp"

namespace rockstack {

/// The errors of one engine, solver and parameter set on one scene, fitted over its time steps.
struct SeriesFit {
  std::string scene, engine, solver, settings;
  std::string quantity;  ///< the column whose absolute value is the error
  StepFit fit;
};

/// Fits rms_angle_difference and first_impact_time_difference of every series that was asked for at five time
/// steps or more, in the order of the rows; steps whose runs are not done or lack the column are left out.
std::vector<SeriesFit> fit_runs(const std::vector<RunMetrics>& rows);

/// Objects with scene, engine, solver, settings, quantity, steps, gap, gap_low, gap_high, order, order_low,
/// order_high, coefficient, scatter, holds and reason, numbers as null where there is no fit at all.
nlohmann::ordered_json fits_json(const std::vector<SeriesFit>& fits);

/// The fits that fits_json() gave; numbers that are null are none.
std::vector<SeriesFit> fits_from(const nlohmann::ordered_json& list);

/// What is fitted and how, in one sentence each.
std::string fit_definition();

}  // namespace rockstack
