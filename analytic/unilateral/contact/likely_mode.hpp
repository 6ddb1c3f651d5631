#pragma once

#include "analytic/unilateral/contact/contact_laws.hpp"

namespace rockstack {

/// A mode from what is active: which points push, and which way the interface slides.
template <class Real>
void set_mode(const ContactModel<Real>& stack, const TouchingInterface<Real>& contact,
              const ShortVector<bool>& pushes, int slip, Joint<Real>& joint) {
  if (std::find(pushes.begin(), pushes.end(), true) == pushes.end()) {
    joint.touch = Contact::apart;
    joint.slip = 0;
    return;
  }
  joint.slip = slip;
  if (joint.touch != Contact::closed || (pushes[0] && pushes[1])) return;
  joint.touch = pushes[0] ? Contact::left : Contact::right;
  joint.corner_below = corner_is_below(stack, contact.interface, joint.offset, joint.side(), slip);
}

/// What is likely: accelerations leave contacts as they are, and of an impact a flat contact rocks over to
/// the end that meets its face, where the other one does not. All sticks.
template <class Real>
Joints<Real> likely_mode(const TouchingContacts<Real>& contacts, Joints<Real> joints) {
  const ContactQuestion<Real>& question = contacts.question();
  if (question.of_accelerations()) return joints;
  for (const TouchingInterface<Real>& contact : contacts.interfaces()) {
    Joint<Real>& joint = joints[contact.interface];
    joint.slip = 0;
    if (!contact.flat) continue;
    const Real left = contacts.free(contact.point(0)), right = contacts.free(contact.point(1));
    const Real meets = tolerance<Real>(1e-9) * std::min(left, right);
    if ((left < meets) != (right < meets))
      set_mode(question.stack, contact, {left < meets, right < meets}, 0, joint);
  }
  return joints;
}

/// True where all laws hold in a mode in which all that touches sticks, by more than rounding, and pairs of
/// corners stay on their faces. There is one such mode then: its equations are those of a least kinetic
/// energy.
template <class Real>
bool surely_obeys(const TouchingContacts<Real>& contacts, const Joints<Real>& mode,
                  const ShortVector<int>& pairs) {
  if (std::ranges::any_of(mode, [](const Joint<Real>& joint) { return joint.slip != 0; })) return false;
  const ContactQuestion<Real>& question = contacts.question();
  const ContactForceRows<Real> held = held_by(contacts, mode);
  const ShortNumbers<Real> values = holding(contacts, held);
  const auto forces = held_forces(contacts, mode, values);
  const Real rounding = tolerance<Real>(1e-9) * largest_force(forces);
  for (const TouchingInterface<Real>& contact : contacts.interfaces()) {
    const ContactForce<Real>& force = forces[contact.interface];
    if (!(abs(force.tangential) + rounding < contact.friction * force.normal)) return false;
    if (!contact.flat) continue;
    const auto [left, right] = contact.ends;
    if (const int side = mode[contact.interface].side(); side != 0) {
      const std::size_t open = contact.point(side < 0 ? 1 : 0);
      const Real fast = question.free.template lpNorm<Eigen::Infinity>();
      if (!(contacts.condition(open, held, values) > tolerance<Real>(1e-9) * fast)) return false;
      continue;
    }
    const Real least = rounding * (right - left);
    if (!(force.normal * right + force.moment > least)) return false;
    if (!(-force.moment - force.normal * left > least)) return false;
  }
  return std::none_of(pairs.begin(), pairs.end(),
                      [&](int k) { return changes_face<Real>(question, forces, k, mode[k], -rounding); });
}

}  // namespace rockstack
