#pragma once

#include "analytic/solver/to_double.hpp"
#include "analytic/unilateral/solve_contacts.hpp"

namespace rockstack {

/// One letter an interface from the ground up, L, C or R, and "-" where it is apart; an arrow after it shows
/// the way that the block above slides.
template <class Real>
std::string name(const Joints<Real>& joints) {
  std::string text;
  for (const Joint<Real>& joint : joints) {
    text += joint.touch == Contact::apart ? '-' : "LCR"[static_cast<int>(joint.touch) + 1];
    if (joint.touches() && joint.slip != 0) text += joint.slip > 0 ? '>' : '<';
  }
  return text;
}

template <class Real>
Poses<double> in_double(const Poses<Real>& poses) {
  Poses<double> result;
  for (const Pose<Real>& pose : poses)
    result.push_back(
        {static_cast<double>(pose.x), static_cast<double>(pose.y), static_cast<double>(pose.angle)});
  return result;
}

template <class Real>
Bodies<> in_double(const Bodies<Real>& bodies) {
  return {in_double(bodies.at), in_double(bodies.rate)};
}

template <class Real>
Joints<double> in_double(const Joints<Real>& joints) {
  Joints<double> result;
  for (const Joint<Real>& joint : joints)
    result.push_back(
        {joint.touch, joint.slip, joint.corner_below, joint.settled, static_cast<double>(joint.offset)});
  return result;
}

template <class Real>
std::vector<SpringState<double>> in_double(const std::vector<SpringState<Real>>& states) {
  const auto number = [](const Real& value) { return static_cast<double>(value); };
  std::vector<SpringState<double>> result;
  for (const auto& [reaction, energy] : states)
    result.push_back({{number(reaction.normal), number(reaction.tangential), number(reaction.centre)},
                      {number(energy.elastic), number(energy.damped), number(energy.rubbed)}});
  return result;
}

/// A motion in double precision. What is ordered or equal stays so.
template <class Real>
ContactHistory<> in_double(const ContactHistory<Real>& history) {
  ContactHistory<> result;
  result.samples.reserve(history.samples.size());
  for (const ContactSample<Real>& sample : history.samples)
    result.samples.push_back({static_cast<double>(sample.time), in_double(sample.bodies),
                              in_double(sample.joints), in_double(sample.slips), in_double(sample.gaps),
                              in_double(sample.springs),
                              sample.spring_accelerations.template cast<double>()});
  result.events.reserve(history.events.size());
  for (const ContactEvent<Real>& event : history.events)
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

/// The motion of solve_contacts(), in double or, where that does not do, in long double. @throws likewise.
inline ContactHistory<> solve_unilateral(const Scene& scene, const SolveOptions& options = {}) {
  validate(scene);
  validate(options);
  if (double_does(scene)) return solve_contacts<double>(scene, options);
  try {
    return in_double(solve_contacts<long double>(scene, options));
  } catch (const UnfinishedContacts<long double>& unfinished) {
    throw UnfinishedContacts(unfinished.what(), in_double(unfinished.history));
  }
}

/// Kinetic energy and that of weight, J, in the frame of the ground, from the middle of its interface.
inline double energy(const Scene& scene, const Bodies<>& bodies) {
  const Gravity gravity = gravity_of(scene);
  double sum = 0;
  for (std::size_t k = 0; k < scene.blocks.size(); ++k) {
    const Block& block = scene.blocks[k];
    const Pose<>& rate = bodies.rate[k];
    sum += block.mass * (rate.x * rate.x + rate.y * rate.y) / 2 +
           block.inertia * rate.angle * rate.angle / 2 +
           block.mass * (gravity.across * bodies.at[k].y - gravity.along * bodies.at[k].x);
  }
  return sum;
}

}  // namespace rockstack
