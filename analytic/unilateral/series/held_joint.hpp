#pragma once

#include "analytic/unilateral/contact/linear_system.hpp"
#include "analytic/unilateral/series/mode_series.hpp"

namespace rockstack {

/// What a joint that touches holds, while series grow: the gap of its point, where it sticks its place along
/// the face as well, and where it is flat the angle between the blocks. Each order is known first but for
/// what the bodies' own coefficients will add. The equations are those of respond().
template <class Real>
class HeldJoint {
 public:
  /// What is held: a gradient over the blocks below, zeros of the ground, and above; what unit forces do.
  struct Row {
    Eigen::Matrix<Real, 6, 1> gradient, effect;
    int first;  ///< where the body below is in a ChainVector
    Real left;  ///< by what bodies have to change it

    Real dot(const ChainVector<Real>& motion) const {
      const Real* around = &motion[first];
      Real sum = 0;
      if (first > 0)  // else there is the ground below
        for (int e = 0; e < 3; ++e) sum += gradient[e] * around[e];
      for (int e = 3; e < 6; ++e) sum += gradient[e] * around[e];
      return sum;
    }
    /// Product of this gradient and the effect of another row.
    Real dot(const Row& other) const {
      const int shift = first - other.first;
      Real sum = 0;
      for (int e = std::max(0, -shift), end = std::min(6, 6 - shift); e < end; ++e)
        sum += gradient[e] * other.effect[e + shift];
      return sum;
    }
    void act(const Real& force, ChainVector<Real>& motion) const {
      Eigen::Map<Eigen::Matrix<Real, 6, 1>>{&motion[first]} += force * effect;
    }
  };

  HeldJoint() {}  // of a list that has room for it

  /// Bodies have their order 0.
  void start(const ContactModel<Real>& stack, const Joint<Real>& joint, std::size_t interface,
             const ModeSeries<Real>& series) {
    point_ = {stack, series, stack.held_point(static_cast<int>(interface), joint)};
    interface_ = interface;
    flat_ = joint.touch == Contact::closed;
    slip_ = joint.slip;
    friction_ = stack.kinetic_friction[interface];
    half_width_ = stack.blocks[interface].half_width;
    for (Row& row : rows_) row.first = 3 * static_cast<int>(interface);
    rows_[0].left = 0;
    point_.extend(0);
    add_rows(stack);
  }

  std::size_t interface() const { return interface_; }
  const GrowingPoint<Real>& point() const { return point_; }
  bool sticks() const { return slip_ == 0; }
  bool flat() const { return flat_; }

  /// Calls f of each row.
  template <class F>
  void each_row(const F& f) const {
    if (flat()) f(rows_[0]);
    f(rows_[1]);
    if (sticks()) f(rows_[2]);
  }

  /// Bodies have their order 1.
  void begin() {
    if (sticks()) return extend_arm(1);
    point_.extend(1);
    point_.place[1].x() = 0;
  }

  /// Coefficient m of places and m − 2 of the force; what bodies have to take from the gap and the slip.
  void begin(const ForceSeries<Real>& force, std::size_t m) {
    point_.extend_force(force, m - 2, m - 2);
    Point<Real> left;
    if (sticks()) {
      // What is at one place has no lower orders apart, so that turning it leaves the start's axes alone.
      const Point<Real> at{point_.place[0].y(), point_.place[0].x()};
      Point<Real> apart = turned(*point_.body, point_.body_arm, m);
      if (point_.corner.face >= 0) apart -= turned(*point_.face, at, m);
      left = apart.x() * point_.face->up[0] + apart.y() * point_.face->along[0];
    } else {
      extend_arm(m);
      point_.apart[m] = point_.arm[m];
      left = on_face(point_.apart, m + 1, *point_.face, m);
    }
    rows_[1].left = point_.corner.upward * left.x();
    rows_[2].left = point_.corner.upward * left.y();
  }

