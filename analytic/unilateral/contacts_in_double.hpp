#pragma once

#include "analytic/solver/to_double.hpp"
#include "analytic/unilateral/contact_history.hpp"

namespace rockstack {

template <class Real>
Placements<double> in_double(const Placements<Real>& placements) {
  Placements<double> result;
  result.reserve(placements.size());
  for (const BasicBodyPlacement<Real>& placement : placements)
    result.push_back({static_cast<double>(placement.x), static_cast<double>(placement.y),
                      static_cast<double>(placement.angle)});
  return result;
}

template <class Real>
Bodies in_double(const BasicBodies<Real>& bodies) {
  return {in_double(bodies.at), in_double(bodies.rate)};
}

template <class Real>
Joints<double> in_double(const Joints<Real>& joints) {
  Joints<double> result;
  result.reserve(joints.size());
  for (const BasicJoint<Real>& joint : joints)
    result.push_back({joint.touch, joint.slip, joint.corner_below, static_cast<double>(joint.offset)});
  return result;
}

template <class Real>
std::vector<BasicSpringState<double>> in_double(const std::vector<BasicSpringState<Real>>& states) {
  const auto number = [](const Real& value) { return static_cast<double>(value); };
  std::vector<BasicSpringState<double>> result;
  result.reserve(states.size());
  for (const auto& [reaction, energy] : states)
    result.push_back({{number(reaction.normal), number(reaction.tangential), number(reaction.centre)},
                      {number(energy.elastic), number(energy.damped), number(energy.rubbed)}});
  return result;
}

inline ContactHistory in_double(ContactHistory history) {
  return history;
}

/// A motion in double precision. What is ordered or equal stays so.
template <class Real>
ContactHistory in_double(const BasicContactHistory<Real>& history) {
  ContactHistory result;
  result.samples.reserve(history.samples.size());
  for (const BasicContactSample<Real>& sample : history.samples)
    result.samples.push_back({static_cast<double>(sample.time), in_double(sample.bodies),
                              in_double(sample.joints), in_double(sample.slips), in_double(sample.gaps),
                              in_double(sample.springs),
                              sample.spring_accelerations.template cast<double>()});
  result.events.reserve(history.events.size());
  for (const BasicContactEvent<Real>& event : history.events)
    result.events.push_back({static_cast<double>(event.time), event.kind, event.interface,
                             in_double(event.from), in_double(event.to), in_double(event.at),
                             in_double(event.before), in_double(event.after), event.consistency});
  result.peaks = in_double(history.peaks);
  result.slips_left = in_double(history.slips_left);
  result.lifts = in_double(history.lifts);
  result.forces = in_double(history.forces);
  result.impulses = in_double(history.impulses);
  result.last = in_double(history.last);
  result.end_time = static_cast<double>(history.end_time);
  return result;
}

}  // namespace rockstack
