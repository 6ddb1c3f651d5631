#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

namespace rockstack {

/// One row of a comparison: what was run and how it differs from the exact solution. Empty where it does not
/// apply, was not asked for, or the run failed. columns() holds what each field means, and its unit.
struct Row {
  std::string run, scene, engine, solver, settings;
  std::optional<double> dt;
  std::string status = "done", reason;
  std::optional<int> steps;
  std::optional<double> stepping_time_minimum, stepping_time_median, stepping_time_spread;
  std::optional<int> repeats, runs_at_a_time;
  std::optional<double> real_time_factor, processor_time, peak_memory;
  std::optional<double> largest_angle_difference, rms_angle_difference, relative_angle_difference;
  std::optional<double> magnitude_error, phase_error;
  std::optional<double> second_peak_difference;
  std::optional<double> first_impact_time_difference;
  std::optional<int> impacts_matched, impacts_missed, impacts_extra;
  std::optional<double> rms_impact_time_difference, largest_impact_time_difference;
  std::optional<int> settlings_matched, settlings_missed, settlings_extra;
  std::optional<double> agreement_time;
  std::optional<double> pattern_agreement, pattern_sequence_time;
  std::optional<double> energy_gain, penetration, gap, slip, out_of_plane, out_of_plane_tilt;
  std::optional<double> residual_motion;
  std::optional<int> warnings;
  std::string toppled, toppling_verdict;
};

/// A column of comparison.csv: its name, what it means, and how it is read from a row and put into one.
struct Column {
  const char* name;
  const char* definition;
  nlohmann::ordered_json (*cell)(const Row&);
  void (*set)(Row&, const nlohmann::ordered_json& cell);
  bool measured = false;  ///< time or memory that the machine took: another run gives another value
};

const std::vector<Column>& columns();

/// All cells by the names of their columns.
nlohmann::ordered_json row_json(const Row& row);

/// The row whose cells row_json() gave; a cell that is not there stays empty.
Row row_from(const nlohmann::ordered_json& cells);

}  // namespace rockstack
