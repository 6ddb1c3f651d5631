#pragma once

#include <algorithm>
#include <optional>
#include <stdexcept>

#include "analytic/unilateral/contact/contact_modes.hpp"
#include "analytic/unilateral/contact_changes.hpp"
#include "analytic/unilateral/contact_history.hpp"
#include "analytic/unilateral/springs/spring_contacts.hpp"

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

/// What a change at a soft interface is called; nothing where histories do not tell it. `passes`: a slider
/// has come to the end of a face.
template <class Real>
std::optional<EventKind> change_of(const BasicJoint<Real>& before, const BasicJoint<Real>& after,
                                   bool passes) {
  const auto ends = [](const BasicJoint<Real>& joint) {
    return joint.touch == Touch::flat ? 2 : joint.pivots() ? 1 : 0;
  };
  if (passes) return EventKind::corner;
  if (before.touch != after.touch) return ends(after) < ends(before) ? EventKind::part : EventKind::touch;
  if (before.slip == after.slip) return std::nullopt;
  return before.slip == 0 ? EventKind::slip : EventKind::stick;
}

/// The lowest interface that differs, from 1, and how.
template <class Real>
int lowest_change(const Joints<Real>& from, const Joints<Real>& to) {
  std::size_t k = 0;
  while (k + 1 < from.size() && from[k].same_mode(to[k])) ++k;
  return static_cast<int>(k) + 1;
}

/// What a change of contacts without impact is called.
template <class Real>
EventKind kind_of(const Joints<Real>& from, const Joints<Real>& to) {
  const auto any = [&](const auto& changed) {
    for (std::size_t k = 0; k < from.size(); ++k)
      if (changed(from[k], to[k])) return true;
    return false;
  };
  if (any([](const BasicJoint<Real>& a, const BasicJoint<Real>& b) { return a.touches() && !b.touches(); }))
    return EventKind::lift_off;
  if (any([](const BasicJoint<Real>& a, const BasicJoint<Real>& b) { return a.touch != b.touch; }))
    return EventKind::opening;
  if (any([](const BasicJoint<Real>& a, const BasicJoint<Real>& b) { return a.slip == 0 && b.slip != 0; }))
    return EventKind::slip;
  return EventKind::stick;
}

/// Whether friction at a pivot may turn it onto its face: G_NN ≤ μ |G_NT|. Without that one mode obeys.
template <class Real>
bool couples(const BasicFrictionStack<Real>& stack, const Joints<Real>& joints,
             const BasicBodies<Real>& bodies, std::size_t interface) {
  using std::abs;
  if (!joints[interface].pivots()) return false;
  const BasicPointRows<Real> rows =
      rows_of(stack.blocks, bodies, held_point(stack.blocks, static_cast<int>(interface), joints[interface]));
  const auto dot = [&](const FreeRow<Real>& a, const FreeRow<Real>& b) -> Real {
    return (a.array() * stack.inverse_mass.transpose().array() * b.array()).sum();
  };
  return dot(rows.gap_row, rows.gap_row) <= stack.friction[interface] * abs(dot(rows.gap_row, rows.slip_row));
}

/// Whether accelerations other than those of a mode obey as well, where there are few to try.
template <class Real>
bool has_others(const BasicFrictionStack<Real>& stack, const Joints<Real>& joints, const Joints<Real>& mode,
                const BasicBodies<Real>& bodies, const BasicFreeVector<Real>& free) {
  if (faces_differ(stack, joints, mode, bodies, free, Sought::accelerations)) return true;
  bool any = false;
  for (std::size_t k = 0; k < joints.size(); ++k) any = any || couples(stack, joints, bodies, k);
  if (!any) return false;
  constexpr std::size_t most = 200;
  const auto motion_of = [&](const Joints<Real>& held) -> BasicFreeVector<Real> {
    return respond(stack, held, bodies, free, Sought::accelerations).motion;
  };
  const BasicFreeVector<Real> motion = motion_of(mode);
  const Real same = Real(1e-6) * free.template lpNorm<Eigen::Infinity>();
  for (const auto& other : modes_that_obey(stack, joints, bodies, free, Sought::accelerations, most))
    if ((motion_of(other) - motion).template lpNorm<Eigen::Infinity>() > same) return true;
  return false;
}

}  // namespace rockstack
