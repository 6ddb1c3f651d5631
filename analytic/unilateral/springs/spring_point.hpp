#pragma once

#include "analytic/unilateral/contact/contact_kinematics.hpp"
#include "analytic/unilateral/springs/winkler_bed.hpp"

namespace rockstack {

/// Whether a corner pushes: not off its face, nor where it leaves a spring behind that would have to pull.
enum class Press : std::int8_t { off, left_behind, pushing };

/// An end of an interface with a spring and a dashpot across the face, N = max(0, kδ + cδ̇) where the depth δ
/// is above zero, and along it a spring and a dashpot beside each other, before a slider of strength μN:
///
///     |k_t τ + c_t τ̇| ≤ μN,  the slider stands still where it is less, and moves with the force else,
///
/// τ how far the tangential spring is stretched. The slider is at slip − τ, where the slip is the corner's.
/// Or the middle of a Winkler bed, with its normal force and with one slider for all of it.
template <class Real>
struct SpringPoint {
  int interface = 0;          ///< from 0
  int side = 0;               ///< −1 left end, 1 right end; 0 a bed
  bool corner_below = false;  ///< it is of the block below, under the face of the one above
  Press press = Press::off;
  int slide = 0;  ///< the way the slider moves, of the block above against the one below; 0: it stands still
  Real slider = 0;  ///< its place on the slip coordinate, m

  bool at_face = false;  ///< the depth is zero by the event that has just been, however it rounds

  BedState bed = {};  ///< of a bed alone

  bool is_bed() const { return side == 0; }
  bool pushes() const { return press == Press::pushing; }
  void move_on() {
    at_face = bed.at_crossing = false;
    for (BedEnd& end : bed.ends) end.at_face = false;
  }
};

template <class Real>
using SpringPoints = std::vector<SpringPoint<Real>>;

template <class Real>
CornerOnFace<Real> corner_of(const ContactModel<Real>& stack, const SpringPoint<Real>& point) {
  return stack.corner(point.interface, point.side, point.corner_below);
}

template <class Real>
ContactKinematics<Real> kinematics_of(const ContactModel<Real>& stack, const Bodies<Real>& bodies,
                                      const SpringPoint<Real>& point) {
  return kinematics_of(stack, bodies, corner_of(stack, point));
}

/// An end of a bed, 0 left or 1 right, against the face of the other block.
template <class Real>
CornerOnFace<Real> bed_corner(const ContactModel<Real>& stack, const SpringPoint<Real>& point,
                              std::size_t end) {
  return stack.corner(point.interface, end == 0 ? -1 : 1, point.corner_below);
}

template <class Real>
std::array<ContactKinematics<Real>, 2> bed_rows(const ContactModel<Real>& stack,
                                                const SpringPoint<Real>& point, const Bodies<Real>& bodies) {
  return {kinematics_of(stack, bodies, bed_corner(stack, point, 0)),
          kinematics_of(stack, bodies, bed_corner(stack, point, 1))};
}

/// A bed at one instant.
template <class Real>
GrowingBed<Real> bed_at(const ContactModel<Real>& stack, const SpringPoint<Real>& point,
                        const Bodies<Real>& bodies) {
  const SpringLaw<Real>& law = stack.springs[point.interface];
  const auto rows = bed_rows(stack, point, bodies);
  const FreeVector<Real> rates = vector_of(bodies.velocity);
  GrowingBed<Real> bed;
  bed.stretch = stretch_of(point.bed);
  for (std::size_t end = 0; end < 2; ++end) {
    put(bed.depth[end], 0, -rows[end].gap);
    put(bed.pressure[end], 0, -(law.stiffness * rows[end].gap + law.damping * rows[end].gap_row.dot(rates)));
  }
  bed.extend(0);
  return bed;
}

/// What a point that pushes does to the block above, N, across and along the face; and the couple of a bed.
template <class Real>
struct PointForce {
  Real normal, tangential;
  Real couple = 0;
};

template <class Real>
PointForce<Real> force_of(const ContactModel<Real>& stack, const SpringPoint<Real>& point,
                          const Bodies<Real>& bodies, const ContactKinematics<Real>& rows) {
  if (!point.pushes()) return {0, 0};
  const SpringLaw<Real>& law = stack.springs[point.interface];
  const FreeVector<Real> rates = vector_of(bodies.velocity);
  PointForce<Real> force{-(law.stiffness * rows.gap + law.damping * rows.gap_row.dot(rates)), 0};
  if (point.is_bed()) {
    const GrowingBed<Real> bed = bed_at(stack, point, bodies);
    force = {bed.normal[0], 0, bed.couple[0]};
  }
  if (point.slide != 0) {
    force.tangential = -point.slide * law.friction * force.normal;
  } else if (law.friction > 0) {
    force.tangential = -(law.tangential_stiffness * (rows.slip - point.slider) +
                         law.tangential_damping * rows.slip_row.dot(rates));
  }
  return force;
}

/// The forces of all points on bodies, and moments.
template <class Real>
FreeVector<Real> forces_of(const ContactModel<Real>& stack, const SpringPoints<Real>& points,
                           const Bodies<Real>& bodies) {
  FreeVector<Real> forces = FreeVector<Real>::Zero(Eigen::Index{3} * stack.size());
  for (const SpringPoint<Real>& point : points) {
    if (!point.pushes()) continue;
    const ContactKinematics<Real> rows = kinematics_of(stack, bodies, point);
    const PointForce<Real> force = force_of(stack, point, bodies, rows);
    forces += force.normal * rows.gap_row.transpose() + force.tangential * rows.slip_row.transpose();
    if (!point.is_bed()) continue;
    const auto ends = bed_rows(stack, point, bodies);
    forces += force.couple * (ends[1].gap_row - ends[0].gap_row).transpose();
  }
  return forces;
}

/// No oscillation of the stack on points that push is faster than this, and nothing dies out faster, 1/s:
/// from the trace of M⁻¹K and that of M⁻¹C; and k/c, by which a stretch relaxes while its slider moves.
template <class Real>
Real fastest_rate(const ContactModel<Real>& stack, const SpringPoints<Real>& points,
                  const Bodies<Real>& bodies) {
  Real square = 0, damped = 0, relaxing = 0;
  for (const SpringPoint<Real>& point : points) {
    if (!point.pushes()) continue;
    const SpringLaw<Real>& law = stack.springs[point.interface];
    const ContactKinematics<Real> rows = kinematics_of(stack, bodies, point);
    Real across = stack.effect(rows.gap_row, rows.gap_row);
    if (point.is_bed()) {
      const auto ends = bed_rows(stack, point, bodies);
      const Eigen::Matrix<Real, 1, Eigen::Dynamic> turning = (ends[1].gap_row - ends[0].gap_row) / 2;
      across += stack.effect(turning, turning) / 3;
    }
    Real along = law.friction == 0 ? Real(0) : stack.effect(rows.slip_row, rows.slip_row);
    if (point.slide != 0) {
      along = 0;
      const Real coupled = law.friction * abs(stack.effect(rows.gap_row, rows.slip_row));
      square += law.stiffness * coupled;
      damped += law.damping * coupled;
      if (law.damping > 0) relaxing = std::max<Real>(relaxing, law.stiffness / law.damping);
    }
    square += law.stiffness * across + law.tangential_stiffness * along;
    damped += law.damping * across + law.tangential_damping * along;
  }
  return std::max<Real>({sqrt(square), damped, relaxing});
}

}  // namespace rockstack
