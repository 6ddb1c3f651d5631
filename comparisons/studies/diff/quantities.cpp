#include "comparisons/studies/diff/changes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <utility>

namespace rockstack {
namespace {

using Better = ReportedQuantity::Better;

const Column& column_of(const std::string& name) {
  const auto found =
      std::ranges::find_if(columns(), [&](const Column& column) { return column.name == name; });
  if (found == columns().end()) throw std::logic_error(name + ": no column of a comparison");
  return *found;
}

std::optional<double> failed(const RunMetrics& row) {
  return row.status == RunStatus::done ? 0.0 : 1.0;
}

std::optional<double> other_verdict(const RunMetrics& row) {
  if (row.status != RunStatus::done || row.toppling_verdict == TopplingVerdict::unknown) return {};
  return differ(row.toppling_verdict) ? 1.0 : 0.0;
}

constexpr std::pair<const char*, Better> reported_columns[]{
    {"largest_angle_difference", Better::less},
    {"rms_angle_difference", Better::less},
    {"rms_test_difference", Better::less},
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

std::vector<double> values_of(const ReportedQuantity& quantity, const RecordedRun& run) {
  std::vector<double> values;
  const auto add = [&](const RunMetrics& row) {
    if (const auto value = quantity.value(row); value && !std::isnan(*value)) values.push_back(*value);
  };
  if (run.replicates.empty())
    add(run.row);
  else
    std::ranges::for_each(run.replicates, add);
  return values;
}

ValueSpread spread_of(const std::vector<double>& values) {
  return {quantile(values, 0.25), median(values), quantile(values, 0.75), values.size()};
}

Turn turn_of(Better better, bool grown) {
  if (better == Better::neither) return Turn::other;
  return grown == (better == Better::more) ? Turn::better : Turn::worse;
}

constexpr double rounding = 1e-12;  // in any unit: rad, m, s, shares

/// Whether any of three numbers differs by more than nothing.
bool apart(const ValueSpread& one, const ValueSpread& other) {
  constexpr double share = 0.01;
  const auto differ = [&](double a, double b) {
    return std::abs(a - b) > std::max(rounding, share * std::max(std::abs(a), std::abs(b)));
  };
  return differ(one.lower, other.lower) || differ(one.median, other.median) || differ(one.upper, other.upper);
}

/// What a factor says of two numbers.
Turn turn_by(const std::optional<double>& factor, Better better, double before, double now) {
  if (!factor) return Turn::none;
  if (now > *factor * before + rounding) return turn_of(better, true);
  return before > *factor * now + rounding ? turn_of(better, false) : Turn::none;
}

ValueSpread step_time(const RunMetrics& row) {
  const double steps = row.steps.value_or(1), least = *row.stepping_time_minimum;
  return {least / steps, row.stepping_time_median.value_or(least) / steps,
          (least + row.stepping_time_spread.value_or(0)) / steps,
          static_cast<std::size_t>(std::max(1, row.repeats.value_or(1)))};
}

}  // namespace

const std::vector<ReportedQuantity>& reported_quantities() {
  static const std::vector<ReportedQuantity> list = [] {
    std::vector<ReportedQuantity> all{
        {"failed", "1 for a run, or a draw, that is not done, else 0", Better::less, failed},
        {"other_verdict", "1 where engine or exact solution topples alone, else 0", Better::less,
         other_verdict}};
    all.reserve(all.size() + std::size(reported_columns));
    for (const auto& [name, better] : reported_columns) {
      const Column& column = column_of(name);
      const auto value = [&column, nearer_zero = better == Better::nearer_zero](
                             const RunMetrics& row) -> std::optional<double> {
        if (row.status != RunStatus::done) return {};
        const nlohmann::ordered_json cell = column.cell(row);
        if (!cell.is_number()) return {};
        return nearer_zero ? std::abs(cell.get<double>()) : cell.get<double>();
      };
      all.push_back({name, column.definition, better, value});
    }
    return all;
  }();
  return list;
}

std::string name(Turn turn) {
  constexpr std::array<const char*, 4> names{"", "better", "changed", "worse"};
  return names.at(static_cast<std::size_t>(turn));
}

std::optional<QuantityChange> change_of(const ReportedQuantity& quantity, const RowPair& pair,
                                        const ChangeOptions& options) {
  const std::vector<double> before = values_of(quantity, *pair.old_run),
                            now = values_of(quantity, *pair.new_run);
  if (before.empty() || now.empty()) return {};
  QuantityChange change{quantity.name, quantity.better, spread_of(before), spread_of(now)};
  const auto turned = [&](const std::optional<double>& factor) {
    return turn_by(factor, quantity.better, change.old_values.median, change.new_values.median);
  };
  if (before.size() > 1 && now.size() > 1)
    change.test = mann_whitney(before, now);
  else
    change.turn = turned(quantity.name == "failed" ? 1.0 : options.single);
  return change;
}

std::optional<QuantityChange> cost_change(const RowPair& pair, const ChangeOptions& options) {
  for (const RecordedRun* run : {pair.old_run, pair.new_run})
    if (!run->row.stepping_time_minimum || run->row.runs_at_a_time.value_or(1) != 1 || run->row.timed_cold)
      return {};
  QuantityChange change{"step_time", Better::less, step_time(pair.old_run->row),
                        step_time(pair.new_run->row)};
  const bool overlap = change.old_values.upper >= change.new_values.lower &&
                       change.new_values.upper >= change.old_values.lower;
  if (!overlap)
    change.turn = turn_by(options.cost, change.better, change.old_values.median, change.new_values.median);
  return change;
}

void judge(double level, QuantityChange& change) {
  if (!change.test || change.adjusted_p_value.value_or(1) > level) return;
  if (apart(change.old_values, change.new_values))
    change.turn = turn_of(change.better, change.test->superiority > 0.5);
}

}  // namespace rockstack
