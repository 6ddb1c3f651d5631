#pragma once

#include "analytic/unilateral/contact/contact_model.hpp"

namespace rockstack {

/// The distance of a point from a face and its place along it, upper against lower body, with their jacobian
/// and with the second derivatives that velocities alone make. m, m/s².
template <class Real = double>
struct ContactKinematics {
  Real gap = 0, slip = 0, gap_bias = 0, slip_bias = 0;
  FreeRow<Real> gap_row, slip_row;
};

/// A body vector turned clockwise by an angle.
template <class Real>
Point<Real> turned(const Point<Real>& vector, const Real& angle) {
  if (angle == 0) return vector;  // as all of the ground
  return turned<Real>(vector.x(), vector.y(), cos(angle), sin(angle));
}

/// Adds what pushes alone make of free blocks: accelerations, or velocities of impulses.
template <class Real>
void add_pushes(const ContactModel<Real>& stack, const Bodies<Real>& bodies, const Loading<Real>& loading,
                FreeVector<Real>& free) {
  const auto turn = [&](int k, const Point<Real>& arm) { return turned<Real>(arm, bodies.pose[k].angle); };
  each_push(stack.pushes, loading, turn, [&](int k, const Point<Real>& force, const Real& moment) {
    const Eigen::Index at = Eigen::Index{3} * k;
    const Eigen::Matrix<Real, 3, 1> effect(force.x(), force.y(), moment);
    free.template segment<3>(at) += stack.inverse_mass.template segment<3>(at).cwiseProduct(effect);
  });
}

/// Adds what restraints alone make of free blocks.
template <class Real>
void add_restraints(const ContactModel<Real>& stack, const Bodies<Real>& bodies, FreeVector<Real>& free) {
  const auto motion_of = [&](int k, const Point<Real>& own) -> PointMotion<Real> {
    const Pose<Real> at = pose_of(bodies.pose, k), rate = pose_of(bodies.velocity, k);
    const Point<Real> arm = turned<Real>(own, at.angle);
    return {Point<Real>(at.x, at.y) + arm, Point<Real>(rate.x, rate.y) + rate.angle * quarter_turned(arm),
            arm};
  };
  each_restraint(stack.restraints, motion_of, [&](int k, const Point<Real>& force, const Real& moment) {
    const Eigen::Index at = Eigen::Index{3} * k;
    const Eigen::Matrix<Real, 3, 1> effect(force.x(), force.y(), moment);
    free.template segment<3>(at) += stack.inverse_mass.template segment<3>(at).cwiseProduct(effect);
  });
}

template <class Real>
ContactKinematics<Real> kinematics_of(const ContactModel<Real>& stack, const Bodies<Real>& bodies,
                                      const CornerOnFace<Real>& corner) {
  using Plane = Point<Real>;
  const Pose<Real> face = pose_of(bodies.pose, corner.face),
                   face_rate = pose_of(bodies.velocity, corner.face);
  const Pose<Real> body = pose_of(bodies.pose, corner.body),
                   body_rate = pose_of(bodies.velocity, corner.body);
  const Plane tangent = turned<Real>({Real(1), Real(0)}, face.angle);
  const Plane normal(-tangent.y(), tangent.x());
  const Plane arm = turned<Real>(Plane(corner.x, corner.y) - stack.centre(corner.body), body.angle);
  const Plane turn = quarter_turned(arm);
  const Plane apart = Plane(body.x - face.x, body.y - face.y) + arm;
  const Plane speed = Plane(body_rate.x - face_rate.x, body_rate.y - face_rate.y) + turn * body_rate.angle;
  const Plane bend = -arm * (body_rate.angle * body_rate.angle);
  // From the centre of mass of the face's body.
  const Real along = apart.dot(tangent), above = apart.dot(normal);
  const Plane centre = stack.centre(corner.face);
  const Real turning = face_rate.angle;
  const Real along_rate = speed.dot(tangent) - turning * above;
  const Real above_rate = speed.dot(normal) + turning * along;
  const Real sign = corner.upward;
  ContactKinematics<Real> rows;
  rows.gap = sign * (above + centre.y()) - stack.half_height(corner.face);
  rows.slip = sign * (along + centre.x());
  rows.gap_bias = sign * (bend.dot(normal) + turning * speed.dot(tangent) + turning * along_rate);
  rows.slip_bias = sign * (bend.dot(tangent) - turning * speed.dot(normal) - turning * above_rate);
  rows.gap_row = rows.slip_row = FreeRow<Real>::Zero(Eigen::Index{3} * stack.size());
  const auto set = [](FreeRow<Real>& row, int at, const Real& x, const Real& y, const Real& angle) {
    Real* entries = row.data() + Eigen::Index{3} * at;
    entries[0] = x;
    entries[1] = y;
    entries[2] = angle;
  };
  if (corner.body >= 0) {
    set(rows.gap_row, corner.body, sign * normal.x(), sign * normal.y(), sign * normal.dot(turn));
    set(rows.slip_row, corner.body, sign * tangent.x(), sign * tangent.y(), sign * tangent.dot(turn));
  }
  if (corner.face >= 0) {
    set(rows.gap_row, corner.face, -sign * normal.x(), -sign * normal.y(), sign * along);
    set(rows.slip_row, corner.face, -sign * tangent.x(), -sign * tangent.y(), -sign * above);
  }
  return rows;
}

/// Kinematics of the point that a joint holds.
template <class Real>
ContactKinematics<Real> kinematics_of(const ContactModel<Real>& stack, const Bodies<Real>& bodies,
                                      int interface, const Joint<Real>& joint) {
  return kinematics_of(stack, bodies, stack.held_point(interface, joint));
}

/// How a joint's slip coordinate, that of its held point, differs from its offset.
template <class Real>
Real slip_from_offset(const ContactModel<Real>& stack, int interface, const Joint<Real>& joint) {
  if (joint.corner_below && joint.pivots()) return -joint.side() * stack.half_width(interface - 1);
  return joint.side() * stack.half_width(interface);
}

/// The offset of a joint that touches, from where its held point is.
template <class Real>
Real offset_of(const ContactModel<Real>& stack, const Bodies<Real>& bodies, int interface,
               const Joint<Real>& joint) {
  return kinematics_of(stack, bodies, interface, joint).slip - slip_from_offset(stack, interface, joint);
}

/// Puts the upper block of an interface exactly onto its joint, at its offset, with this slip rate.
template <class Real>
void place_upper(const ContactModel<Real>& stack, const Joint<Real>& joint, int k, const Real& slip_rate,
                 Bodies<Real>& bodies) {
  using Plane = Point<Real>;
  const CornerOnFace<Real> point = stack.held_point(k, joint);
  const Pose<Real> lower = pose_of(bodies.pose, k - 1), lower_rate = pose_of(bodies.velocity, k - 1);
  Pose<Real>& upper = bodies.pose[k];
  Pose<Real>& upper_rate = bodies.velocity[k];
  if (joint.touch == Contact::closed) {
    upper.angle = lower.angle;
    upper_rate.angle = lower_rate.angle;
  }
  const Real lower_top = stack.half_height(k - 1), upper_bottom = -stack.half_height(k);
  const bool below = point.upward < 0;
  // The contact point from the middle of either block.
  const Real on_upper = below ? Real(point.x - joint.offset) : point.x;
  const Real on_lower = below ? point.x : Real(point.x + joint.offset);
  const Plane lower_arm = turned<Real>(Plane(on_lower, lower_top) - stack.centre(k - 1), lower.angle);
  const Plane upper_arm = turned<Real>(Plane(on_upper, upper_bottom) - stack.centre(k), upper.angle);
  upper.x = lower.x + (lower_arm.x() - upper_arm.x());
  upper.y = lower.y + (lower_arm.y() - upper_arm.y());
  Plane change = quarter_turned(lower_arm) * lower_rate.angle - quarter_turned(upper_arm) * upper_rate.angle;
  if (slip_rate != 0) change += turned<Real>({slip_rate, Real(0)}, below ? upper.angle : lower.angle);
  upper_rate.x = lower_rate.x + change.x();
  upper_rate.y = lower_rate.y + change.y();
}

/// Puts every block that touches exactly onto its joint: sticking at its offset, sliding at the offset that
/// it has reached, which it notes. Velocities likewise. So roundings of the motion do not add up to gaps.
template <class Real>
void place(const ContactModel<Real>& stack, Joints<Real>& joints, Bodies<Real>& bodies) {
  for (int k = 0; k < stack.size(); ++k) {
    Joint<Real>& joint = joints[k];
    if (!joint.touches()) continue;
    Real slip_rate = 0;
    if (joint.slip != 0) {
      const ContactKinematics<Real> rows = kinematics_of(stack, bodies, k, joint);
      slip_rate = rows.slip_row.dot(vector_of(bodies.velocity));
      joint.offset = rows.slip - slip_from_offset(stack, k, joint);
    }
    place_upper(stack, joint, k, slip_rate, bodies);
  }
}

}  // namespace rockstack
