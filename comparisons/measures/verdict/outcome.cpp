#include "comparisons/measures/verdict/verdict.hpp"

#include <fmt/format.h>

#include "analytic/scene/messages/number_text.hpp"

namespace rockstack {
namespace {

std::string at_rest(const RunMetrics& row, const JudgedScene& scene, const std::string& event) {
  const bool turns = row.largest_angle_difference.value_or(0) > scene.tolerance;
  const bool sinks = event.starts_with("sinks");
  if (!event.empty() && !(sinks && !turns)) return event;
  if (sinks) return "rests, but " + event;
  if (row.gap.value_or(0) > scene.tolerance * scene.least_height)
    return "does not rest: rises by " + quantity_text(*row.gap, "m", 2);
  const std::string off = quantity_text(row.largest_position_difference.value_or(0), "m", 2) + " off";
  if (turns)
    return fmt::format("does not rest: {} and {}", quantity_text(*row.largest_angle_difference, "rad", 2),
                       off);
  return agrees(row, scene) ? "rests" : "rests, but is " + off;
}

}  // namespace

std::string with_verb(const std::string& block_and_time, const std::string& verb) {
  const std::size_t at = block_and_time.find(" at ");
  const double time = std::stod(block_and_time.substr(at + 4));
  return block_and_time.substr(0, at) + " " + verb + " at " + quantity_text(time, "s");
}

bool is_engine(const RunMetrics& row) {
  return row.dt && !row.settings.empty() && row.settings != "baseline";
}

std::string set_name(const std::string& engine, const std::string& solver, const std::string& settings) {
  return fmt::format("{}:{} ({})", engine, solver, settings);
}

bool agrees(const RunMetrics& row, const JudgedScene& scene) {
  return row.largest_angle_difference.value_or(0) <= scene.tolerance &&
         row.relative_position_difference.value_or(0) <= scene.tolerance;
}

double agreement_end(const RunMetrics& row, const JudgedScene& scene) {
  const double horizon = row.horizon.value_or(scene.duration);
  if (agrees(row, scene)) return horizon;
  return std::min(
      {horizon, row.agreement_time.value_or(horizon), row.position_agreement_time.value_or(horizon)});
}

std::string outcome(const RunMetrics& row, const JudgedScene& scene) {
  if (row.status != RunStatus::done) return name(row.status) + ": " + row.reason;
  if (!row.error) return "";
  const std::string event = event_of(row, scene);
  if (row.motion && *row.motion <= rest_extent) return at_rest(row, scene, event);
  const double horizon = row.horizon.value_or(scene.duration);
  const std::string until = !agrees(row, scene) ? "until " + quantity_text(agreement_end(row, scene), "s")
                            : horizon < scene.duration ? "to the horizon"
                                                       : "to the end";
  return "agrees " + until + (event.empty() ? "" : "; " + event);
}

}  // namespace rockstack
