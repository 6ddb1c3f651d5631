#pragma once

#include "analytic/scene/history.hpp"
#include "analytic/scene/lists.hpp"

namespace rockstack {

template <class Real>
double in_double(const Real& number) {
  return static_cast<double>(number);
}

template <class Real>
Demand in_double(const BasicDemand<Real>& demand) {
  return {in_double(demand.least_normal),    in_double(demand.least_normal_time),
          in_double(demand.friction),        in_double(demand.friction_time),
          in_double(demand.first_pull_time), in_double(demand.first_slip_time)};
}

template <class Real>
Reaction in_double(const BasicReaction<Real>& reaction) {
  return {in_double(reaction.normal), in_double(reaction.tangential), in_double(reaction.centre)};
}

template <class Real>
SpringEnergy in_double(const BasicSpringEnergy<Real>& energy) {
  return {in_double(energy.elastic), in_double(energy.damped), in_double(energy.rubbed)};
}

template <class Real>
std::optional<double> in_double(const std::optional<Real>& number) {
  return number ? std::optional(in_double(*number)) : std::nullopt;
}

template <class Real>
BasicGraze<double> in_double(const BasicGraze<Real>& graze) {
  return {in_double(graze.time), graze.kind, graze.interface};
}

/// Each of a list.
template <class Wide>
auto in_double(const std::vector<Wide>& values) {
  return mapped(values, [](const Wide& value) { return in_double(value); });
}

inline History to_double(History history) {
  return history;
}

/// A history in double precision. What is ordered or equal stays so.
template <class Real>
History to_double(const BasicHistory<Real>& history) {
  History result;
  result.blocks = history.blocks;
  result.times = in_double(history.times);
  result.angles = in_double(history.angles);
  result.velocities = in_double(history.velocities);
  result.patterns = history.patterns;
  result.events.reserve(history.events.size());
  for (const BasicEvent<Real>& event : history.events)
    result.events.push_back({in_double(event.time), event.kind, event.interface, event.from, event.to,
                             in_double(event.angles), in_double(event.before), in_double(event.after),
                             event.consistency, event.count, in_double(event.approach),
                             in_double(event.centres)});
  result.grazes = in_double(history.grazes);
  result.choices = in_double(history.choices);
  result.slips = in_double(history.slips);
  result.gaps = in_double(history.gaps);
  result.centres = in_double(history.centres);
  result.centre_velocities = in_double(history.centre_velocities);
  result.reactions = in_double(history.reactions);
  result.spring_energies = in_double(history.spring_energies);
  result.peaks = in_double(history.peaks);
  result.uplifts = in_double(history.uplifts);
  result.slips_left = in_double(history.slips_left);
  result.largest_slips = in_double(history.largest_slips);
  result.lifts = in_double(history.lifts);
  result.forces = in_double(history.forces);
  result.impulses = in_double(history.impulses);
  return result;
}

}  // namespace rockstack
