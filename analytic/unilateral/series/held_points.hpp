#pragma once

#include "analytic/unilateral/contact/contact_problem.hpp"
#include "analytic/unilateral/series/mode_series.hpp"

namespace rockstack {

/// A point that a joint holds, while series grow: its gap stays as it is, and where it sticks its place along
/// the face as well. Each order is known first but for what the bodies' own coefficients will add.
template <class Real>
class HeldPoint {
 public:
  /// `face` and `body` have their orders 0 and 1.
  HeldPoint(const ContactModel<Real>& stack, const CornerOnFace<Real>& corner, const BodySeries<Real>* face,
            const BodySeries<Real>* body, bool sticks)
      : point_(stack, corner, face, body), sticks_(sticks) {
    point_.extend(0);
    point_.extend(1);
    point_.place.above.terms = 1;
    if (sticks) point_.place.along.terms = 1;
  }

  std::size_t interface() const { return point_.interface(); }
  const GrowingPoint<Real>& point() const { return point_; }

  /// Coefficient m of places and m − 2 of the force. What is left of the gap, and of the slip where it
  /// sticks, bodies have to take away.
  void begin(const ForceSeries<Real>& force, std::size_t m) {
    point_.extend_force(force, m - 2);
    if (sticks_) {
      // What is at one place has no lower orders apart, so that turning it leaves the start's axes alone.
      const Point<Real> at{point_.place.along[0], point_.place.above[0]};
      const PlaneCoefficient<Real> upper = turned(*point_.body, point_.body_arm, m);
      const PlaneCoefficient<Real> lower = turned(*point_.face, at, m);
      const Real x = upper.x - lower.x, y = upper.y - lower.y;
      left_ = {x * sine() + y * cosine(), x * cosine() - y * sine()};
    } else {
      point_.extend_apart(m);
      left_ = on_face(point_.apart_x, point_.apart_y, *point_.face, m);
    }
  }
  FaceCoefficient<Real> left() const {
    return {point_.corner.upward * left_.across, point_.corner.upward * left_.along};
  }

  /// The same coefficients, of bodies and of the force, as they are.
  void end(const ForceSeries<Real>& force, std::size_t m) {
    const Real normal = point_.corner.upward * force.normal[m - 2];
    const Real tangential = point_.corner.upward * force.tangential[m - 2];
    point_.force_x[m - 2] += normal * sine() + tangential * cosine();
    point_.force_y[m - 2] += normal * cosine() - tangential * sine();
    if (sticks_) {
      const PlaneCoefficient<Real> arm = turned(*point_.body, point_.body_arm, m);
      put(point_.arm_x, m, arm.x);
      put(point_.arm_y, m, arm.y);
      return;
    }
    const Real x = point_.apart_x[m], y = point_.apart_y[m];
    point_.extend_apart(m);
    put(point_.place.along, m,
        left_.along + (point_.apart_x[m] - x) * cosine() - (point_.apart_y[m] - y) * sine() -
            coefficient(point_.face->angle, m) * point_.place.above[0]);
  }

 private:
  const Real& cosine() const { return point_.face->cosine[0]; }
  const Real& sine() const { return point_.face->sine[0]; }

  GrowingPoint<Real> point_;
  bool sticks_;
  FaceCoefficient<Real> left_{};
};

/// What the joints of a mode hold: the equations of respond(), which each order of a step's series solves.
template <class Real>
class HeldRows {
 public:
  explicit HeldRows(const ContactModel<Real>& stack) : stack_(stack), entries_(3 * stack.blocks.size()) {}

  /// The joint of an interface, whose held point is `point` of the series and has these rows at the start.
  void add(const Joint<Real>& joint, std::size_t point, const ContactKinematics<Real>& rows,
           std::size_t interface) {
    const Row row{Kind::gap, joint.slip, interface, point};
    const auto k = static_cast<int>(interface);
    if (joint.touch == Contact::closed) {
      // Turned by its half-width, all rows are of one unit.
      const FreeRow<Real> turn = angle_row(stack_, k, stack_.half_width(k));
      push({Kind::turn, row.sliding, interface, point}, turn, turn);
    }
    push(row, rows.gap_row, rows.gap_row - joint.slip * stack_.friction[interface] * rows.slip_row);
    if (joint.slip == 0) push({Kind::slip, 0, interface, point}, rows.slip_row, rows.slip_row);
  }

