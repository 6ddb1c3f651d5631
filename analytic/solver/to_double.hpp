#pragma once

#include "analytic/scene/history.hpp"

namespace rockstack {

template <class Real>
std::vector<double> in_double(const std::vector<Real>& values) {
  std::vector<double> result;
  result.reserve(values.size());
  for (const Real& value : values) result.push_back(static_cast<double>(value));
  return result;
}

template <class Real>
std::vector<Demand> in_double(const std::vector<BasicDemand<Real>>& demands) {
  const auto number = [](const Real& value) { return static_cast<double>(value); };
  std::vector<Demand> result;
  result.reserve(demands.size());
  for (const BasicDemand<Real>& demand : demands)
    result.push_back({number(demand.least_normal), number(demand.least_normal_time), number(demand.friction),
                      number(demand.friction_time), number(demand.first_pull_time),
                      number(demand.first_slip_time)});
  return result;
}

template <class Real>
std::vector<Reaction> in_double(const std::vector<BasicReaction<Real>>& reactions) {
  std::vector<Reaction> result;
  result.reserve(reactions.size());
  for (const BasicReaction<Real>& reaction : reactions)
    result.push_back({static_cast<double>(reaction.normal), static_cast<double>(reaction.tangential),
                      static_cast<double>(reaction.centre)});
  return result;
}

template <class Real>
std::vector<SpringEnergy> in_double(const std::vector<BasicSpringEnergy<Real>>& energies) {
  std::vector<SpringEnergy> result;
  result.reserve(energies.size());
  for (const BasicSpringEnergy<Real>& energy : energies)
    result.push_back({static_cast<double>(energy.elastic), static_cast<double>(energy.damped),
                      static_cast<double>(energy.rubbed)});
  return result;
}

inline History to_double(History history) {
  return history;
}

/// A history in double precision. What is ordered or equal stays so.
template <class Real>
History to_double(const BasicHistory<Real>& history) {
  const auto number = [](const Real& value) { return static_cast<double>(value); };
  History result;
  result.blocks = history.blocks;
  result.times = in_double(history.times);
  result.angles = in_double(history.angles);
  result.velocities = in_double(history.velocities);
  result.patterns = history.patterns;
  result.events.reserve(history.events.size());
  for (const BasicEvent<Real>& event : history.events)
    result.events.push_back({number(event.time), event.kind, event.interface, event.from, event.to,
                             in_double(event.angles), in_double(event.before), in_double(event.after),
                             event.consistency, event.count});
  for (const BasicGraze<Real>& graze : history.grazes)
    result.grazes.push_back({number(graze.time), graze.kind, graze.interface});
  for (const BasicGraze<Real>& choice : history.choices)
    result.choices.push_back({number(choice.time), choice.kind, choice.interface});
  result.slips = in_double(history.slips);
  result.gaps = in_double(history.gaps);
  result.centres = in_double(history.centres);
  result.centre_velocities = in_double(history.centre_velocities);
  result.reactions = in_double(history.reactions);
  result.spring_energies = in_double(history.spring_energies);
  result.peaks = in_double(history.peaks);
  result.slips_left = in_double(history.slips_left);
  result.lifts = in_double(history.lifts);
  result.forces = in_double(history.forces);
  result.impulses = in_double(history.impulses);
  return result;
}

}  // namespace rockstack
