#include "comparisons/measures/metrics/contact/validity.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

namespace rockstack {
namespace {

using Json = nlohmann::ordered_json;

Json finite(double value) {
  return std::isfinite(value) ? Json(value) : Json();
}

Json demand_json(const Demand& demand) {
  return {{"least_normal", finite(demand.least_normal)},
          {"least_normal_time", demand.least_normal_time},
          {"friction", finite(demand.friction)},
          {"friction_time", demand.friction_time},
          {"first_pull_time", finite(demand.first_pull_time)},
          {"first_slip_time", finite(demand.first_slip_time)}};
}

void add_warnings(const Scene& scene, const std::vector<Demand>& demands, const char* what, const char* unit,
                  std::vector<std::string>& lines) {
  const std::vector<double> friction = friction_of(scene);
  for (std::size_t k = 0; k < demands.size(); ++k) {
    const Demand& demand = demands[k];
    if (demand.least_normal < 0) {
      lines.push_back(fmt::format(
          "interface {} would have to pull, normal {} {:.4g} {} at t = {:.6g} s: blocks would lift off, "
          "first at t = {:.6g} s",
          k + 1, what, demand.least_normal, unit, demand.least_normal_time, demand.first_pull_time));
    } else if (demand.friction > friction[k]) {
      lines.push_back(fmt::format(
          "interface {} needs friction {:.4g} for the {} at t = {:.6g} s, the scene has {}: "
          "blocks would slip, first at t = {:.6g} s",
          k + 1, demand.friction, what, demand.friction_time, friction[k], demand.first_slip_time));
    }
  }
}

/// Where theory has no single answer.
void add_open_questions(const History& history, std::vector<std::string>& lines) {
  for (const Event& event : history.events) {
    if (event.consistency == Consistency::several) {
      lines.push_back(
          fmt::format("at t = {:.6g} s several motions obey the laws of contact: {} follows. What sticks "
                      "goes on to stick "
                      "if it can; corner on corner, a slip is judged by the face that it meets",
                      event.time, name(event.to)));
    } else if (event.consistency == Consistency::none) {
      lines.push_back(fmt::format(
          "at t = {:.6g} s no finite forces let the motion go on (Painlevé): an impulse stops interface {}, "
          "as in the limit of time steps",
          event.time, event.interface));
    }
  }
}

}  // namespace

Json validity_json(const History& history) {
  Json list = Json::array();
  for (std::size_t k = 0; k < history.forces.size(); ++k) {
    list.push_back({{"interface", k + 1},
                    {"forces", demand_json(history.forces[k])},
                    {"impulses", demand_json(history.impulses[k])}});
  }
  return list;
}

std::vector<std::string> validity_warnings(const Scene& scene, const History& history) {
  std::vector<std::string> lines;
  if (leaves_pivots(scene.law)) {
    add_open_questions(history, lines);
  } else {
    add_warnings(scene, history.forces, "force", "N", lines);
    add_warnings(scene, history.impulses, "impulse", "N s", lines);
  }
  for (const auto& choice : history.choices) {
    lines.push_back(
        fmt::format("interface {} opens under tension at t = {:.6g} s, where either side would do: it took "
                    "one of two motions",
                    choice.interface, choice.time));
  }
  for (const auto& graze : history.grazes) {
    lines.push_back(
        fmt::format("interface {} grazes at t = {:.6g} s: rounding decides whether there is an {}",
                    graze.interface, graze.time, name(graze.kind)));
  }
  return lines;
}

}  // namespace rockstack
