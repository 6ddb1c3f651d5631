#include "comparisons/studies/diff/change_tables.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <tuple>

#include "comparisons/measures/results/csv.hpp"
#include "comparisons/measures/statistics/samples.hpp"

namespace rockstack {
namespace {

using Json = nlohmann::ordered_json;

double ratio_of(double now, double before) {
  if (before == now) return 1;
  return before == 0 ? std::numeric_limits<double>::infinity() : now / before;
}

Json to_json(const ValueSpread& spread) {
  return {
      {"lower", spread.lower}, {"median", spread.median}, {"upper", spread.upper}, {"values", spread.values}};
}

Json to_json(const QuantityChange& change) {
  Json json{{"quantity", change.quantity},
            {"turn", name(change.turn)},
            {"old", to_json(change.old_values)},
            {"new", to_json(change.new_values)}};
  if (change.test) {
    json["superiority"] = change.test->superiority;
    json["p_value"] = change.test->p_value;
    json["adjusted_p_value"] = *change.adjusted_p_value;
  }
  return json;
}

Json to_json(const RowChange& row) {
  Json json{{"scene", row.old_row.scene},
            {"engine", row.old_row.engine},
            {"solver", row.old_row.solver},
            {"settings", row.old_row.settings},
            {"dt", row.old_row.dt ? Json(*row.old_row.dt) : Json()},
            {"old_run", row.old_row.run},
            {"new_run", row.new_row.run},
            {"old_status", name(row.old_row.status)},
            {"new_status", name(row.new_row.status)},
            {"bits", name(row.bits)},
            {"turn", name(row.worst())},
            {"quantities", Json::array()}};
  for (const QuantityChange& change : row.quantities) json["quantities"].push_back(to_json(change));
  return json;
}

}  // namespace

Json changes_json(const ResultsChange& result) {
  Json json{{"worse", result.worse()},
            {"level", result.level},
            {"tests", result.tests},
            {"tests_counted", result.counted},
            {"only_old", result.only_old},
            {"only_new", result.only_new},
            {"other_questions", result.other_questions},
            {"other_environment", result.other_environment},
            {"rows", Json::array()}};
  for (const TellingQuantity& quantity : telling_quantities())
    json["definitions"][quantity.name] = quantity.definition;
  for (const RowChange& row : result.rows) json["rows"].push_back(to_json(row));
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
              row.new_row.settings, row.old_row.run, row.new_row.run, name(row.bits), change.quantity,
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
  return ratio_of(change->new_values.median, change->old_values.median);
}

std::vector<TurnedNumber> turned_numbers(const ResultsChange& result) {
  std::vector<TurnedNumber> turned;
  for (const RowChange& row : result.rows)
    for (const QuantityChange& change : row.quantities)
      if (change.turn != Turn::none) turned.push_back({&row, &change});
  const auto rank = [](const TurnedNumber& number) {
    return std::tuple(number.change->turn, std::abs(std::log(std::abs(number.ratio()))));
  };
  std::stable_sort(turned.begin(), turned.end(),
                   [&](const TurnedNumber& a, const TurnedNumber& b) { return rank(a) > rank(b); });
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
