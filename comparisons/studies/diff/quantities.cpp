#include "comparisons/studies/diff/quantities.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <utility>

namespace rockstack {
namespace {

using Better = TellingQuantity::Better;

const Column& column_of(const std::string& name) {
  const auto found = std::find_if(columns().begin(), columns().end(),
                                  [&](const Column& column) { return column.name == name; });
  if (found == columns().end()) throw std::logic_error(name + ": no column of a comparison");
  return *found;
}

std::optional<double> value_in_column(const TellingQuantity& quantity, const RunMetrics& row) {
  if (row.status != RunStatus::done) return {};
  const nlohmann::ordered_json cell = column_of(quantity.name).cell(row);
  if (!cell.is_number()) return {};
  return quantity.better == Better::nearer_zero ? std::abs(cell.get<double>()) : cell.get<double>();
}

std::optional<double> failed(const TellingQuantity& /*quantity*/, const RunMetrics& row) {
  return row.status == RunStatus::done ? 0.0 : 1.0;
}

std::optional<double> other_verdict(const TellingQuantity& /*quantity*/, const RunMetrics& row) {
  if (row.status != RunStatus::done || row.toppling_verdict == TopplingVerdict::unknown) return {};
  return differ(row.toppling_verdict) ? 1.0 : 0.0;
}

constexpr std::pair<const char*, Better> told_columns[]{
    {"largest_angle_difference", Better::less},
    {"rms_angle_difference", Better::less},
    {"error", Better::less},
    {"largest_position_difference", Better::less},
    {"rms_position_difference", Better::less},
    {"position_agreement_time", Better::more},
    {"sinking", Better::less},
    {"peak_angle", Better::neither},
    {"magnitude_error", Better::nearer_zero},
    {"phase_error", Better::less},
    {"second_peak_difference", Better::nearer_zero},
    {"agreement_time", Better::more},
    {"first_impact_time_difference", Better::nearer_zero},
    {"impacts_missed", Better::less},
    {"impacts_extra", Better::less},
    {"rms_impact_time_difference", Better::less},
    {"largest_impact_time_difference", Better::less},
    {"settlings_missed", Better::less},
    {"settlings_extra", Better::less},
    {"slip_error", Better::less},
    {"final_slip_error", Better::less},
    {"pattern_agreement", Better::more},
    {"pattern_sequence_time", Better::more},
    {"energy_gain", Better::less},
    {"penetration", Better::less},
    {"gap", Better::neither},
    {"slip", Better::neither},
    {"out_of_plane", Better::less},
    {"out_of_plane_tilt", Better::less},
    {"complementarity_residual", Better::less},
    {"friction_cone_violation", Better::less},
    {"contact_stiffness", Better::neither},
    {"contact_damping", Better::neither},
    {"contact_points", Better::neither},
    {"contact_damping_ratio", Better::neither},
    {"contact_restitution", Better::neither},
    {"contact_impacts_missed", Better::less},
    {"contact_impacts_extra", Better::less},
    {"impact_readings_differ", Better::less},
    {"residual_motion", Better::less},
    {"warnings", Better::less},
    {"model_difference", Better::neither},
    {"softness_difference", Better::neither},
    {"step_difference", Better::less},
};

}  // namespace

const std::vector<TellingQuantity>& telling_quantities() {
  static const std::vector<TellingQuantity> list = [] {
    std::vector<TellingQuantity> all{
        {"failed", "1 for a run, or a draw, that is not done, else 0", Better::less, failed},
        {"other_verdict", "1 where engine or exact solution topples alone, else 0", Better::less,
         other_verdict}};
    all.reserve(all.size() + std::size(told_columns));
    for (const auto& [name, better] : told_columns)
      all.push_back({name, column_of(name).definition, better, value_in_column});
    return all;
  }();
  return list;
}

const std::vector<std::string>& untold_columns() {
  static const std::vector<std::string> list{"relative_angle_difference",
                                             "relative_position_difference",
                                             "exact_peak_angle",
                                             "impacts",
                                             "impacts_matched",
                                             "impacts_matched_null",
                                             "impacts_missed_null",
                                             "impacts_extra_null",
                                             "impacts_matched_random",
                                             "impacts_matched_shifted",
                                             "settlings_matched",
                                             "contact_impacts_matched",
                                             "model_share",
                                             "softness_share",
                                             "step_share",
                                             "parts_over_whole",
                                             "spring_factor"};
  return list;
}

}  // namespace rockstack
