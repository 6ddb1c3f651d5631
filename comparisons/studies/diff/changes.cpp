#include "comparisons/studies/diff/changes.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "analytic/scene/lists.hpp"

namespace rockstack {
namespace {

/// Whether all columns are equal but those that name the row and those that the machine took.
bool same_cells(const RunMetrics& before, const RunMetrics& now) {
  return std::ranges::all_of(columns(), [&](const Column& column) {
    const bool naming =
        column.name == "run" || std::ranges::find(row_names(), column.name) != row_names().end();
    return naming || column.measured || column.cell(before) == column.cell(now);
  });
}

bool same_cells(const RecordedRun& before, const RecordedRun& now) {
  return same_cells(before.row, now.row) &&
         std::ranges::equal(
             before.replicates, now.replicates,
             [](const RunMetrics& one, const RunMetrics& other) { return same_cells(one, other); });
}

std::string bits_of(const RowPair& pair) {
  const std::string all = same_cells(*pair.old_run, *pair.new_run) ? "same" : "nominal";
  std::string bits;
  for (const auto& [file, sum] : pair.old_run->checksums) {
    const auto other = pair.new_run->checksums.find(file);
    if (other == pair.new_run->checksums.end()) continue;
    if (other->second != sum) return "different";
    bits = all;
  }
  return bits;
}

RowChange row_change(const RowPair& pair, const ChangeOptions& options, bool timed) {
  RowChange row{pair.old_run->row,
                pair.new_run->row,
                bits_of(pair),
                !pair.old_run->replicates.empty() && !pair.new_run->replicates.empty(),
                {}};
  for (const ReportedQuantity& quantity : reported_quantities())
    if (auto change = change_of(quantity, pair, options)) row.quantities.push_back(std::move(*change));
  if (timed)
    if (auto change = cost_change(pair, options)) row.quantities.push_back(std::move(*change));
  return row;
}

/// Rows of one set with replicates in both, by the sets' names.
using SetPairs = std::map<std::vector<std::string>, std::vector<RowPair>>;

SetPairs sets_of(const std::vector<RowPair>& pairs) {
  SetPairs sets;
  for (const RowPair& pair : pairs)
    if (!pair.old_run->replicates.empty() && !pair.new_run->replicates.empty())
      sets[set_of(RowChange{pair.old_run->row, pair.new_run->row, {}, true, {}})].push_back(pair);
  return sets;
}

/// A set of one row is that row.
std::vector<RowChange> set_changes(const SetPairs& sets) {
  std::vector<RowChange> changes;
  for (const auto& [names, pairs] : sets) {
    if (pairs.size() < 2) continue;
    RowChange& set =
        changes.emplace_back(RowChange{pairs.front().old_run->row, pairs.front().new_run->row, "", true, {}});
    for (RunMetrics* row : {&set.old_row, &set.new_row}) {
      row->scene = row->run = "";
      row->dt.reset();
    }
    for (const ReportedQuantity& quantity : reported_quantities())
      if (auto change = change_of(quantity, pairs)) set.quantities.push_back(std::move(*change));
  }
  return changes;
}

std::vector<std::string> other_environment(const RecordedResults& old_results,
                                           const RecordedResults& new_results) {
  std::vector<std::string> others;
  for (const auto& [key, value] : old_results.environment) {
    const auto other = new_results.environment.find(key);
    if (other != new_results.environment.end() && other->second != value)
      others.push_back(fmt::format("{}: {}, {}", key, value, other->second));
  }
  return others;
}

/// Quantities that rows have in the old results alone, where runs are done in both.
std::vector<std::string> lost_quantities(const std::vector<RowPair>& pairs) {
  std::vector<std::string> lost;
  for (const ReportedQuantity& quantity : reported_quantities()) {
    const auto has = [&](const RecordedRun* run) { return quantity.value(run->row).has_value(); };
    const auto done = [](const RecordedRun* run) { return run->row.status == RunStatus::done; };
    const bool before = std::ranges::any_of(
        pairs, [&](const RowPair& pair) { return done(pair.new_run) && has(pair.old_run); });
    if (before && std::ranges::none_of(pairs, has, &RowPair::new_run)) lost.push_back(quantity.name);
  }
  return lost;
}

bool same_processor(const RecordedResults& old_results, const RecordedResults& new_results) {
  const auto name = old_results.environment.find("processor");
  return name != old_results.environment.end() &&
         std::ranges::find(new_results.environment, *name) != new_results.environment.end();
}

}  // namespace

Trend RowChange::worst() const {
  return quantities.empty() ? Trend::none
                            : std::ranges::max_element(quantities, {}, &QuantityChange::trend)->trend;
}

bool RowChange::could_show() const {
  return std::ranges::any_of(quantities, &QuantityChange::could_show);
}

bool ResultsChange::worse() const {
  const auto is_worse = [](const RowChange& row) { return row.worst() == Trend::worse; };
  return std::ranges::any_of(rows, is_worse) || std::ranges::any_of(sets, is_worse);
}

bool ResultsChange::judges_engines() const {
  const auto is_of_engine = [](const RowChange& row) { return row.old_row.engine != "exact"; };
  return (only_old.empty() && only_new.empty() && other_questions.empty()) ||
         std::ranges::any_of(rows, is_of_engine);
}

std::vector<std::string> ResultsChange::judged_no_more() const {
  if (common_alone) return {};
  std::vector<std::string> all = only_old;
  all.insert(all.end(), other_questions.begin(), other_questions.end());
  for (const std::string& quantity : lost) all.push_back(quantity + " of all rows");
  return all;
}

bool ResultsChange::decided() const {
  return undecided.empty() && in_doubt.empty() && more_failures.empty() && judged_no_more().empty() &&
         judges_engines();
}

ResultsChange hold_against(const RecordedResults& old_results, const RecordedResults& new_results,
                           const ChangeOptions& options) {
  RowPairs pairs = pair_rows(old_results, new_results, options.across);
  const bool timed = same_processor(old_results, new_results);
  const SetPairs sets = sets_of(pairs.pairs);
  ResultsChange result{
      .rows = mapped(pairs.pairs, [&](const RowPair& pair) { return row_change(pair, options, timed); }),
      .sets = set_changes(sets),
      .only_old = std::move(pairs.only_old),
      .only_new = std::move(pairs.only_new),
      .other_questions = std::move(pairs.other_questions),
      .other_environment = other_environment(old_results, new_results),
      .level = options.level,
      .common_alone = options.common_alone};
  result.lost = lost_quantities(pairs.pairs);
  judge_all(pairs.pairs, result);
  find_undecided(options, result);
  return result;
}

}  // namespace rockstack
