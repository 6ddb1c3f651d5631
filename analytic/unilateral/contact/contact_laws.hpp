#pragma once

#include "analytic/unilateral/contact/contact_problem.hpp"

namespace rockstack {

// Points push or part, 0 ≤ λ_N ⟂ gap' ≥ 0, and rub by Coulomb's law, |λ_T| ≤ μ λ_N, λ_T = −μ λ_N sgn slip'
// where they slide (Moreau 1988; Stewart & Trinkle 1996). Both ends of a flat contact share λ_T.
//
// Two coefficients, μ_k ≤ μ_s. What sticks has the static cone; a contact whose forces leave it has the
// kinetic one from there on, and sticks again where its slip comes to an end, or does not grow, in either
// cone (cones_left()). Impulses have the kinetic one alone: static friction is that of contacts which have
// rested (Rabinowicz 1951, J. Appl. Phys. 22, 1373–1379), and the proof in expansion.hpp that impacts never
// gain energy needs one coefficient for both phases. So a block that meets the ground sticks where μ_k admits
// it.

/// What the joint of one interface can become.
template <class Real>
ShortVector<Joint<Real>, 10> choices(const ContactProblem<Real>& problem, int interface,
                                     const Joint<Real>& joint) {
  if (!joint.touches()) return {joint};
  ShortVector<Joint<Real>, 10> result{joint};
  result[0].touch = Contact::apart;
  result[0].slip = 0;
  for (const Contact touch : {Contact::left, Contact::closed, Contact::right}) {
    if (joint.pivots() && touch != joint.touch) continue;
    for (const int slip : {-1, 0, 1}) {
      if (problem.slip_before(joint) != 0 && slip != joint.slip) continue;
      Joint<Real> next = joint;
      next.touch = touch;
      next.slip = slip;
      if (joint.touch == Contact::closed && next.pivots())
        next.corner_below = corner_is_below(problem.stack, interface, joint.offset, next.side(), slip);
      result.push_back(next);
    }
  }
  return result;
}

/// True where every law of contact holds in a mode, of `joints` that touch so and could be in another.
template <class Real>
bool obeys(const TouchingContacts<Real>& contacts, const Joints<Real>& joints, const Joints<Real>& mode) {
  const ContactForceRows<Real> held = held_by(contacts, mode);
  const ShortNumbers<Real> values = holding(contacts, held);
  const ShortVector<ContactForce<Real>> forces = held_forces(contacts, mode, values);
  const Real force_rounding = tolerance<Real>(1e-9) * largest_force(forces);
  for (const TouchingInterface<Real>& contact : contacts.interfaces()) {
    const ContactForce<Real>& force = forces[contact.interface];
    if (force.normal < -force_rounding) return false;
    if (abs(force.tangential) > contact.friction * force.normal + force_rounding) return false;
    if (mode[contact.interface].touch != Contact::closed) continue;
    const auto [left, right] = contact.ends;
    const Real moment_rounding = force_rounding * (right - left);
    if (force.normal * right + force.moment < -moment_rounding) return false;
    if (-force.moment - force.normal * left < -moment_rounding) return false;
  }
  const Real motion_rounding =
      tolerance<Real>(1e-9) * contacts.problem().free.template lpNorm<Eigen::Infinity>();
  for (const TouchingInterface<Real>& contact : contacts.interfaces()) {
    const Joint<Real>& joint = mode[contact.interface];
    for (std::size_t i = 0; i < contact.points(); ++i)
      if (contacts.condition(contact.point(i), held, values) < -motion_rounding) return false;
    if (joint.slip != 0 && contacts.problem().slip_before(joints[contact.interface]) == 0 &&
        contacts.condition(contact.slip(), held, values) * joint.slip < -motion_rounding)
      return false;
  }
  return true;
}

/// All modes that obey: what touches parts, pivots or stays, what sticks may slide. None of more than `most`.
template <class Real>
std::vector<Joints<Real>> modes_that_obey(const TouchingContacts<Real>& contacts, const Joints<Real>& joints,
                                          std::size_t most) {
  std::vector<Joints<Real>> modes;
  ShortVector<ShortVector<Joint<Real>, 10>> ways;
  std::size_t count = 1;
  for (std::size_t k = 0; k < joints.size(); ++k) {
    ways.push_back(choices(contacts.problem(), k, joints[k]));
    count *= ways.back().size();
    if (count > most) return modes;
  }
  Joints<Real> mode(joints.size());
  for (std::size_t number = 0; number < count; ++number) {
    std::size_t rest = number;
    for (std::size_t k = 0; k < joints.size(); ++k) {
      mode[k] = ways[k][rest % ways[k].size()];
      rest /= ways[k].size();
    }
    if (obeys(contacts, joints, mode)) modes.push_back(mode);
  }
  return modes;
}

// Corner on corner. At a pivot of blocks that end at one place, as those of equal width do before they slip,
// no face gives the normal. Let the block above lean to the right by φ, on its right corner. Slip to the
// left, inward, brings that corner onto the lower face; slip to the right, outward, brings the corner below
// under the upper face. The force T along and N across the lower face is T' = T cos φ − N sin φ along and N'
// = T sin φ + N cos φ across the upper one.
//
// Let the block above be wider or narrower by ε. Wider, it rests on the corner below: it sticks as long as
// |T'| ≤ μN'. Narrower, it rests on its own: |T| ≤ μN. As ε → 0, what slides off its face goes on along the
// other one, so that both limits
//   stick          where T ≤ μN and −T' ≤ μN',
//   slide inward   where T' > μN',  which includes T > μN,
//   slide outward  where −T > μN,   which includes −T' > μN'.
// Between these, one sticks and the other slides, and both obey the law.
//
// The rule: a slip is judged by the face that it meets. A pair of corners slides inward where T > μN, and
// outward where −T' > μN'; else it sticks. So it is the limit wherever both agree, and sticks where nothing
// can part it. Where friction is so small that both ways are open, φ > 2 arctan μ, it slides inward. Impulses
// are judged alike.

/// Whether the corners of both blocks at a pivot are at one place.
template <class Real>
bool is_corner_pair(const ContactModel<Real>& stack, int interface, const Joint<Real>& joint) {
  return joint.pivots() && overhang(stack, interface, joint.offset, joint.side()) == 0;
}

/// Gives a pair of corners the face that its slip goes along.
template <class Real>
void meet_face(const ContactModel<Real>& stack, int interface, Joint<Real>& joint) {
  if (is_corner_pair(stack, interface, joint))
    joint.corner_below = corner_is_below(stack, interface, joint.offset, joint.side(), joint.slip);
}

/// Pairs of corners, by interfaces, that are not settled and do not slide; of velocities those that do too.
template <class Real>
ShortVector<int> open_pairs(const ContactModel<Real>& stack, const Joints<Real>& joints, ContactLevel level) {
  ShortVector<int> pairs;
  for (int k = 1; k < stack.size(); ++k) {
    const Joint<Real>& joint = joints[k];
    const bool open = !joint.settled && (joint.slip == 0 || level != ContactLevel::accelerations);
    if (open && is_corner_pair(stack, k, joint)) pairs.push_back(k);
  }
  return pairs;
}

/// What an interface's pivot bears along and across the other face of its pair of corners.
template <class Real>
ContactForce<Real> on_other_face(const ContactForce<Real>& force, const Joint<Real>& joint,
                                 const Real& relative_angle) {
  const Point<Real> other = turned<Real>({force.normal, force.tangential},
                                         joint.corner_below ? Real(-relative_angle) : relative_angle);
  return {other.x(), other.y(), force.moment};
}

/// Whether a pair of corners slides off its face.
template <class Real>
bool slides_off(const Joint<Real>& pair) {
  return pair.touches() && pair.slip == (pair.corner_below ? -pair.side() : pair.side());
}

/// Whether a pair of corners slides off its face, or sticks there where it would slide along the other one.
/// `joint` is what it becomes, at interface k, `forces` what that takes.
template <class Real>
bool changes_face(const ContactProblem<Real>& problem, const ShortVector<ContactForce<Real>>& forces, int k,
                  const Joint<Real>& joint, const Real& rounding) {
  if (!joint.touches() || joint.slip != 0) return slides_off(joint);
  const auto other = on_other_face(forces[k], joint, relative_angle(problem.bodies.pose, k));
  const int against = joint.corner_below ? joint.side() : -joint.side();
  return against * other.tangential > problem.friction(k, joint) * other.normal + rounding;
}

/// The interfaces that slide in a mode although they still have static cones that are not the kinetic ones.
template <class Real>
std::uint32_t cones_left(const ContactProblem<Real>& problem, const Joints<Real>& joints,
                         const Joints<Real>& mode) {
  std::uint32_t left = 0;
  for (std::size_t k = 0; k < mode.size(); ++k)
    if (mode[k].slip != 0 && problem.stack.friction[k] != problem.stack.kinetic_friction[k] &&
        problem.has_static_cone(static_cast<int>(k), joints[k]))
      left |= 1U << k;
  return left;
}

/// The first of `pairs` that changes its face in a mode of `contacts`, or −1.
template <class Real>
int first_to_change(const TouchingContacts<Real>& contacts, const ShortVector<int>& pairs,
                    const Joints<Real>& mode) {
  const auto forces = held_forces(contacts, mode, holding(contacts, held_by(contacts, mode)));
  const Real rounding = tolerance<Real>(1e-12) * largest_force(forces);
  for (const int k : pairs)
    if (changes_face(contacts.problem(), forces, k, mode[k], rounding)) return k;
  return -1;
}

/// Settles those of `pairs` that stick in a mode, and would slide along their other faces.
template <class Real>
void settle(const ContactProblem<Real>& problem, const ShortVector<int>& pairs, Joints<Real>& mode) {
  const auto forces = respond(problem, mode).forces;
  for (const int k : pairs)
    mode[k].settled = mode[k].sticks() && changes_face<Real>(problem, forces, k, mode[k], 0);
}

/// Opens settled pairs again that do not go on to stick in a mode; true where there are any.
template <class Real>
bool unsettle(const Joints<Real>& mode, Joints<Real>& joints) {
  bool any = false;
  for (std::size_t k = 0; k < joints.size(); ++k) {
    if (!joints[k].settled || mode[k].sticks()) continue;
    joints[k].settled = joints[k].corner_below = false;
    any = true;
  }
  return any;
}

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
  const ContactProblem<Real>& problem = contacts.problem();
  if (problem.of_accelerations()) return joints;
  for (const TouchingInterface<Real>& contact : contacts.interfaces()) {
    Joint<Real>& joint = joints[contact.interface];
    joint.slip = 0;
    if (!contact.flat) continue;
    const Real left = contacts.told(contact.point(0)), right = contacts.told(contact.point(1));
    const Real meets = tolerance<Real>(1e-9) * std::min(left, right);
    if ((left < meets) != (right < meets))
      set_mode(problem.stack, contact, {left < meets, right < meets}, 0, joint);
  }
  return joints;
}

/// True where all laws hold in a mode in which all that touches sticks, by more than rounding, and pairs of
/// corners stay on their faces. There is one such mode then: its equations are those of a least energy.
template <class Real>
bool surely_obeys(const TouchingContacts<Real>& contacts, const Joints<Real>& mode,
                  const ShortVector<int>& pairs) {
  if (std::ranges::any_of(mode, [](const Joint<Real>& joint) { return joint.slip != 0; })) return false;
  const ContactProblem<Real>& problem = contacts.problem();
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
      const Real fast = problem.free.template lpNorm<Eigen::Infinity>();
      if (!(contacts.condition(open, held, values) > tolerance<Real>(1e-9) * fast)) return false;
      continue;
    }
    const Real least = rounding * (right - left);
    if (!(force.normal * right + force.moment > least)) return false;
    if (!(-force.moment - force.normal * left > least)) return false;
  }
  return std::none_of(pairs.begin(), pairs.end(),
                      [&](int k) { return changes_face<Real>(problem, forces, k, mode[k], -rounding); });
}

/// Where blocks are, how fast they move, and what they touch.
template <class Real>
struct ContactState {
  Bodies<Real> bodies;
  Joints<Real> joints;
};

}  // namespace rockstack
