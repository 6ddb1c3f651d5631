#include "comparisons/studies/diff/changes.hpp"

#include <fmt/format.h>

#include "analytic/scene/lists.hpp"

namespace rockstack {
namespace {

std::string bits_of(const RowPair& pair) {
  std::string bits;
  for (const auto& [file, sum] : pair.old_run->checksums) {
    const auto other = pair.new_run->checksums.find(file);
    if (other == pair.new_run->checksums.end()) continue;
    if (other->second != sum) return "different";
    bits = "same";
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

std::vector<std::string> set_of(const RunMetrics& old_row, const RunMetrics& new_row) {
  return {old_row.engine, old_row.solver, old_row.settings, new_row.engine, new_row.solver, new_row.settings};
}

SetPairs sets_of(const std::vector<RowPair>& pairs) {
  SetPairs sets;
  for (const RowPair& pair : pairs)
    if (!pair.old_run->replicates.empty() && !pair.new_run->replicates.empty())
      sets[set_of(pair.old_run->row, pair.new_run->row)].push_back(pair);
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

/// Corrects all tests of one half of the level for how many there are, and judges by them.
void judge_share(const std::vector<QuantityChange*>& tested, double share, ResultsChange& result) {
  const auto chances =
      each_of(tested, [](const QuantityChange* change) -> TestChance { return *change->test; });
  const AdjustedTests adjusted = adjust(chances, share * result.level);
  const std::vector<bool> shown = could_show(chances, share * result.level);
  result.counted += adjusted.counted;
  result.tests += static_cast<std::size_t>(std::count_if(
      chances.begin(), chances.end(), [](const TestChance& chance) { return chance.least_p_value < 1; }));
  for (std::size_t i = 0; i < tested.size(); ++i) {
    tested[i]->adjusted_p_value = std::min(1.0, adjusted.p_values[i] / share);
    tested[i]->could_show = shown[i];
    judge(result.level, *tested[i]);
  }
}

/// What a row has shown, its set does not repeat.
void leave_to_rows(ResultsChange& result) {
  for (RowChange& set : result.sets)
    for (QuantityChange& change : set.quantities)
      for (const RowChange& row : result.rows)
        if (set_of(row.old_row, row.new_row) == set_of(set.old_row, set.new_row))
          for (const QuantityChange& own : row.quantities)
            if (own.quantity == change.quantity && own.turn == change.turn) change.turn = Turn::none;
}

void judge_all(ResultsChange& result) {
  for (const bool foremost : {true, false}) {
    std::vector<QuantityChange*> tested;
    for (std::vector<RowChange>* rows : {&result.rows, &result.sets})
      for (RowChange& row : *rows)
        for (QuantityChange& change : row.quantities)
          if (change.test && change.foremost == foremost) tested.push_back(&change);
    judge_share(tested, foremost ? foremost_share : 1 - foremost_share, result);
  }
  leave_to_rows(result);
}

/// Whether something can be said of a row by itself: it is an exact motion, or the same to the bit, has
/// turned, never varies, or has numbers that could show a change.
bool is_decided(const RowChange& row, const ChangeOptions& options) {
  const auto never_varies = [](const QuantityChange& change) {
    return change.test && change.test->least_p_value == 1 &&
           change.old_values.lower == change.new_values.upper;
  };
  return !row.old_row.steps || row.bits == "same" || row.worst() != Turn::none || row.could_show() ||
         (row.replicated ? std::ranges::all_of(row.quantities, never_varies) : options.single.has_value());
}

void find_undecided(const ChangeOptions& options, ResultsChange& result) {
  for (const RowChange& row : result.rows) {
    const auto names = set_of(row.old_row, row.new_row);
    const bool by_set = row.replicated && std::ranges::any_of(result.sets, [&](const RowChange& set) {
                          return set.could_show() && set_of(set.old_row, set.new_row) == names;
                        });
    if (!by_set && !is_decided(row, options)) result.undecided.push_back(row.old_row.run);
  }
  std::map<std::vector<std::string>, std::size_t> rows;
  for (const RowChange& row : result.rows)
    if (row.old_row.steps) ++rows[set_of(row.old_row, row.new_row)];
  if (!result.undecided.empty())
    result.replicates_needed =
        replicates_that_show_changes(each_of(rows, [](const auto& one) { return one.second; }), result.level);
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

bool same_processor(const RecordedResults& old_results, const RecordedResults& new_results) {
  const auto name = old_results.environment.find("processor");
  return name != old_results.environment.end() &&
         std::ranges::find(new_results.environment, *name) != new_results.environment.end();
}

}  // namespace

Turn RowChange::worst() const {
  return quantities.empty() ? Turn::none
                            : std::ranges::max_element(quantities, {}, &QuantityChange::turn)->turn;
}

bool RowChange::could_show() const {
  return std::ranges::any_of(quantities, &QuantityChange::could_show);
}

bool ResultsChange::worse() const {
  const auto is_worse = [](const RowChange& row) { return row.worst() == Turn::worse; };
  return std::ranges::any_of(rows, is_worse) || std::ranges::any_of(sets, is_worse);
}

ResultsChange hold_against(const RecordedResults& old_results, const RecordedResults& new_results,
                           const ChangeOptions& options) {
  RowPairs pairs = pair_rows(old_results, new_results, options.across);
  const bool timed = same_processor(old_results, new_results);
  const SetPairs sets = sets_of(pairs.pairs);
  ResultsChange result{
      .rows = each_of(pairs.pairs, [&](const RowPair& pair) { return row_change(pair, options, timed); }),
      .sets = set_changes(sets),
      .only_old = std::move(pairs.only_old),
      .only_new = std::move(pairs.only_new),
      .other_questions = std::move(pairs.other_questions),
      .other_environment = other_environment(old_results, new_results),
      .level = options.level};
  judge_all(result);
  find_undecided(options, result);
  return result;
}

}  // namespace rockstack
