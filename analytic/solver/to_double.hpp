#pragma once

#include "analytic/scene/history.hpp"

namespace rockstack {

/// A history in double precision. What is ordered or equal stays so.
template <class Real>
History to_double(const BasicHistory<Real>& history) {
  const auto list = [](const std::vector<Real>& values) {
    return std::vector<double>(values.begin(), values.end());
  };
  const auto number = [](const Real& value) { return static_cast<double>(value); };
  const auto demands = [&](const std::vector<BasicDemand<Real>>& values) {
    std::vector<Demand> result;
    result.reserve(values.size());
    for (const BasicDemand<Real>& value : values) {
      result.push_back({number(value.least_normal), number(value.least_normal_time), number(value.friction),
                        number(value.friction_time), number(value.first_pull_time),
                        number(value.first_slip_time)});
    }
    return result;
  };
  History result;
  result.blocks = history.blocks;
  result.times = list(history.times);
  result.angles = list(history.angles);
  result.velocities = list(history.velocities);
  result.patterns = history.patterns;
  for (const BasicEvent<Real>& event : history.events) {
    result.events.push_back({number(event.time), event.kind, event.interface, event.from, event.to,
                             list(event.angles), list(event.before), list(event.after), event.consistency});
  }
  for (const BasicGraze<Real>& graze : history.grazes)
    result.grazes.push_back({number(graze.time), graze.kind, graze.interface});
  for (const BasicGraze<Real>& choice : history.choices)
    result.choices.push_back({number(choice.time), choice.kind, choice.interface});
  result.peaks = list(history.peaks);
  result.forces = demands(history.forces);
  result.impulses = demands(history.impulses);
  return result;
}

}  // namespace rockstack
