#pragma once

#include "analytic/unilateral/contact/contact_laws.hpp"

namespace rockstack {

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
// are judged alike. Between the limits, an event tells that there are several motions.

/// Whether the corners of both blocks at a pivot are at one place.
template <class Real>
bool is_corner_pair(const BasicFrictionStack<Real>& stack, int interface, const BasicJoint<Real>& joint) {
  return joint.pivots() && overhang(stack, interface, joint.offset, joint.side()) == 0;
}

/// Gives a pair of corners the face that its slip goes along.
template <class Real>
void meet_face(const BasicFrictionStack<Real>& stack, int interface, BasicJoint<Real>& joint) {
  if (is_corner_pair(stack, interface, joint))
    joint.corner_below = corner_is_below(stack, interface, joint.offset, joint.side(), joint.slip);
}

/// The pairs of corners whose face is to be found, by their interfaces.
template <class Real>
std::vector<int> open_pairs(const BasicFrictionStack<Real>& stack, const Joints<Real>& joints,
                            Sought sought) {
  std::vector<int> pairs;
  for (int k = 1; k < stack.size(); ++k) {
    const BasicJoint<Real>& joint = joints[static_cast<std::size_t>(k)];
    if (slip_before(joint, sought) == 0 && is_corner_pair(stack, k, joint)) pairs.push_back(k);
  }
  return pairs;
}

/// What an interface's pivot bears along and across the other face of its pair of corners.
template <class Real>
BasicContactForce<Real> on_other_face(const BasicContactForce<Real>& force, const BasicJoint<Real>& joint,
                                      const Real& relative_angle) {
  const Point<Real> other = turned<Real>({force.normal, force.tangential},
                                         joint.corner_below ? Real(-relative_angle) : relative_angle);
  return {other.x(), other.y(), force.moment};
}

/// Whether a pair of corners slides off its face.
template <class Real>
bool slides_off(const BasicJoint<Real>& pair) {
  return pair.touches() && pair.slip == (pair.corner_below ? -pair.side() : pair.side());
}

/// Whether a pair of corners slides off its face, or sticks there where it would slide along the other one.
/// `joint` is what it becomes, `force` what that takes.
template <class Real>
bool changes_face(const BasicJoint<Real>& joint, const BasicContactForce<Real>& force,
                  const Real& relative_angle, const Real& friction, const Real& rounding) {
  if (!joint.touches() || joint.slip != 0) return slides_off(joint);
  const BasicContactForce<Real> other = on_other_face(force, joint, relative_angle);
  const int against = joint.corner_below ? joint.side() : -joint.side();
  return against * other.tangential > friction * other.normal + rounding;
}

/// The first of `pairs` that changes its face in a mode, or −1.
template <class Real>
int first_to_change(const BasicFrictionStack<Real>& stack, const std::vector<int>& pairs,
                    const Joints<Real>& mode, const BasicBodies<Real>& bodies,
                    const BasicModeResponse<Real>& response) {
  using std::abs;
  Real size = 0;
  for (const BasicContactForce<Real>& force : response.forces)
    size = std::max<Real>({size, Real(abs(force.normal)), Real(abs(force.tangential))});
  for (const int k : pairs) {
    const auto index = static_cast<std::size_t>(k);
    if (changes_face(mode[index], response.forces[index], relative_angle(bodies.at, index),
                     stack.friction[index], Real(tolerance<Real>(1e-12) * size)))
      return k;
  }
  return -1;
}

}  // namespace rockstack
