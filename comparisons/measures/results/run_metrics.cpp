#include "comparisons/measures/results/run_metrics.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <type_traits>

namespace rockstack {
namespace {

/// In the order of RunStatus.
constexpr std::array<const char*, 6> status_names{"done",   "failed",     "not finite",
                                                  "signal", "time limit", "memory limit"};

template <class Value>
Json json_of(const std::optional<Value>& value) {
  return value ? Json(*value) : Json();
}

Json json_of(const std::string& value) {
  return value;
}

template <class Enumeration>
requires std::is_enum_v<Enumeration> Json json_of(Enumeration value) {
  return name(value);
}

void read_cell(const Json& cell, std::optional<double>& value) {
  if (!cell.is_null()) value = cell.get<double>();
}

/// Counts stay whole: a median half way between two is rounded up.
void read_cell(const Json& cell, std::optional<int>& value) {
  if (!cell.is_null()) value = static_cast<int>(std::lround(cell.get<double>()));
}

void read_cell(const Json& cell, std::string& value) {
  value = cell.get<std::string>();
}

void read_cell(const Json& cell, RunStatus& value) {
  value = run_status(cell.get<std::string>());
}

void read_cell(const Json& cell, TopplingVerdict& value) {
  value = named_verdict(cell.get<std::string>());
}

void put(RunMetrics& row, const Column::Field& field, const Json& cell) {
  std::visit([&](auto member) { read_cell(cell, row.*member); }, field);
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
  put(row, field, cell);
}

void Column::set_quartiles(RunMetrics& row, const Json& low, const Json& high) const {
  if (lower) put(row, *lower, low);
  if (upper) put(row, *upper, high);
}

void to_json(Json& cells, const RunMetrics& row) {
  for (const Column& one : columns()) cells[one.name] = one.cell(row);
}

void from_json(const Json& cells, RunMetrics& row) {
  for (const Column& one : columns())
    if (cells.contains(one.name)) one.set(row, cells.at(one.name));
}

}  // namespace rockstack