  /// Adds coefficient n of the force as far as lower ones tell it. The lever of one place does not change.
  void add_force(const ForceSeries<Real>& force, std::size_t n, ChainVector<Real>& forces) const {
    point_.add_force(force, sticks() ? 0 : n, n, forces);
  }

  /// Takes the unknowns of its rows for coefficient n of its force; those that follow.
  const Real* note_force(const Real* unknowns, std::size_t n, ForceSeries<Real>& force) const {
    if (flat()) force.moment[n] = *unknowns++ * half_width_;
    const Real normal = force.normal[n] = *unknowns++;
    force.tangential[n] = sticks() ? *unknowns++ : -slip_ * friction_ * normal;
    return unknowns;
  }

  /// Ends these coefficients, of bodies and of the force, as they are.
  void end(const ForceSeries<Real>& force, std::size_t m) {
    const Real normal = point_.corner.upward * force.normal[m - 2];
    const Real tangential = point_.corner.upward * force.tangential[m - 2];
    point_.force[m - 2] += normal * point_.face->up[0] + tangential * point_.face->along[0];
    if (sticks()) return extend_arm(m);
    const Point<Real> apart = point_.apart[m];
    point_.extend_apart(m);
    const Point<Real> change = point_.apart[m] - apart;
    const Point<Real>& up = point_.face->up[0];  // the sine and the cosine of the face's angle
    point_.place[m] = {Real(0), point_.corner.upward * rows_[2].left + change.x() * up.y() -
                                    change.y() * up.x() - point_.face->angle[m] * point_.place[0].x()};
  }

 private:
  void extend_arm(std::size_t m) { point_.arm[m] = turned(*point_.body, point_.body_arm, m); }

  void add_rows(const ContactModel<Real>& stack) {
    const CornerOnFace<Real>& corner = point_.corner;
    const Real sign = corner.upward;
    const Point<Real> turning = quarter_turned(point_.arm[0]);
    auto& [turn, gap, slip] = rows_;
    turn.gradient << 0, 0, interface_ == 0 ? Real(0) : -half_width_, 0, 0, half_width_;
    gap.gradient.setZero();
    slip.gradient.setZero();
    const auto set = [&](Row& row, int body, const Real& side, const Point<Real>& axis, const Real& angle) {
      Real* entries = &row.gradient[body == static_cast<int>(interface_) ? 3 : 0];
      entries[0] = side * axis.x();
      entries[1] = side * axis.y();
      entries[2] = sign * angle;
    };
    const Point<Real>& normal = point_.face->up[0];
    const Point<Real>& tangent = point_.face->along[0];
    set(gap, corner.body, sign, normal, normal.dot(turning));
    set(slip, corner.body, sign, tangent, tangent.dot(turning));
    if (corner.face >= 0) {
      set(gap, corner.face, -sign, normal, point_.place[0].y());
      set(slip, corner.face, -sign, tangent, -point_.place[0].x());
    }
    Eigen::Matrix<Real, 6, 1> inverse_mass = Eigen::Matrix<Real, 6, 1>::Zero();
    const Eigen::Index first = interface_ == 0 ? 3 : 0;
    const auto of_first = 3 * static_cast<Eigen::Index>(interface_) - 3 + first;
    for (Eigen::Index e = first; e < 6; ++e) inverse_mass[e] = stack.inverse_mass[of_first + e - first];
    turn.effect = inverse_mass.cwiseProduct(turn.gradient);
    gap.effect = inverse_mass.cwiseProduct(gap.gradient - Real(slip_ * friction_) * slip.gradient);
    slip.effect = inverse_mass.cwiseProduct(slip.gradient);
  }

  GrowingPoint<Real> point_;
  std::size_t interface_;
  bool flat_;
  int slip_;
  Real friction_, half_width_;
  std::array<Row, 3> rows_;  ///< of the angle, of the gap, and of the slip
};

}  // namespace rockstack
