#include "comparisons/studies/diff/quantity_change.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <vector>

#include "comparisons/measures/statistics/samples.hpp"

namespace rockstack {
namespace {

using Better = TellingQuantity::Better;

std::vector<double> values_of(const TellingQuantity& quantity, const RecordedRun& run) {
  std::vector<double> values;
  const auto add = [&](const RunMetrics& row) {
    if (const auto value = quantity.value(quantity, row); value && !std::isnan(*value))
      values.push_back(*value);
  };
  if (run.draws.empty())
    add(run.row);
  else
    std::for_each(run.draws.begin(), run.draws.end(), add);
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

std::string name(Turn turn) {
  constexpr std::array<const char*, 4> names{"", "better", "changed", "worse"};
  return names.at(static_cast<std::size_t>(turn));
}

std::optional<QuantityChange> change_of(const TellingQuantity& quantity, const RowPair& pair,
                                        const ChangeFactors& factors) {
  const std::vector<double> before = values_of(quantity, *pair.old_run),
                            now = values_of(quantity, *pair.new_run);
  if (before.empty() || now.empty()) return {};
  QuantityChange change{quantity.name, spread_of(before), spread_of(now), {}, {}, Turn::none};
  if (before.size() > 1 && now.size() > 1)
    change.test = mann_whitney(before, now);
  else if (quantity.name == "failed")
    change.turn = turn_by(1.0, quantity.better, change.old_values.median, change.new_values.median);
  else
    change.turn =
        turn_by(factors.single, quantity.better, change.old_values.median, change.new_values.median);
  return change;
}

std::optional<QuantityChange> cost_change(const RowPair& pair, const ChangeFactors& factors) {
  for (const RecordedRun* run : {pair.old_run, pair.new_run})
    if (!run->row.stepping_time_minimum || run->row.runs_at_a_time.value_or(1) != 1 || run->row.timed_cold)
      return {};
  QuantityChange change{"step_time", step_time(pair.old_run->row), step_time(pair.new_run->row), {}, {},
                        Turn::none};
  const bool overlap = change.old_values.upper >= change.new_values.lower &&
                       change.new_values.upper >= change.old_values.lower;
  if (!overlap)
    change.turn = turn_by(factors.cost, Better::less, change.old_values.median, change.new_values.median);
  return change;
}

void judge(const TellingQuantity& quantity, double level, QuantityChange& change) {
  if (!change.test || change.adjusted_p_value.value_or(1) > level) return;
  if (apart(change.old_values, change.new_values))
    change.turn = turn_of(quantity.better, change.test->superiority > 0.5);
}

}  // namespace rockstack
