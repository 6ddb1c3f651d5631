#pragma once

#include "analytic/unilateral/contact/expansion.hpp"
#include "analytic/unilateral/contact_changes.hpp"

namespace rockstack {

/// What an impact leads to.
template <class Real>
struct ContactCollision {
  Joints<Real> found;  ///< what the impulses bring about, by Poisson's law those of compression
  ShortVector<ContactForce<Real>> impulses;
  Joints<Real> mode;  ///< without what slides or parts too slowly
  Poses<Real> rates;
  EventKind kind = EventKind::impact;  ///< or what its chatter ends with
  Consistency consistency = Consistency::consistent;
};

template <class Real>
bool same_modes(const Joints<Real>& first, const Joints<Real>& second) {
  return std::equal(first.begin(), first.end(), second.begin(), std::mem_fn(&Joint<Real>::same_mode));
}

/// The velocities that joints leave without friction: a projection in the metric of kinetic energy.
template <class Real>
Poses<Real> held_rates(const ContactModel<Real>& smooth, const Joints<Real>& joints,
                       const Bodies<Real>& bodies) {
  return poses_of<Real>(
      respond<Real>({smooth, bodies, vector_of(bodies.velocity), ContactLevel::velocities}, joints).motion);
}

/// A mode after an impact in which what does not slide as it should sticks.
template <class Real>
Joints<Real> with_slips(const ContactModel<Real>& stack, Joints<Real> mode, const Bodies<Real>& bodies) {
  const FreeVector<Real> rates = vector_of(bodies.velocity);
  for (int k = 0; k < stack.size(); ++k) {
    Joint<Real>& joint = mode[k];
    if (!joint.touches() || joint.slip == 0) continue;
    const ContactKinematics<Real> rows = kinematics_of(stack, bodies, k, joint);
    const Real rounding = tolerance<Real>(1e-14) * rows.slip_row.cwiseAbs().dot(rates.cwiseAbs());
    if (joint.slip * rows.slip_row.dot(rates) > rounding) continue;
    joint.slip = 0;
    meet_face(stack, k, joint);
  }
  return mode;
}

/// A mode after impulses in which points that bounce have parted, as far as rounding tells.
template <class Real>
Joints<Real> bounced(const ContactModel<Real>& stack, Joints<Real> mode, const Bodies<Real>& after) {
  if (stack.restitution == 0) return mode;
  const FreeVector<Real> rates = vector_of(after.velocity);
  for (int k = 0; k < stack.size(); ++k) {
    Joint<Real>& joint = mode[k];
    if (!joint.touches()) continue;
    Joints<Real> stay;
    for (const int side : {-1, 1}) {
      if (joint.pivots() && side != joint.side()) continue;
      const Joint<Real> end = end_of(stack, k, joint, side);
      const FreeRow<Real> row = kinematics_of(stack, after, k, end).gap_row;
      if (row.dot(rates) <= tolerance<Real>(1e-13) * row.cwiseAbs().dot(rates.cwiseAbs()))
        stay.push_back(end);
    }
    if (stay.empty())
      joint = {.touch = Contact::apart, .corner_below = joint.corner_below, .offset = joint.offset};
    else if (joint.touch == Contact::closed && stay.size() == 1)
      joint = stay[0];
  }
  return mode;
}

/// Lets pairs of corners that slide off their faces by impulses go on to the others, which `touching` tells.
template <class Real>
void pass_faces(const ContactModel<Real>& stack, const Bodies<Real>& after, Joints<Real>& mode,
                Joints<Real>& touching) {
  for (int k = 0; k < stack.size(); ++k) {
    Joint<Real>& joint = mode[k];
    joint.settled = joint.settled && joint.sticks();
    if (!slides_off(joint) || !is_corner_pair(stack, k, joint)) continue;
    touching[k].corner_below = !joint.corner_below;
    pass_corner(stack, after, k, mode);
  }
}

/// Twice the kinetic energy of a motion, J.
template <class Real>
Real twice_energy(const ContactModel<Real>& stack, const FreeVector<Real>& motion) {
  return (motion.array().square() / stack.inverse_mass.array()).sum();
}

/// Velocities after an impact, without those that roundings make of its impulses: at each face of a block no
/// impulse is larger than the momenta that all above it takes.
template <class Real>
Poses<Real> without_roundings(const ContactModel<Real>& stack, const Poses<Real>& before, Poses<Real> after) {
  Real impulse = 0;
  for (std::size_t k = after.size(); k-- > 0;) {
    const Block& block = stack.blocks[k];
    const Pose<Real>& old = before[k];
    Pose<Real>& rate = after[k];
    impulse += block.mass * (abs(rate.x - old.x) + abs(rate.y - old.y));
    const Real arm = block.half_width + block.half_height + abs(block.offset_x) + abs(block.offset_y);
    const auto clear = [&](Real& part, const Real& size) {
      if (abs(part) <= tolerance<Real>(1e-14) * size) part = 0;
    };
    clear(rate.x, abs(old.x) + impulse / block.mass);
    clear(rate.y, abs(old.y) + impulse / block.mass);
    clear(rate.angle, abs(old.angle) + impulse * arm / block.inertia);
  }
  return after;
}

/// The impact of bodies that meet at `touching`; nothing where no impulses end it. `smooth` is the stack
/// without friction, `free` the acceleration without contact. `choose` is as choose_branch() below. At the
/// level of velocities points do not bounce.
template <class Real, class Choose>
std::optional<ContactCollision<Real>> collide(const ContactModel<Real>& stack,
                                              const ContactModel<Real>& smooth,
                                              const ContactChatter<Real>& chatter,
                                              const Joints<Real>& touching, Bodies<Real> bodies,
                                              const FreeVector<Real>& free, const Choose& choose,
                                              ContactLevel level = ContactLevel::impacts) {
  const FreeVector<Real> before = vector_of(bodies.velocity);
  const ContactProblem<Real> problem{stack, bodies, before, level};
  const TouchingContacts<Real> contacts(problem, touching);
  auto found = find_mode(contacts, touching);
  if (!found) return std::nullopt;
  const bool several = choose(contacts, touching, *found);
  ModeResponse<Real> response = respond(problem, *found);
  std::optional<Joints<Real>> mode = found;
  if (level == ContactLevel::impacts && stack.bounces_by(RestitutionLaw::poisson))
    mode = expand(problem, touching, *found, response);
  if (!mode) return std::nullopt;
  ContactCollision<Real> impact{*found, response.forces, *std::move(mode), {}};
  if (several) impact.consistency = Consistency::several;
  bodies.velocity = poses_of(response.motion);
  Joints<Real> met = touching;
  pass_faces(stack, bodies, impact.mode, met);
  impact.mode = bounced(stack, impact.mode, bodies);
  if (twice_energy(stack, response.motion) > (1 + tolerance<Real>(1e-12)) * twice_energy(stack, before))
    impact.consistency = Consistency::gains;
  for (std::size_t rounds = 0; rounds <= 4 * touching.size(); ++rounds) {
    Joints<Real> held = with_slips(stack, impact.mode, bodies);
    if (same_modes(held, impact.mode)) {
      held = chatter.without_slow(met, impact.mode, bodies, free);
      if (same_modes(held, impact.mode)) break;
      impact.kind = EventKind::closure;
    }
    impact.mode = held;
    bodies.velocity = held_rates(smooth, impact.mode, bodies);
  }
  impact.rates = without_roundings(stack, poses_of(before), bodies.velocity);
  const auto still = [](const Joint<Real>& joint) {
    return joint.touch == Contact::closed && joint.slip == 0;
  };
  if (impact.kind == EventKind::closure && std::ranges::all_of(impact.mode, still))
    impact.kind = EventKind::rest;
  return impact;
}

}  // namespace rockstack
