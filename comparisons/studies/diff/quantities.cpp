#include "analytic/scene/lists.hpp"
#include "comparisons/studies/diff/changes.hpp"

#include <fmt/format.h>

#include <boost/algorithm/string.hpp>
#include <nlohmann/json.hpp>

#include "analytic/scene/messages/number_text.hpp"
#include "comparisons/measures/results/sentences.hpp"
#include "rockstack_comparisons_texts.hpp"

namespace rockstack {
namespace {

using Better = ReportedQuantity::Better;

std::optional<double> failed(const RunMetrics& row) {
  return row.status == RunStatus::done ? 0.0 : 1.0;
}

std::optional<double> other_verdict(const RunMetrics& row) {
  if (row.status != RunStatus::done || row.toppling_verdict == TopplingVerdict::unknown) return {};
  return differ(row.toppling_verdict) ? 1.0 : 0.0;
}

std::function<std::optional<double>(const RunMetrics&)> value_of(const Column& column) {
  return [&column](const RunMetrics& row) -> std::optional<double> {
    if (row.status != RunStatus::done) return {};
    const Json cell = column.cell(row);
    return cell.is_number() ? std::optional(cell.get<double>()) : std::nullopt;
  };
}

/// "less, foremost | error | rad": what is better, the field's words, the unit.
std::vector<std::string> parts_of_kind(const std::string& kind) {
  std::vector<std::string> parts;
  boost::split(parts, boost::replace_all_copy(kind, " | ", "|"), boost::is_any_of("|"));
  parts.resize(3);
  return parts;
}

ReportedQuantity quantity_of(const Paragraph& line) {
  constexpr std::array names{"less", "more", "nearer zero", "neither"};  // as Better has them
  const std::vector<std::string> parts = parts_of_kind(line.kind);
  const std::string& kind = parts.front();
  const auto has = [&](const char* word) { return kind.find(word) != std::string::npos; };
  const auto better =
      static_cast<Better>(std::ranges::find(names, kind.substr(0, kind.find(','))) - names.begin());
  const std::string words = parts[1].empty() ? boost::replace_all_copy(line.name, "_", " ") : parts[1];
  ReportedQuantity quantity{line.name,         words,         parts[2], line.words, better,
                            has(", foremost"), has(", told"), {}};
  if (line.words.empty()) {
    const Column& column = column_named(line.name);
    quantity.definition = column.definition;
    quantity.signed_value = value_of(column);
  } else {
    quantity.signed_value = line.name == "failed" ? failed : other_verdict;
  }
  return quantity;
}

std::vector<double> values_over(const RecordedRun& run,
                                const std::function<std::optional<double>(const RunMetrics&)>& value_of_row) {
  std::vector<double> values;
  const auto add = [&](const RunMetrics& row) {
    if (const auto value = value_of_row(row); value && !std::isnan(*value)) values.push_back(*value);
  };
  if (run.replicates.empty())
    add(run.row);
  else
    std::ranges::for_each(run.replicates, add);
  return values;
}

/// `runs`: those whose values these are.
ValueSpread spread_of(const std::vector<double>& values, const ReportedQuantity& quantity,
                      const std::vector<const RecordedRun*>& runs) {
  std::vector<double> with_sign;
  for (const RecordedRun* run : runs)
    for (const double value : values_over(*run, quantity.signed_value)) with_sign.push_back(value);
  return {quantile(values, 0.25),   median(values),           quantile(values, 0.75), values.size(),
          std::ranges::min(values), std::ranges::max(values), median(with_sign)};
}

Trend trend_of(Better better, bool grown) {
  if (better == Better::neither) return Trend::other;
  return grown == (better == Better::more) ? Trend::better : Trend::worse;
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
Trend trend_by(const std::optional<double>& factor, Better better, double before, double now) {
  if (!factor) return Trend::none;
  if (now > *factor * before + rounding) return trend_of(better, true);
  return before > *factor * now + rounding ? trend_of(better, false) : Trend::none;
}

ValueSpread step_time(const RunMetrics& row) {
  const double steps = row.steps.value_or(1), least = *row.stepping_time_minimum;
  return {least / steps, row.stepping_time_median.value_or(least) / steps,
          (least + row.stepping_time_spread.value_or(0)) / steps,
          static_cast<std::size_t>(std::max(1, row.repeats.value_or(1)))};
}

}  // namespace

std::optional<double> ReportedQuantity::value(const RunMetrics& row) const {
  const std::optional<double> found = signed_value(row);
  return found && better == Better::nearer_zero ? std::abs(*found) : found;
}

std::string ReportedQuantity::text(double value) const {
  constexpr int digits = 2;
  if (unit == "%") return fmt::format("{:.{}g} %", 100 * value, digits);
  const bool plain = unit.empty() || unit.find(" or ") != std::string::npos;
  return plain ? fmt::format("{:.{}g}", value, digits) : quantity_text(value, unit, digits);
}

std::vector<double> values_of(const ReportedQuantity& quantity, const RecordedRun& run) {
  return values_over(run, [&](const RunMetrics& row) { return quantity.value(row); });
}

const ReportedQuantity& quantity_named(const std::string& name) {
  static const ReportedQuantity cost{"step_time", "time of a step", "s", "", Better::less, false, true, {}};
  return name == cost.name ? cost : *std::ranges::find(reported_quantities(), name, &ReportedQuantity::name);
}

const std::vector<ReportedQuantity>& reported_quantities() {
  static const std::vector<ReportedQuantity> list = mapped(paragraphs(quantities_txt), quantity_of);
  return list;
}

std::string name(Trend trend) {
  constexpr std::array<const char*, 4> names{"", "better", "changed", "worse"};
  return names.at(static_cast<std::size_t>(trend));
}

std::optional<QuantityChange> change_of(const ReportedQuantity& quantity, const RowPair& pair,
                                        const ChangeOptions& options) {
  const std::vector<double> before = values_of(quantity, *pair.old_run),
                            now = values_of(quantity, *pair.new_run);
  if (before.empty() || now.empty()) return {};
  QuantityChange change{quantity.name, quantity.better, quantity.foremost,
                        spread_of(before, quantity, {pair.old_run}),
                        spread_of(now, quantity, {pair.new_run})};
  const auto turned = [&](const std::optional<double>& factor) {
    return trend_by(factor, quantity.better, change.old_values.median, change.new_values.median);
  };
  if (before.size() > 1 && now.size() > 1)
    change.test = mann_whitney(before, now);
  else
    change.trend = turned(quantity.name == "failed" ? 1.0 : options.single);
  return change;
}

std::optional<QuantityChange> change_of(const ReportedQuantity& quantity, const std::vector<RowPair>& pairs) {
  std::vector<Stratum> strata;
  Stratum all;
  std::vector<const RecordedRun*> old_runs, new_runs;
  for (const RowPair& pair : pairs) {
    Stratum own{values_of(quantity, *pair.old_run), values_of(quantity, *pair.new_run)};
    if (own.first.empty() || own.second.empty()) continue;
    all.first.insert(all.first.end(), own.first.begin(), own.first.end());
    all.second.insert(all.second.end(), own.second.begin(), own.second.end());
    strata.push_back(std::move(own));
    old_runs.push_back(pair.old_run);
    new_runs.push_back(pair.new_run);
  }
  if (strata.empty()) return {};
  return QuantityChange{quantity.name,
                        quantity.better,
                        quantity.foremost,
                        spread_of(all.first, quantity, old_runs),
                        spread_of(all.second, quantity, new_runs),
                        mann_whitney(strata)};
}

std::optional<QuantityChange> cost_change(const RowPair& pair, const ChangeOptions& options) {
  for (const RecordedRun* run : {pair.old_run, pair.new_run})
    if (!run->row.stepping_time_minimum || run->row.runs_at_a_time.value_or(1) != 1 || run->row.timed_cold)
      return {};
  QuantityChange change{"step_time", Better::less, false, step_time(pair.old_run->row),
                        step_time(pair.new_run->row)};
  const bool overlap = change.old_values.upper >= change.new_values.lower &&
                       change.new_values.upper >= change.old_values.lower;
  if (!overlap)
    change.trend = trend_by(options.cost, change.better, change.old_values.median, change.new_values.median);
  return change;
}

void judge(double level, QuantityChange& change) {
  if (!change.test || change.adjusted_p_value.value_or(1) > level) return;
  if (apart(change.old_values, change.new_values))
    change.trend = trend_of(change.better, change.test->superiority > 0.5);
}

bool looks_worse(const QuantityChange& change, bool judged_by_set, double level) {
  if (!change.test || !apart(change.old_values, change.new_values)) return false;
  constexpr double grave = 5;  // medians of errors that are ten times as large are hardly ever less apart
  const double superiority = change.test->superiority;
  if (trend_of(change.better, superiority > 0.5) != Trend::worse) return false;
  const bool in_all = superiority == 0 || superiority == 1;
  const bool mostly = !change.could_show &&
                      (change.better == Better::more ? change.new_values.median < change.old_values.least
                                                     : change.new_values.median > change.old_values.greatest);
  const bool several_times =
      trend_by(grave, change.better, change.old_values.median, change.new_values.median) == Trend::worse;
  if (judged_by_set) return (in_all || mostly) && several_times;
  return in_all || (several_times && (mostly || (!change.could_show && change.test->p_value <= level)));
}

bool fails_more_often(const QuantityChange& change, double level) {
  if (!change.test || change.trend != Trend::none || change.test->superiority <= 0.5) return false;
  if (change.old_values.greatest > 0 && change.test->p_value > level) return false;
  return change.quantity == "failed" || (change.quantity == "other_verdict" && !change.could_show);
}

}  // namespace rockstack
