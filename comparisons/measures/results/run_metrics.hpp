#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "comparisons/measures/metrics/motion_verdict.hpp"

namespace rockstack {

/// How a run ended; columns() has what each means.
enum class RunStatus { done, failed, not_finite, signal, time_limit, memory_limit };

/// "done", "not finite", …
std::string name(RunStatus status);

/// The status of that name. @throws std::invalid_argument where there is none.
RunStatus run_status(const std::string& name);

/// What was run and how it differs from the exact solution: one row of a comparison. Empty where it does not
/// apply, was not asked for, or the run failed. columns() holds what each field means, and its unit. Numbers
/// of the motion are medians over replicates where the suite asks for some.
struct RunMetrics {
  std::string run, scene, law, engine, solver, settings;
  std::optional<double> dt;
  RunStatus status = RunStatus::done;
  std::string reason;
  std::optional<int> steps;
  std::optional<double> stepping_time_minimum, stepping_time_median, stepping_time_spread;
  std::optional<int> repeats, runs_at_a_time, timed_cold;
  std::optional<double> real_time_factor, exact_sampled_time, processor_time, peak_memory;
  std::optional<int> replicates, replicates_failed, replicates_other_verdict;
  std::optional<double> horizon;
  std::optional<double> largest_angle_difference, rms_angle_difference, relative_angle_difference;
  std::optional<double> largest_angle_difference_lower, largest_angle_difference_upper;
  std::optional<double> rms_angle_difference_lower, rms_angle_difference_upper;
  std::optional<double> largest_position_difference, relative_position_difference;
  std::optional<double> rms_position_difference, rms_position_difference_lower, rms_position_difference_upper;
  std::optional<double> error, error_lower, error_upper;
  std::optional<double> rms_test_difference;
  std::optional<int> rank;
  std::optional<double> motion, peak_angle, exact_peak_angle;
  std::optional<double> magnitude_error, phase_error;
  std::optional<double> slip_error, final_slip_error;
  std::optional<double> second_peak_difference;
  std::optional<double> first_impact_time_difference;
  std::optional<int> impacts, slower_impacts;
  std::optional<int> impacts_matched, impacts_missed, impacts_extra;
  std::optional<int> impacts_matched_null, impacts_missed_null, impacts_extra_null;
  std::optional<int> impacts_matched_random, impacts_matched_shifted;
  std::optional<double> rms_impact_time_difference, largest_impact_time_difference;
  std::optional<int> settlings_matched, settlings_missed, settlings_extra;
  std::optional<double> agreement_time, agreement_time_lower, agreement_time_upper;
  std::optional<double> position_agreement_time;
  std::optional<double> pattern_agreement, pattern_sequence_time;
  std::optional<double> sinking;
  std::optional<double> energy_gain, penetration, gap, slip, out_of_plane, out_of_plane_tilt;
  std::optional<double> complementarity_residual, friction_cone_violation;
  std::optional<double> contact_stiffness, contact_damping;
  std::optional<double> contact_points, contact_damping_ratio, contact_restitution;
  std::optional<int> contact_impacts_matched, contact_impacts_missed, contact_impacts_extra;
  std::optional<int> impact_readings_differ;
  std::optional<double> residual_motion;
  std::optional<int> warnings;
  std::string outcome, toppled, fallen;
  TopplingVerdict toppling_verdict = TopplingVerdict::unknown;
  std::optional<double> model_difference, softness_difference, step_difference;
  std::optional<double> model_share, softness_share, step_share, parts_over_whole;
  std::optional<double> spring_factor;
  std::string split_reason;
};

/// A column of comparison.csv: its name, what it means, and of which member it is.
struct Column {
  using Field =
      std::variant<std::string RunMetrics::*, std::optional<double> RunMetrics::*,
                   std::optional<int> RunMetrics::*, RunStatus RunMetrics::*, TopplingVerdict RunMetrics::*>;

  std::string name;
  const char* definition;
  Field field;
  bool measured = false;    ///< time or memory that the machine took: another run gives another value
  bool replicated = false;  ///< a median over replicates, where there are some
  std::optional<Field> lower = {}, upper = {};  ///< of a column that has its quartiles beside it

  nlohmann::ordered_json cell(const RunMetrics& row) const;
  void set(RunMetrics& row, const nlohmann::ordered_json& cell) const;
  /// Nothing where it has none.
  void set_quartiles(RunMetrics& row, const nlohmann::ordered_json& low,
                     const nlohmann::ordered_json& high) const;
};

const std::vector<Column>& columns();

/// All metrics by the names of their columns, and back; a cell that is not there stays empty.
void to_json(nlohmann::ordered_json& cells, const RunMetrics& row);
void from_json(const nlohmann::ordered_json& cells, RunMetrics& row);

}  // namespace rockstack
