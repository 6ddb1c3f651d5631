#pragma once

#include "analytic/unilateral/contact_chatter.hpp"
#include "analytic/unilateral/first_change.hpp"

namespace rockstack {

/// A joint that a corner of an interface has come to by landing.
template <class Real>
void land(const BasicFrictionStack<Real>& stack, const BasicBodies<Real>& bodies, int interface, bool below,
          Joints<Real>& joints) {
  using std::abs;
  const auto k = static_cast<std::size_t>(interface);
  BasicJoint<Real>& joint = joints[k];
  const Real angle = relative_angle(bodies.at, k);
  joint.slip = 0;
  if (abs(angle) <= flat_angle<Real>()) {
    joint.touch = Touch::flat;
  } else {
    joint.touch = angle > 0 ? Touch::right : Touch::left;
    joint.corner_below = below;
  }
  joint.offset = offset_of(stack.blocks, bodies, interface, joint);
}

/// The other corner takes over where one has come to the end of its face; true where it meets the face.
template <class Real>
bool pass_corner(const BasicFrictionStack<Real>& stack, const BasicBodies<Real>& bodies, int interface,
                 Joints<Real>& joints) {
  BasicJoint<Real>& joint = joints[static_cast<std::size_t>(interface)];
  if (!joint.pivots()) return false;
  joint.corner_below = !joint.corner_below;
  joint.offset = offset_of(stack.blocks, bodies, interface, joint);
  const BasicPointRows<Real> rows = rows_of(stack.blocks, bodies, held_point(stack.blocks, interface, joint));
  const BasicFreeVector<Real> rates = vector_of(bodies.rate);
  const Real speed = rows.gap_row.dot(rates);
  const Real rounding = tolerance<Real>(1e-13) * (rows.gap_row.cwiseAbs().dot(rates.cwiseAbs()));
  if (speed > rounding) {
    joint.touch = Touch::apart;
    joint.slip = 0;
  }
  return speed < -rounding;
}

/// Lands what is above its face by no more than `gap`, m.
template <class Real>
void land_negligible(const BasicFrictionStack<Real>& stack, const BasicBodies<Real>& bodies, int interface,
                     const Real& gap, Joints<Real>& joints) {
  using std::abs;
  const Real angle = relative_angle(bodies.at, static_cast<std::size_t>(interface));
  for (const bool below : {true, false}) {
    if (below && interface == 0) continue;
    for (const int side : {-1, 1}) {
      if (side * angle < -flat_angle<Real>()) continue;
      const CornerOnFace<Real> corner = below ? lower_corner<Real>(stack.blocks, interface, side)
                                              : upper_corner<Real>(stack.blocks, interface, side);
      const BasicPointRows<Real> rows = rows_of(stack.blocks, bodies, corner);
      if (abs(rows.gap) <= gap && abs(rows.slip) <= half_width_of<Real>(stack.blocks, corner.face) + gap)
        land(stack, bodies, interface, below, joints);
    }
  }
}

/// Closes what is open by rounding, so that all that meets at one instant is one impact.
template <class Real>
void close_negligible(const BasicFrictionStack<Real>& stack, const ContactChatter<Real>& chatter,
                      const BasicBodies<Real>& bodies, Joints<Real>& joints) {
  for (std::size_t k = 0; k < joints.size(); ++k) {
    const auto interface = static_cast<int>(k);
    const Real gap = chatter.negligible_gap() * half_width_of<Real>(stack.blocks, interface);
    if (!joints[k].touches() && !stack.soft(k)) land_negligible(stack, bodies, interface, gap, joints);
    if (chatter.negligibly_open(joints[k], relative_angle(bodies.at, k), relative_angle(bodies.rate, k)))
      joints[k].touch = Touch::flat;
  }
}

/// Changes joints as the courses that end say; true where blocks meet.
template <class Real>
bool apply(const FirstChange<Real>& found, const BasicFrictionStack<Real>& stack,
           const BasicBodies<Real>& bodies, Joints<Real>& joints) {
  bool meets = false;
  for (const Course<Real>& course : found.courses) {
    BasicJoint<Real>& joint = joints[static_cast<std::size_t>(course.interface)];
    switch (course.change) {
      case Change::closing:
        joint.touch = Touch::flat;
        meets = true;
        break;
      case Change::landing:
        if (!joint.touches()) land(stack, bodies, course.interface, course.below, joints);
        meets = true;
        break;
      case Change::corner:
        if (pass_corner(stack, bodies, course.interface, joints)) meets = true;
        break;
      case Change::halt:
        joint.slip = 0;
        break;
      default:
        break;
    }
  }
  return meets;
}

}  // namespace rockstack
