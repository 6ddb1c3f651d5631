#include "comparisons/studies/diff/changes.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <tuple>

#include "analytic/scene/lists.hpp"
#include "comparisons/measures/results/csv.hpp"

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

/// Corrects all tests for how many there are, and judges by them.
void judge_all(ResultsChange& result) {
  std::vector<QuantityChange*> tested;
  for (RowChange& row : result.rows)
    for (QuantityChange& change : row.quantities)
      if (change.test) tested.push_back(&change);
  const auto chances =
      each_of(tested, [](const QuantityChange* change) -> TestChance { return *change->test; });
  const AdjustedTests adjusted = adjust(chances, result.level);
  result.counted = adjusted.counted;
  result.tests = static_cast<std::size_t>(std::count_if(
      chances.begin(), chances.end(), [](const TestChance& chance) { return chance.least_p_value < 1; }));
  for (std::size_t i = 0; i < tested.size(); ++i) {
    tested[i]->adjusted_p_value = adjusted.p_values[i];
    judge(result.level, *tested[i]);
  }
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

Json spread_json(const ValueSpread& spread) {
  return {
      {"lower", spread.lower}, {"median", spread.median}, {"upper", spread.upper}, {"values", spread.values}};
}

Json change_json(const QuantityChange& change) {
  Json json{{"quantity", change.quantity},
            {"turn", name(change.turn)},
            {"old", spread_json(change.old_values)},
            {"new", spread_json(change.new_values)}};
  if (change.test) {
    json["superiority"] = change.test->superiority;
    json["p_value"] = change.test->p_value;
    json["adjusted_p_value"] = *change.adjusted_p_value;
  }
  return json;
}

Json row_json(const RowChange& row) {
  return {{"scene", row.old_row.scene},
          {"engine", row.old_row.engine},
          {"solver", row.old_row.solver},
          {"settings", row.old_row.settings},
          {"dt", row.old_row.dt ? Json(*row.old_row.dt) : Json()},
          {"old_run", row.old_row.run},
          {"new_run", row.new_row.run},
          {"old_status", name(row.old_row.status)},
          {"new_status", name(row.new_row.status)},
          {"bits", row.bits},
          {"turn", name(row.worst())},
          {"quantities", each_of(row.quantities, change_json)}};
}

}  // namespace

Turn RowChange::worst() const {
  return quantities.empty() ? Turn::none
                            : std::ranges::max_element(quantities, {}, &QuantityChange::turn)->turn;
}

bool ResultsChange::worse() const {
  return std::ranges::any_of(rows, [](const RowChange& row) { return row.worst() == Turn::worse; });
}

std::size_t ResultsChange::replicates_needed() const {
  const double chance = level / static_cast<double>(std::max<std::size_t>(tests, 1));
  std::size_t replicates = 1;
  // Of two samples of n values the least chance is 2/C(2n, n), which is 1 for n = 1.
  for (double least = 1; least > chance; ++replicates) {
    const auto n = static_cast<double>(replicates);
    least *= (n + 1) / (2 * (2 * n + 1));
  }
  return replicates;
}

ResultsChange hold_against(const RecordedResults& old_results, const RecordedResults& new_results,
                           const ChangeOptions& options) {
  RowPairs pairs = pair_rows(old_results, new_results, options.across);
  const bool timed = same_processor(old_results, new_results);
  ResultsChange result{
      .rows = each_of(pairs.pairs, [&](const RowPair& pair) { return row_change(pair, options, timed); }),
      .only_old = std::move(pairs.only_old),
      .only_new = std::move(pairs.only_new),
      .other_questions = std::move(pairs.other_questions),
      .other_environment = other_environment(old_results, new_results),
      .level = options.level};
  judge_all(result);
  return result;
}

Json changes_json(const ResultsChange& result) {
  Json json{{"worse", result.worse()},
            {"level", result.level},
            {"tests", result.tests},
            {"tests_counted", result.counted},
            {"only_old", result.only_old},
            {"only_new", result.only_new},
            {"other_questions", result.other_questions},
            {"other_environment", result.other_environment},
            {"rows", each_of(result.rows, row_json)}};
  for (const ReportedQuantity& quantity : reported_quantities())
    json["definitions"][quantity.name] = quantity.definition;
  return json;
}

std::string changes_csv(const ResultsChange& result) {
  CsvWriter csv;
  csv.line("scene", "engine", "solver", "dt", "old_settings", "new_settings", "old_run", "new_run", "bits",
           "quantity", "turn", "old_lower", "old_median", "old_upper", "old_values", "new_lower",
           "new_median", "new_upper", "new_values", "superiority", "p_value", "adjusted_p_value");
  for (const RowChange& row : result.rows) {
    for (const QuantityChange& change : row.quantities) {
      csv.add(row.old_row.scene, row.old_row.engine, row.old_row.solver, row.old_row.dt, row.old_row.settings,
              row.new_row.settings, row.old_row.run, row.new_row.run, row.bits, change.quantity,
              name(change.turn));
      for (const ValueSpread& spread : {change.old_values, change.new_values})
        csv.add(spread.lower, spread.median, spread.upper, spread.values);
      if (change.test)
        csv.line(change.test->superiority, change.test->p_value, change.adjusted_p_value);
      else
        csv.line("", "", "");
    }
  }
  return csv.text();
}

double TurnedNumber::ratio() const {
  const double before = change->old_values.median, now = change->new_values.median;
  if (before == now) return 1;
  return before == 0 ? std::numeric_limits<double>::infinity() : now / before;
}

std::vector<TurnedNumber> turned_numbers(const ResultsChange& result) {
  std::vector<TurnedNumber> turned;
  for (const RowChange& row : result.rows)
    for (const QuantityChange& change : row.quantities)
      if (change.turn != Turn::none) turned.push_back({&row, &change});
  std::ranges::stable_sort(turned, std::greater{}, [](const TurnedNumber& number) {
    return std::tuple(number.change->turn, std::abs(std::log(std::abs(number.ratio()))));
  });
  return turned;
}

ValueSpread cost_ratio(const ResultsChange& result) {
  std::vector<double> ratios;
  for (const RowChange& row : result.rows)
    for (const QuantityChange& change : row.quantities)
      if (change.quantity == "step_time" && row.old_row.steps)
        ratios.push_back(change.new_values.median / change.old_values.median);
  if (ratios.empty()) return {};
  return {quantile(ratios, 0), median(ratios), quantile(ratios, 1), ratios.size()};
}

}  // namespace rockstack
