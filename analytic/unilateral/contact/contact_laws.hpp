#pragma once

#include <algorithm>
#include <utility>

#include "analytic/unilateral/contact/mode_response.hpp"
#include "analytic/unilateral/contact/tolerance.hpp"

namespace rockstack {

// Points push or part, 0 ≤ λ_N ⟂ gap' ≥ 0, and rub by Coulomb's law, |λ_T| ≤ μ λ_N, λ_T = −μ λ_N sgn slip'
// where they slide (Moreau 1988; Stewart & Trinkle 1996). Both ends of a flat contact slide alike, so that
// they share λ_T.

/// What the joint of one interface can become.
template <class Real>
Joints<Real> choices(const BasicFrictionStack<Real>& stack, int interface, const BasicJoint<Real>& joint,
                     Sought sought) {
  if (!joint.touches()) return {joint};
  BasicJoint<Real> apart = joint;
  apart.touch = Touch::apart;
  apart.slip = 0;
  Joints<Real> result{apart};
  for (const Touch touch : {Touch::left, Touch::flat, Touch::right}) {
    if (joint.pivots() && touch != joint.touch) continue;
    for (const int slip : {-1, 0, 1}) {
      if (slip_before(joint, sought) != 0 && slip != joint.slip) continue;
      BasicJoint<Real> next = joint;
      next.touch = touch;
      next.slip = slip;
      if (joint.touch == Touch::flat && next.pivots())
        next.corner_below = corner_is_below(stack, interface, joint.offset, next.side(), slip);
      result.push_back(next);
    }
  }
  return result;
}

/// True where every law of contact holds in a mode, of `joints` that could be in another.
template <class Real>
bool obeys(const BasicFrictionStack<Real>& stack, const Joints<Real>& joints, const Joints<Real>& mode,
           const BasicBodies<Real>& bodies, const BasicFreeVector<Real>& free, Sought sought) {
  const BasicModeResponse<Real> response = respond(stack, mode, bodies, free, sought);
  using std::abs;
  Real size = 0;
  for (const BasicContactForce<Real>& force : response.forces)
    size = std::max<Real>({size, Real(abs(force.normal)), Real(abs(force.tangential))});
  const Real motion_rounding = tolerance<Real>(1e-9) * free.template lpNorm<Eigen::Infinity>();
  const Real force_rounding = tolerance<Real>(1e-9) * size;
  for (const TouchingPoints<Real>& contact : touching_points(stack, joints, bodies, sought)) {
    const auto index = static_cast<std::size_t>(contact.interface);
    const BasicJoint<Real>& joint = mode[index];
    const BasicContactForce<Real>& force = response.forces[index];
    for (std::size_t i = 0; i < contact.normals.size(); ++i)
      if (contact.normals[i].dot(response.motion) + contact.normal_biases[i] < -motion_rounding) return false;
    if (force.normal < -force_rounding) return false;
    if (abs(force.tangential) > contact.friction * force.normal + force_rounding) return false;
    if (joint.touch == Touch::flat) {
      const Overlap<Real> ends = overlap(stack, contact.interface, joint.offset);
      if (force.normal * ends.right + force.moment < -force_rounding * (ends.right - ends.left)) return false;
      if (-force.moment - force.normal * ends.left < -force_rounding * (ends.right - ends.left)) return false;
    }
    const Real slip = contact.slip.dot(response.motion) + contact.slip_bias;
    if (joint.slip != 0 && slip_before(joints[index], sought) == 0 && slip * joint.slip < -motion_rounding)
      return false;
  }
  return true;
}

/// All modes that obey, each tried: of what touches, each part, pivot or stay, and what sticks may slide.
/// Nothing is tried where that were more than `most`.
template <class Real>
std::vector<Joints<Real>> modes_that_obey(const BasicFrictionStack<Real>& stack, const Joints<Real>& joints,
                                          const BasicBodies<Real>& bodies, const BasicFreeVector<Real>& free,
                                          Sought sought, std::size_t most) {
  std::vector<Joints<Real>> modes{{}};
  for (std::size_t k = 0; k < joints.size(); ++k) {
    std::vector<Joints<Real>> longer;
    for (const BasicJoint<Real>& choice : choices(stack, static_cast<int>(k), joints[k], sought)) {
      for (const auto& mode : modes) {
        longer.push_back(mode);
        longer.back().push_back(choice);
      }
    }
    if (longer.size() > most) return {};
    modes = std::move(longer);
  }
  std::erase_if(modes, [&](const auto& mode) { return !obeys(stack, joints, mode, bodies, free, sought); });
  return modes;
}

}  // namespace rockstack