  void prepare() {
    const std::size_t size = rows_.size();
    NumberTable<Real> matrix(size, size);
    for (std::size_t i = 0; i < size; ++i)
      for (std::size_t j = 0; j < size; ++j) matrix(i, j) = dot(i, of_row(effects_, j));
    system_ = LinearSystem<Real>(std::move(matrix), size);
  }

  /// Changes coefficient n of accelerations so that what is held stays zero at order n + 2, and notes the
  /// forces that do it.
  template <class Points>
  void constrain(const Points& points, std::size_t n, FreeVector<Real>& motion,
                 ShortVector<ForceSeries<Real>>& forces) const {
    const std::size_t size = rows_.size();
    if (size == 0) return;
    const Real factor = Real(n + 2) * Real(n + 1);
    ShortNumbers<Real> violation(size);
    for (std::size_t i = 0; i < size; ++i) {
      Real sum = dot(i, motion.data());
      const Row& row = rows_[i];
      if (row.kind != Kind::turn) {
        const FaceCoefficient<Real> left = points[row.point].left();
        sum += factor * (row.kind == Kind::gap ? left.across : left.along);
      }
      violation[i] = -sum;
    }
    const ShortNumbers<Real> unknowns = system_.solve(violation);
    for (std::size_t i = 0; i < size; ++i) {
      const Real value = unknowns[i];
      const Real* effect = of_row(effects_, i);
      Real* moved = motion.data();
      for (std::size_t block = 0; block < entries_; block += 3, effect += 3, moved += 3)
        for (std::size_t e = 0; e < 3; ++e) moved[e] += value * effect[e];
      note_force(rows_[i], unknowns[i], n, forces);
    }
  }

 private:
  enum class Kind { turn, gap, slip };
  struct Row {
    Kind kind;
    int sliding;
    std::size_t interface;
    std::size_t point;
  };
  using Entries = ShortVector<Real, 144>;  ///< row by row

  void push(const Row& row, const FreeRow<Real>& gradient, const FreeRow<Real>& action) {
    rows_.push_back(row);
    for (std::size_t e = 0; e < entries_; ++e) {
      jacobian_.push_back(gradient[e]);
      effects_.push_back(stack_.inverse_mass[e] * action[e]);
    }
  }
  const Real* of_row(const Entries& entries, std::size_t row) const {
    return entries.begin() + row * entries_;
  }
  Real dot(std::size_t row, const Real* vector) const {
    const Real* gradient = of_row(jacobian_, row);
    Real sum = 0;
    for (std::size_t block = 0; block < entries_; block += 3, gradient += 3, vector += 3)
      for (std::size_t e = 0; e < 3; ++e) sum += gradient[e] * vector[e];
    return sum;
  }

  void note_force(const Row& row, const Real& value, std::size_t n,
                  ShortVector<ForceSeries<Real>>& forces) const {
    const std::size_t k = row.interface;
    ForceSeries<Real>& force = forces[k];
    switch (row.kind) {
      case Kind::turn:
        put(force.moment, n, value * Real(stack_.blocks[k].half_width));
        break;
      case Kind::gap:
        put(force.normal, n, value);
        if (row.sliding != 0) put(force.tangential, n, -row.sliding * stack_.friction[k] * value);
        break;
      case Kind::slip:
        put(force.tangential, n, value);
        break;
    }
  }

  const ContactModel<Real>& stack_;
  std::size_t entries_;  ///< of a row
  ShortVector<Row, 12> rows_;
  Entries jacobian_, effects_;
  LinearSystem<Real> system_;
};

}  // namespace rockstack
