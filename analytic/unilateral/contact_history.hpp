#pragma once

#include "analytic/scene/lists.hpp"
#include "analytic/unilateral/contact/contact_problem.hpp"
#include "analytic/unilateral/springs/spring_series.hpp"

namespace rockstack {

/// One event with the motion on both sides of it. `interface` counts from 1; of topple it is the block.
template <class Real = double>
struct ContactEvent {
  Real time = 0;  ///< s
  EventKind kind{};
  int interface = 0;
  Joints<Real> from, to;
  Poses<Real> at, before, after;  ///< poses, and their rates
  /// What theory has to say: one motion; several, of which the one named by find_mode() follows; or none
  /// without an impulse, of which the limit of Moreau's time steps follows.
  Consistency consistency = Consistency::consistent;
  std::optional<Real> approach = {};  ///< as BasicEvent::approach
};

/// The motion at one time.
template <class Real>
struct ContactSample {
  Real time = 0;  ///< s
  Bodies<Real> bodies;
  Joints<Real> joints;
  std::vector<Real> slips = {}, gaps = {};  ///< of interfaces, m; where apart, the slip that they parted with
  // State of stacks with springs, else empty.
  std::vector<SpringState<Real>> springs = {};  ///< of each interface
  FreeVector<Real> spring_accelerations = {};   ///< what all springs make of the motion
};

/// A stack's motion under a law that leaves pivots.
template <class Real = double>
struct ContactHistory {
  using Sample = ContactSample<Real>;
  std::vector<Sample> samples;
  std::vector<ContactEvent<Real>> events;
  std::vector<Real> peaks;  ///< largest |θ| of each block at any time, rad; empty unless asked for
  /// Slips of interfaces at the end, and their largest finite gaps, m; empty unless asked for.
  std::vector<Real> slips_left, lifts;
  /// What acts at each interface, of the motion and of impacts; empty unless asked for. A least normal force
  /// of zero is that of blocks that part; nothing pulls, and nothing rubs more than its friction, so that
  /// first times are infinite. Of impulses that of chatter, less than a millionth of a fall's, is not told.
  std::vector<BasicDemand<Real>> forces, impulses;
  Bodies<Real> last;  ///< at the end
  Real end_time{};    ///< s
};

template <class Real>
Pattern pattern_of(const Joints<Real>& joints) {
  Pattern pattern = closed_pattern(static_cast<int>(joints.size()));
  for (std::size_t k = 0; k < joints.size(); ++k) {
    pattern.contacts[k] = joints[k].touch;
    if (joints[k].touches()) pattern.slides[k] = static_cast<std::int8_t>(joints[k].slip);
  }
  return pattern;
}

template <class Real>
std::vector<Real> angles_of(const Poses<Real>& poses) {
  return mapped(poses, &Pose<Real>::angle);
}

/// What the joints of a sample carry.
template <class Real>
std::vector<BasicReaction<Real>> reactions_of(const Scene& scene, const ContactModel<Real>& stack,
                                              const ContactSample<Real>& sample) {
  const Gravity gravity = gravity_of(scene);
  const auto time = static_cast<double>(sample.time);
  FreeVector<Real> free =
      uniform<Real>(stack.size(), Real(gravity.along - acceleration(scene.horizontal, time)),
                    Real(-gravity.across - acceleration(scene.vertical, time)));
  Joints<Real> rigid = sample.joints;
  for (std::size_t k = 0; k < rigid.size(); ++k)
    if (stack.soft(k)) rigid[k].touch = Contact::apart;
  if (!sample.springs.empty()) free += sample.spring_accelerations;
  const ModeResponse<Real> response =
      respond<Real>({stack, sample.bodies, free, ContactLevel::accelerations}, rigid);
  std::vector<BasicReaction<Real>> reactions;
  reactions.reserve(sample.joints.size());
  for (int k = 0; k < stack.size(); ++k) {
    if (stack.soft(static_cast<std::size_t>(k))) {
      reactions.push_back(sample.springs[k].reaction);
      continue;
    }
    const Joint<Real>& joint = sample.joints[k];
    const ContactForce<Real>& force = response.forces[k];
    const int corner = joint.corner_below ? k - 1 : k;
    const Real pivot =
        joint.side() * stack.half_width(corner) - (joint.corner_below ? joint.offset : Real(0));
    const Real centre = joint.touch == Contact::closed ? Real(-force.moment / force.normal) : pivot;
    reactions.push_back(
        {force.normal, force.tangential, force.normal > 0 ? centre : std::numeric_limits<Real>::quiet_NaN()});
  }
  return reactions;
}

template <class Real>
void add_sample(const Scene& scene, const ContactModel<Real>& stack, const ContactSample<Real>& sample,
                BasicHistory<Real>& history) {
  history.times.push_back(sample.time);
  history.patterns.push_back(pattern_of(sample.joints));
  history.slips.insert(history.slips.end(), sample.slips.begin(), sample.slips.end());
  history.gaps.insert(history.gaps.end(), sample.gaps.begin(), sample.gaps.end());
  for (std::size_t k = 0; k < sample.joints.size(); ++k) {
    const Pose<Real>& at = sample.bodies.at[k];
    const Pose<Real>& rate = sample.bodies.rate[k];
    history.angles.push_back(at.angle);
    history.velocities.push_back(rate.angle);
    history.centres.insert(history.centres.end(), {at.x, at.y});
    history.centre_velocities.insert(history.centre_velocities.end(), {rate.x, rate.y});
  }
  const std::vector<BasicReaction<Real>> reactions = reactions_of(scene, stack, sample);
  history.reactions.insert(history.reactions.end(), reactions.begin(), reactions.end());
  for (const SpringState<Real>& springs : sample.springs) history.spring_energies.push_back(springs.energy);
}

/// The motion as other laws tell theirs, with slips, gaps, places, and reactions to the rounding of double.
template <class Real>
BasicHistory<Real> history_of(const Scene& scene, const ContactHistory<Real>& motion) {
  const ContactModel<Real> stack = contact_model_of<Real>(scene);
  BasicHistory<Real> history;
  history.blocks = stack.size();
  for (const ContactSample<Real>& sample : motion.samples) add_sample(scene, stack, sample, history);
  for (const ContactEvent<Real>& event : motion.events)
    history.events.push_back({event.time, event.kind, event.interface, pattern_of(event.from),
                              pattern_of(event.to), angles_of(event.at), angles_of(event.before),
                              angles_of(event.after), event.consistency, 1, event.approach});
  history.peaks = motion.peaks;
  history.slips_left = motion.slips_left;
  history.lifts = motion.lifts;
  history.forces = motion.forces;
  history.impulses = motion.impulses;
  return history;
}

}  // namespace rockstack
