#pragma once

#include <Eigen/LU>

#include "analytic/unilateral/contact/contact_problem.hpp"
#include "analytic/unilateral/series/point_series.hpp"

namespace rockstack {

/// What the joints of a mode hold: the equations of respond(), which each order of a step's series solves.
template <class Real>
class HeldRows {
 public:
  explicit HeldRows(const BasicFrictionStack<Real>& stack) : stack_(stack) {}

  /// The joint of an interface, whose held point is `point` of the series and has these rows at the start.
  void add(const BasicJoint<Real>& joint, std::size_t point, const BasicPointRows<Real>& rows,
           std::size_t interface) {
    const Row row{Kind::gap, joint.slip, interface, point};
    const auto k = static_cast<int>(interface);
    if (joint.touch == Touch::flat) {
      // Turned by its half-width, all rows are of one unit.
      const FreeRow<Real> turn = angle_row(stack_, k, half_width_of<Real>(stack_.blocks, k));
      push({Kind::turn, row.sliding, interface, point}, turn, turn);
    }
    push(row, rows.gap_row, rows.gap_row - joint.slip * stack_.friction[interface] * rows.slip_row);
    if (joint.slip == 0) push({Kind::slip, 0, interface, point}, rows.slip_row, rows.slip_row);
  }

  void prepare() {
    const auto size = static_cast<Eigen::Index>(rows_.size());
    if (size == 0) return;
    SquareMatrix<Real> matrix(size, size);
    for (Eigen::Index i = 0; i < size; ++i)
      for (Eigen::Index j = 0; j < size; ++j)
        matrix(i, j) = gradients_[static_cast<std::size_t>(i)].dot(effects_[static_cast<std::size_t>(j)]);
    lu_.compute(matrix);
  }

  /// Changes coefficient n of accelerations so that what is held stays zero at order n + 2, and notes the
  /// forces that do it.
  void constrain(const std::vector<GrowingPoint<Real>>& points, std::size_t n, BasicFreeVector<Real>& motion,
                 std::vector<ForceSeries<Real>>& forces) const {
    if (rows_.empty()) return;
    const Real factor = Real(n + 2) * Real(n + 1);
    const auto size = static_cast<Eigen::Index>(rows_.size());
    BasicFreeVector<Real> violation(size);
    for (Eigen::Index i = 0; i < size; ++i) {
      const auto row = static_cast<std::size_t>(i);
      violation[i] = gradients_[row].dot(motion) + factor * known(rows_[row], points, n + 2);
    }
    const BasicFreeVector<Real> unknowns = lu_.solve(-violation);
    for (Eigen::Index i = 0; i < size; ++i) motion += unknowns[i] * effects_[static_cast<std::size_t>(i)];
    for (std::size_t i = 0; i < rows_.size(); ++i)
      note_force(rows_[i], unknowns[static_cast<Eigen::Index>(i)], n, forces);
  }

 private:
  enum class Kind { turn, gap, slip };
  struct Row {
    Kind kind;
    int sliding;
    std::size_t interface;
    std::size_t point;
  };

  void push(const Row& row, const FreeRow<Real>& gradient, const FreeRow<Real>& action) {
    rows_.push_back(row);
    gradients_.push_back(gradient);
    effects_.emplace_back(stack_.inverse_mass.cwiseProduct(action.transpose()));
  }

  /// What is known of coefficient m of what a row holds.
  static Real known(const Row& row, const std::vector<GrowingPoint<Real>>& points, std::size_t m) {
    const GrowingPoint<Real>& point = points[row.point];
    if (row.kind == Kind::turn) return 0;
    return point.corner.upward * (row.kind == Kind::gap ? point.place.above[m] : point.place.along[m]);
  }

  void note_force(const Row& row, const Real& value, std::size_t n,
                  std::vector<ForceSeries<Real>>& forces) const {
    const std::size_t k = row.interface;
    ForceSeries<Real>& force = forces[k];
    switch (row.kind) {
      case Kind::turn:
        force.moment[n] = value * Real(stack_.blocks[k].half_width);
        break;
      case Kind::gap:
        force.normal[n] = value;
        if (row.sliding != 0) force.tangential[n] = -row.sliding * stack_.friction[k] * value;
        break;
      case Kind::slip:
        force.tangential[n] = value;
        break;
    }
  }

  const BasicFrictionStack<Real>& stack_;
  std::vector<Row> rows_;
  std::vector<FreeRow<Real>> gradients_;
  std::vector<BasicFreeVector<Real>> effects_;
  Eigen::PartialPivLU<SquareMatrix<Real>> lu_;
};

}  // namespace rockstack
