#include "analytic/unilateral/unilateral_history.hpp"

#include <array>
#include <limits>

#include "analytic/unilateral/mode_response.hpp"

namespace rockstack {
namespace {

/// In the order of ContactEventKind.
constexpr std::array kinds{EventKind::opening, EventKind::lift_off, EventKind::slip,    EventKind::stick,
                           EventKind::corner,  EventKind::impact,   EventKind::closure, EventKind::rest,
                           EventKind::topple,  EventKind::fall};
/// In the order of Solutions.
constexpr std::array consistencies{Consistency::consistent, Consistency::several, Consistency::none};

Pattern pattern_of(const std::vector<Joint>& joints) {
  Pattern pattern = closed_pattern(static_cast<int>(joints.size()));
  for (std::size_t k = 0; k < joints.size(); ++k) {
    pattern.contacts[k] = static_cast<Contact>(joints[k].touch);
    if (joints[k].touches()) pattern.slides[k] = static_cast<std::int8_t>(joints[k].slip);
  }
  return pattern;
}

std::vector<double> angles_of(const std::vector<BodyPlacement>& placements) {
  std::vector<double> angles;
  for (const BodyPlacement& placement : placements) angles.push_back(placement.angle);
  return angles;
}

/// What the joints of a sample carry.
std::vector<Reaction> reactions_of(const Scene& scene, const FrictionStack& stack,
                                   const ContactHistory::Sample& sample) {
  const Gravity gravity = gravity_of(scene);
  FreeVector free(Eigen::Index{3} * stack.size());
  for (int k = 0; k < stack.size(); ++k)
    free.segment<3>(Eigen::Index{3} * k) << gravity.along - acceleration(scene.horizontal, sample.time),
        -gravity.across - acceleration(scene.vertical, sample.time), 0.0;
  const ModeResponse response = respond(stack, sample.joints, sample.bodies, free, Sought::accelerations);
  std::vector<Reaction> reactions;
  for (int k = 0; k < stack.size(); ++k) {
    const Joint& joint = sample.joints[static_cast<std::size_t>(k)];
    const ContactForce& force = response.forces[static_cast<std::size_t>(k)];
    const int corner = joint.corner_below ? k - 1 : k;
    const double pivot =
        joint.side() * half_width_of(stack.blocks, corner) - (joint.corner_below ? joint.offset : 0);
    const double centre = joint.touch == Touch::flat ? -force.moment / force.normal : pivot;
    reactions.push_back({force.normal, force.tangential,
                         force.normal > 0 ? centre : std::numeric_limits<double>::quiet_NaN()});
  }
  return reactions;
}

void add_sample(const Scene& scene, const FrictionStack& stack, const ContactHistory::Sample& sample,
                History& history) {
  history.times.push_back(sample.time);
  history.patterns.push_back(pattern_of(sample.joints));
  history.slips.insert(history.slips.end(), sample.slips.begin(), sample.slips.end());
  history.gaps.insert(history.gaps.end(), sample.gaps.begin(), sample.gaps.end());
  for (std::size_t k = 0; k < sample.joints.size(); ++k) {
    const BodyPlacement& at = sample.bodies.at[k];
    const BodyPlacement& rate = sample.bodies.rate[k];
    history.angles.push_back(at.angle);
    history.velocities.push_back(rate.angle);
    history.places.insert(history.places.end(), {at.x, at.y});
    history.place_rates.insert(history.place_rates.end(), {rate.x, rate.y});
  }
  const std::vector<Reaction> reactions = reactions_of(scene, stack, sample);
  history.reactions.insert(history.reactions.end(), reactions.begin(), reactions.end());
}

Event event_of(const ContactEvent& event) {
  return {event.time,
          kinds[static_cast<std::size_t>(event.kind)],
          event.interface,
          pattern_of(event.from),
          pattern_of(event.to),
          angles_of(event.at),
          angles_of(event.before),
          angles_of(event.after),
          consistencies[static_cast<std::size_t>(event.solutions)]};
}

}  // namespace

History history_of(const Scene& scene, const ContactHistory& motion) {
  const FrictionStack stack(scene.blocks, friction_of(scene));
  History history;
  history.blocks = stack.size();
  for (const ContactHistory::Sample& sample : motion.samples) add_sample(scene, stack, sample, history);
  for (const ContactEvent& event : motion.events) history.events.push_back(event_of(event));
  history.peaks = motion.peaks;
  history.forces = motion.forces;
  history.impulses = motion.impulses;
  return history;
}

}  // namespace rockstack
