#include "comparisons/studies/diff/changes.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <tuple>

#include "analytic/scene/lists.hpp"
#include "comparisons/measures/results/csv.hpp"
#include "comparisons/measures/results/sentences.hpp"
#include "comparisons/measures/verdict/verdict.hpp"

namespace rockstack {
namespace {

std::vector<const RowChange*> sets_and_rows(const ResultsChange& result) {
  std::vector<const RowChange*> all;
  for (const std::vector<RowChange>* rows : {&result.sets, &result.rows})
    for (const RowChange& row : *rows) all.push_back(&row);
  return all;
}

Json spread_json(const ValueSpread& spread) {
  return {
      {"lower", spread.lower}, {"median", spread.median}, {"upper", spread.upper}, {"values", spread.values}};
}

Json change_json(const QuantityChange& change) {
  Json json{{"quantity", change.quantity},
            {"turn", name(change.trend)},
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
          {"quantities", mapped(row.quantities, change_json)}};
}

/// What leaves a result undecided, in words.
std::vector<std::string> open_points(const ResultsChange& result) {
  std::vector<std::string> points;
  const auto add = [&](const std::vector<std::string>& names, const std::string& words) {
    if (!names.empty()) points.push_back(words);
  };
  const std::string would_do = fmt::format("{} replicates in every row would do", result.replicates_needed);
  if (!result.judges_engines()) points.push_back("no row of an engine is in both, and nothing was judged");
  add(result.in_doubt, fmt::format("so few replicates do not decide what looks worse ({}): {}",
                                   joined_up_to(3, result.in_doubt), would_do));
  add(result.more_failures,
      fmt::format("more replicates fail or topple otherwise ({})", joined_up_to(3, result.more_failures)));
  add(result.undecided, fmt::format("of {} of {} nothing can be said: {}", result.undecided.size(),
                                    rockstack::counted(result.rows.size(), "row"), would_do));
  const auto no_more = result.judged_no_more();
  add(no_more, fmt::format("what was judged before is judged no more ({})", joined_up_to(3, no_more)));
  return points;
}

/// The change of each number that a headline tells, in their order, in the row where it has grown the most;
/// of none of these that which is worse by the largest factor.
std::vector<const QuantityChange*> headline_numbers(const ResultsChange& result) {
  std::vector<TurnedNumber> worse = turned_numbers(result);
  std::erase_if(worse, [](const TurnedNumber& number) { return number.change->trend != Trend::worse; });
  std::vector<const QuantityChange*> numbers;
  for (const ReportedQuantity& quantity : reported_quantities()) {
    const auto growth = [&](const TurnedNumber& number) {
      const QuantityChange& change = *number.change;
      return change.quantity == quantity.name ? change.new_values.median - change.old_values.median
                                              : -HUGE_VAL;
    };
    const TurnedNumber& most = *std::ranges::max_element(worse, {}, growth);
    if (quantity.told && most.change->quantity == quantity.name) numbers.push_back(most.change);
  }
  if (numbers.empty()) numbers.push_back(worse.front().change);
  return numbers;
}

/// "angles 5 → 49 mrad, first impact −4.9 → −67 ms; 2 of 2 rows worse; a step costs 1.02 times as much".
std::string what_is_worse(const ResultsChange& result) {
  const auto told = [](const QuantityChange* change) {
    return quantity_named(change->quantity).words + " " + change_text(*change);
  };
  std::size_t all = 0, worse = 0;  // rows of engines
  for (const RowChange& row : result.rows) {
    all += is_engine(row.old_row) ? 1 : 0;
    worse += row.worst() == Trend::worse ? 1 : 0;
  }
  const ValueSpread cost = cost_ratio(result);
  const std::string where =
      worse > 0 ? fmt::format("{} of {} worse", worse, counted(all, "row")) : "over all rows together";
  return fmt::format("{}; {}{}", joined_texts(headline_numbers(result), told, ", "), where,
                     cost.values > 0 ? fmt::format("; a step costs {:.2g} times as much", cost.median) : "");
}

}  // namespace

std::string change_text(const QuantityChange& change) {
  const ReportedQuantity& quantity = quantity_named(change.quantity);
  const auto text = [&](double value) {
    std::string words = quantity.text(value);
    if (words.starts_with('-')) words.replace(0, 1, "−");
    return words;
  };
  std::string before = text(change.old_values.signed_median);
  const std::string now = text(change.new_values.signed_median);
  const auto unit_of = [](const std::string& words) {
    return words.find(' ') == std::string::npos ? "" : words.substr(words.find(' '));
  };
  if (unit_of(before) == unit_of(now)) before = before.substr(0, before.find(' '));
  return before + " → " + now;
}

std::string ResultsChange::headline() const {
  const std::vector<std::string> open = open_points(*this);
  const std::string unknown = fmt::format("{}", fmt::join(open, "; "));
  if (!worse())
    return open.empty() ? "Nothing is worse."
                        : "Undecided: nothing is shown to be worse, but " + unknown + ".";
  std::vector<std::string> sets;
  for (const auto& [row, change] : turned_numbers(*this)) {
    const std::string name = set_name(row->new_row);
    if (change->trend == Trend::worse && std::ranges::find(sets, name) == sets.end()) sets.push_back(name);
  }
  return fmt::format("Worse: {}: {}{}.", joined_up_to(3, sets), what_is_worse(*this),
                     open.empty() ? "" : "; " + unknown);
}

Json changes_json(const ResultsChange& result) {
  Json json{{"headline", result.headline()},
            {"worse", result.worse()},
            {"decided", result.decided()},
            {"undecided", result.undecided},
            {"in_doubt", result.in_doubt},
            {"more_failures", result.more_failures},
            {"level", result.level},
            {"tests", result.tests},
            {"tests_counted", result.counted},
            {"only_old", result.only_old},
            {"only_new", result.only_new},
            {"other_questions", result.other_questions},
            {"other_environment", result.other_environment},
            {"rows", mapped(result.rows, row_json)},
            {"sets", mapped(result.sets, row_json)}};
  for (const ReportedQuantity& quantity : reported_quantities())
    json["definitions"][quantity.name] = quantity.definition;
  return json;
}

std::string changes_csv(const ResultsChange& result) {
  CsvWriter csv;
  csv.line("scene", "engine", "solver", "dt", "old_settings", "new_settings", "old_run", "new_run", "bits",
           "quantity", "turn", "old_lower", "old_median", "old_upper", "old_values", "new_lower",
           "new_median", "new_upper", "new_values", "superiority", "p_value", "adjusted_p_value");
  for (const RowChange* row : sets_and_rows(result)) {
    for (const QuantityChange& change : row->quantities) {
      const RunMetrics &before = row->old_row, &now = row->new_row;
      csv.add(before.scene, before.engine, before.solver, before.dt, before.settings, now.settings,
              before.run, now.run, row->bits, change.quantity, name(change.trend));
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
  for (const RowChange* row : sets_and_rows(result))
    for (const QuantityChange& change : row->quantities)
      if (change.trend != Trend::none) turned.push_back({row, &change});
  std::ranges::stable_sort(turned, std::greater{}, [](const TurnedNumber& number) {
    return std::tuple(number.change->trend, std::abs(std::log(std::abs(number.ratio()))));
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
