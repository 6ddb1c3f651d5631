#pragma once

#include <algorithm>
#include <stdexcept>

#include "analytic/unilateral/contact_chatter.hpp"

namespace rockstack {

/// What an impact leads to.
template <class Real>
struct ContactCollision {
  Joints<Real> found;  ///< what the impulses bring about
  std::vector<BasicContactForce<Real>> impulses;
  Joints<Real> mode;  ///< without what slides or parts too slowly
  Placements<Real> rates;
  bool closes = false;   ///< something stays together as its chatter ends
  bool several = false;  ///< on other faces of pairs of corners another obeys as well
};

template <class Real>
bool same_modes(const Joints<Real>& first, const Joints<Real>& second) {
  return std::equal(first.begin(), first.end(), second.begin(),
                    [](const BasicJoint<Real>& a, const BasicJoint<Real>& b) { return a.same_mode(b); });
}

/// The velocities that joints leave, by impulses of a stack without friction: a projection in the metric of
/// kinetic energy, which never gains any.
template <class Real>
Placements<Real> held_rates(const BasicFrictionStack<Real>& smooth, const Joints<Real>& joints,
                            const BasicBodies<Real>& bodies) {
  return placements_of<Real>(
      respond(smooth, joints, bodies, vector_of(bodies.rate), Sought::velocities).motion);
}

/// A mode after an impact in which what does not slide as it should sticks.
template <class Real>
Joints<Real> with_slips(const BasicFrictionStack<Real>& stack, Joints<Real> mode,
                        const BasicBodies<Real>& bodies) {
  const BasicFreeVector<Real> rates = vector_of(bodies.rate);
  for (int k = 0; k < stack.size(); ++k) {
    BasicJoint<Real>& joint = mode[static_cast<std::size_t>(k)];
    if (!joint.touches() || joint.slip == 0) continue;
    const BasicPointRows<Real> rows = rows_of(stack.blocks, bodies, held_point(stack.blocks, k, joint));
    const Real rounding = tolerance<Real>(1e-14) * rows.slip_row.cwiseAbs().dot(rates.cwiseAbs());
    if (joint.slip * rows.slip_row.dot(rates) > rounding) continue;
    joint.slip = 0;
    meet_face(stack, k, joint);
  }
  return mode;
}

/// The impact of bodies that meet at `touching`; nothing where no impulses end it. `smooth` is the stack
/// without friction, `free` the acceleration without contact.
template <class Real>
std::optional<ContactCollision<Real>> collide(const BasicFrictionStack<Real>& stack,
                                              const BasicFrictionStack<Real>& smooth,
                                              const ContactChatter<Real>& chatter,
                                              const Joints<Real>& touching, BasicBodies<Real> bodies,
                                              const BasicFreeVector<Real>& free) {
  const BasicFreeVector<Real> before = vector_of(bodies.rate);
  const auto found = find_mode(stack, touching, bodies, before, Sought::velocities);
  if (!found) return std::nullopt;
  const BasicModeResponse<Real> response = respond(stack, *found, bodies, before, Sought::velocities);
  ContactCollision<Real> impact{*found, response.forces, *found, {}};
  impact.several = faces_differ(stack, touching, *found, bodies, before, Sought::velocities);
  bodies.rate = placements_of(response.motion);
  for (std::size_t rounds = 0; rounds <= 4 * touching.size(); ++rounds) {
    Joints<Real> held = with_slips(stack, impact.mode, bodies);
    if (same_modes(held, impact.mode)) {
      held = chatter.without_slow(touching, impact.mode, bodies, free);
      if (same_modes(held, impact.mode)) break;
      impact.closes = true;
    }
    impact.mode = held;
    bodies.rate = held_rates(smooth, impact.mode, bodies);
  }
  impact.rates = bodies.rate;
  return impact;
}

}  // namespace rockstack
