#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "analytic/scene/history.hpp"
#include "analytic/scene/scene.hpp"
#include "comparisons/alignment.hpp"
#include "comparisons/difference.hpp"

namespace rockstack {

/// One row of a comparison: what was run and how it differs from the exact solution. Empty where it does not
/// apply or the run failed.
struct Row {
  std::string run, scene, engine, solver, settings;
  std::optional<double> dt;                                              ///< s
  std::string status = "done";                                           ///< or why not, see columns()
  std::string reason;                                                    ///< in full
  std::optional<int> steps;                                              ///< number of time steps
  std::optional<double> stepping_time_minimum, stepping_time_median;     ///< s
  std::optional<double> stepping_time_spread;                            ///< s
  std::optional<int> repeats;                                            ///< timed runs
  std::optional<double> processor_time;                                  ///< s
  std::optional<double> peak_memory;                                     ///< bytes
  std::optional<double> largest_angle_difference, rms_angle_difference;  ///< rad
  std::optional<double> first_impact_time_difference;                    ///< s
  std::optional<int> impacts_matched, impacts_missed, impacts_extra;
  std::optional<double> agreement_time;  ///< s
  std::optional<int> warnings;           ///< steps that the engine's solver said it could not solve
  std::string toppled;                   ///< "block at time", or empty
};

/// A column of comparison.csv: its name, what it means, and how it is read from a row.
struct Column {
  const char* name;
  const char* definition;
  nlohmann::ordered_json (*cell)(const Row&);
};

const std::vector<Column>& columns();

/// The rows as comma-separated values with a header.
std::string comparison_csv(const std::vector<Row>& rows);

/// time,theta_1,…,omega_1,… and, where known, pattern.
std::string history_csv(const History& history);

/// time,kind,interface,from,to,theta_1,…,omega_before_1,…,omega_after_1,…,consistency.
std::string events_csv(const History& history);

/// time,horizontal,vertical in s and m/s²: where samples lie, and every millisecond of a pulse.
std::string ground_csv(const Scene& scene);

/// time,difference_1,…
std::string difference_csv(const Difference& difference);

/// number,interface,exact_time,engine_time,difference,verdict.
std::string impacts_csv(const std::vector<AlignedImpact>& alignment);

}  // namespace rockstack
