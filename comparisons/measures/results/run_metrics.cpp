#include "comparisons/measures/results/run_metrics.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <type_traits>

#include "comparisons/measures/results/sentences.hpp"
#include "rockstack_measures_texts.hpp"

namespace rockstack {
namespace {

/// In the order of RunStatus.
constexpr std::array<const char*, 6> status_names{"done",   "failed",     "not finite",
                                                  "signal", "time limit", "memory limit"};

template <class Value>
Json json_of(const Value& value) {
  if constexpr (std::is_enum_v<Value>)
    return name(value);
  else if constexpr (std::is_same_v<Value, std::string>)
    return value;
  else
    return value ? Json(*value) : Json();
}

/// Counts stay whole: a median half way between two is rounded up.
template <class Value>
void read_cell(const Json& cell, Value& value) {
  if constexpr (std::is_same_v<Value, RunStatus>)
    value = run_status(cell.get<std::string>());
  else if constexpr (std::is_same_v<Value, TopplingVerdict>)
    value = named_verdict(cell.get<std::string>());
  else if constexpr (std::is_same_v<Value, std::string>)
    value = cell.get<std::string>();
  else if (cell.is_null())
    return;
  else if constexpr (std::is_same_v<Value, std::optional<int>>)
    value = static_cast<int>(std::lround(cell.get<double>()));
  else
    value = cell.get<double>();
}

/// Those of quartiles stand behind the one that they are of.
std::vector<Column> all_columns() {
  const std::map<std::string, Column::Field> fields{
#include "comparisons/measures/results/run_metrics_fields.inc"
  };
  std::vector<Column> all;
  for (const auto& [name, kind, meaning] : paragraphs(columns_txt)) {
    const auto is = [&kind = kind](const char* word) { return kind.find(word) != std::string::npos; };
    all.push_back(
        {name, meaning, fields.at(name), is("measured"), is("median"), is("quartiles"), is("any motion")});
    if (!is("quartiles")) continue;
    all.push_back(
        {name + "_lower", "lower quartile of the same over replicates", fields.at(name + "_lower")});
    all.push_back({name + "_upper", "upper quartile", fields.at(name + "_upper")});
  }
  return all;
}

}  // namespace

std::string name(RunStatus status) {
  return status_names.at(static_cast<std::size_t>(status));
}

RunStatus run_status(const std::string& name) {
  const auto found = std::ranges::find(status_names, name);
  if (found == status_names.end()) throw std::invalid_argument(fmt::format("{}: no status of a run", name));
  return static_cast<RunStatus>(found - status_names.begin());
}

Json Column::cell(const RunMetrics& row) const {
  return std::visit([&](auto member) { return json_of(row.*member); }, field);
}

void Column::set(RunMetrics& row, const Json& cell) const {
  std::visit([&](auto member) { read_cell(cell, row.*member); }, field);
}

const std::vector<Column>& columns() {
  static const std::vector<Column> list = all_columns();
  return list;
}

const Column& column_named(const std::string& name) {
  const auto found = std::ranges::find(columns(), name, &Column::name);
  if (found == columns().end()) throw std::logic_error(name + ": no column of a comparison");
  return *found;
}

void to_json(Json& cells, const RunMetrics& row) {
  for (const Column& one : columns()) cells[one.name] = one.cell(row);
}

void from_json(const Json& cells, RunMetrics& row) {
  for (const Column& one : columns())
    if (cells.contains(one.name)) one.set(row, cells.at(one.name));
}

Json motion_cells(const RunMetrics& row) {
  Json cells = Json::object();
  for (const Column& one : columns())
    if (one.any_motion) cells[one.name] = one.cell(row);
  return cells;
}

RunMetrics motion_row(const Json& cells) {
  RunMetrics row;
  for (const Column& one : columns())
    if (one.any_motion && cells.contains(one.name)) one.set(row, cells.at(one.name));
  return row;
}

}  // namespace rockstack
