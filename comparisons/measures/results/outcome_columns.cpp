#include "comparisons/measures/results/outcome_columns.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "comparisons/measures/results/sentences.hpp"
#include "rockstack_measures_texts.hpp"

namespace rockstack {
namespace {

OutcomeColumn::Measure demand(Demand RunOutcome::*of, double Demand::*value) {
  return [of, value](const RunOutcome& outcome) -> std::optional<double> {
    const Demand& demand = outcome.*of;
    if (!std::isfinite(demand.least_normal)) return {};
    return demand.*value;
  };
}

/// Values of blocks, whatever their number; of a motion without them none.
OutcomeColumn::Measure value_of(std::vector<double> RunOutcome::*of, std::size_t block) {
  return [of, block](const RunOutcome& outcome) -> std::optional<double> {
    const std::vector<double>& values = outcome.*of;
    return values.empty() ? std::nullopt : std::optional(values[block]);
  };
}

const std::map<std::string, std::vector<double> RunOutcome::*> values_of_blocks{
    {"peak", &RunOutcome::peaks},
    {"peak_ratio", &RunOutcome::peak_ratios},
    {"force_friction", &RunOutcome::frictions},
    {"slip", &RunOutcome::slips},
    {"lift", &RunOutcome::lifts},
    {"uplift", &RunOutcome::uplifts},
    {"largest_slip", &RunOutcome::largest_slips}};

Json field_of(const OutcomeColumn& column, const RunOutcome& outcome) {
  if (const auto* count = std::get_if<OutcomeColumn::Count>(&column.value)) return (*count)(outcome);
  if (const auto* mode = std::get_if<OutcomeColumn::Mode>(&column.value)) return name(outcome.*(*mode));
  const std::optional<double> value = std::get<OutcomeColumn::Measure>(column.value)(outcome);
  return value && std::isfinite(*value) ? Json(*value) : Json();
}

}  // namespace

std::vector<OutcomeColumn> outcome_columns(std::size_t blocks) {
  using Measure = OutcomeColumn::Measure;
  using Count = OutcomeColumn::Count;
  const std::map<std::string, OutcomeColumn::Value> values{
      {"peak_ratio", Measure(&RunOutcome::peak_ratio)},
      {"toppled", Count(&RunOutcome::toppled)},
      {"topple_time", Measure(&RunOutcome::topple_time)},
      {"falling", Count(&RunOutcome::falling)},
      {"ground_left", Measure(&RunOutcome::ground_left)},
      {"impacts", Count(&RunOutcome::impacts)},
      {"events", Count(&RunOutcome::events)},
      {"last_event_time", Measure(&RunOutcome::last_event_time)},
      {"rest_time", Measure(&RunOutcome::rest_time)},
      {"least_normal_force", demand(&RunOutcome::force, &Demand::least_normal)},
      {"force_friction", demand(&RunOutcome::force, &Demand::friction)},
      {"least_normal_impulse", demand(&RunOutcome::impulse, &Demand::least_normal)},
      {"impulse_friction", demand(&RunOutcome::impulse, &Demand::friction)},
      {"onset", &RunOutcome::onset},
      {"motion", &RunOutcome::motion},
      {"status", {}},
      {"reason", {}},
      {"slip", Measure(&RunOutcome::slip)},
      {"lift", Measure(&RunOutcome::lift)},
      {"uplift", Measure(&RunOutcome::uplift)},
      {"largest_slip", Measure(&RunOutcome::largest_slip)}};
  std::vector<OutcomeColumn> columns;
  for (const Paragraph& column : paragraphs(outcome_columns_txt)) {
    const bool sampled = column.kind.find("sampled") != std::string::npos;
    if (column.kind.find("each") == std::string::npos) {
      columns.push_back({column.name, column.words, values.at(column.name), sampled});
      continue;
    }
    for (std::size_t k = 0; k < blocks; ++k)
      columns.push_back({fmt::format("{}_{}", column.name, k + 1),
                         fmt::format("of block {}: {}", k + 1, column.words),
                         value_of(values_of_blocks.at(column.name), k), sampled});
  }
  return columns;
}

Json outcome_json(const RunOutcome& outcome, bool sampled) {
  Json json = Json::object();
  for (const OutcomeColumn& column : outcome_columns(outcome.peaks.size()))
    if (column.value.index() > 0 && (column.sampled || !sampled))
      json[column.name] = field_of(column, outcome);
  return json;
}

}  // namespace rockstack
