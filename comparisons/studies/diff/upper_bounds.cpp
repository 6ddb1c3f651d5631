#include "comparisons/studies/diff/upper_bounds.hpp"

#include <fmt/format.h>

#include <charconv>

#include "analytic/scene/lists.hpp"
#include "analytic/scene/messages/input_error.hpp"
#include "analytic/scene/messages/one_line.hpp"
#include "comparisons/measures/verdict/verdict.hpp"

namespace rockstack {
namespace {

using Units = std::vector<std::pair<std::string, double>>;

/// Units in which a value may be given, by a quantity's own; a count has none.
Units units_of(const std::string& unit) {
  if (unit.empty()) return {{"", 1}};
  Units units;
  for (std::size_t begin = 0; begin < unit.size();) {
    const std::size_t end = std::min(unit.find(" or ", begin), unit.size());
    const std::string own = unit.substr(begin, end - begin);
    if (own == "%")
      units.emplace_back("%", 1e-2);
    else
      units.insert(units.end(), {{"m" + own, 1e-3}, {own, 1}});
    begin = end + 4;
  }
  return units;
}

/// The name of a quantity in an option.
std::string option_name(const ReportedQuantity& quantity) {
  std::string name = quantity.words;
  std::ranges::replace(name, ' ', '-');
  return name;
}

bool can_be_bounded(const ReportedQuantity& quantity) {
  using Better = ReportedQuantity::Better;
  return quantity.better == Better::less || quantity.better == Better::nearer_zero;
}

const ReportedQuantity& bounded_quantity(const std::string& name) {
  std::vector<std::string> names;
  for (const ReportedQuantity& quantity : reported_quantities()) {
    if (!can_be_bounded(quantity)) continue;
    if (name == option_name(quantity) || name == quantity.name) return quantity;
    names.push_back(option_name(quantity));
  }
  throw InputError(fmt::format("--fail-above {}: must be one of {}{}", one_line(name), fmt::join(names, ", "),
                               did_you_mean(name, names)));
}

}  // namespace

UpperBound read_upper_bound(const std::string& text) {
  const std::size_t sign = text.find('=');
  if (sign == std::string::npos)
    throw InputError(
        fmt::format("--fail-above {}: must be QUANTITY=VALUE, as angles=10mrad", one_line(text)));
  const ReportedQuantity& quantity = bounded_quantity(text.substr(0, sign));
  const std::string given = text.substr(sign + 1);
  double value = 0;
  const auto [end, error] = std::from_chars(given.data(), given.data() + given.size(), value);
  const Units units = units_of(quantity.unit);
  const std::string unit(end, given.data() + given.size());
  const auto factor = std::ranges::find(units, unit, &Units::value_type::first);
  if (error != std::errc() || !std::isfinite(value) || value < 0 || factor == units.end())
    throw InputError(fmt::format(
        "--fail-above {}: must be a number ≥ 0 {}", one_line(text),
        quantity.unit.empty()
            ? "without a unit"
            : fmt::format("in {}, as {}=10{}", fmt::join(mapped(units, &Units::value_type::first), ", "),
                          option_name(quantity), units.front().first)));
  return {&quantity, value * factor->second};
}

std::string BoundedRow::text() const {
  const ReportedQuantity& quantity = *bound->quantity;
  if (!median) return fmt::format("has no {}, as it is not done: {}", quantity.words, run->row.reason);
  return fmt::format("{}: {}, {} {}", quantity.words, quantity.text(*median), above() ? "above" : "within",
                     quantity.text(bound->value));
}

std::vector<BoundedRow> bounded_rows(const std::vector<UpperBound>& bounds, const RecordedResults& results) {
  std::vector<BoundedRow> rows;
  for (const UpperBound& bound : bounds) {
    const std::size_t before = rows.size();
    for (const RecordedRun& run : results.runs) {
      if (!is_engine(run.row)) continue;
      const std::vector<double> values = values_of(*bound.quantity, run);
      if (!values.empty())
        rows.push_back({&run, &bound, median(values)});
      else if (run.row.status != RunStatus::done)
        rows.push_back({&run, &bound, {}});
    }
    if (rows.size() == before)
      throw InputError(fmt::format("--fail-above {}: no row of {} has it", option_name(*bound.quantity),
                                   results.folder.string()));
  }
  return rows;
}

}  // namespace rockstack
