#pragma once

#include <utility>

#include "analytic/unilateral/contact/friction_stack.hpp"
#include "analytic/unilateral/contact/point_rows.hpp"

namespace rockstack {

// Motion and impact are one rule for free bodies: M (v' − v) = Wᵀ λ, with v' the accelerations or the
// velocities after, v those that there would be without contact, and W the gradients of gaps and slips.

/// Whether velocities or accelerations are sought: the latter have a part that velocities alone make.
enum class Sought { velocities, accelerations };

template <class Real>
using SquareMatrix = Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic>;

/// Unknowns λ with their gradients, what they do, and what else stands in their conditions W v' + bias.
template <class Real>
struct ContactProblem {
  std::vector<FreeRow<Real>> gradients, actions;
  std::vector<Real> biases;

  void add(const FreeRow<Real>& gradient, const FreeRow<Real>& action, const Real& bias) {
    gradients.push_back(gradient);
    actions.push_back(action);
    biases.push_back(bias);
  }

  Eigen::Index size() const { return static_cast<Eigen::Index>(gradients.size()); }

  /// What unit unknowns, the columns, change of conditions, the rows.
  SquareMatrix<Real> matrix(const BasicFrictionStack<Real>& stack) const {
    SquareMatrix<Real> result(size(), size());
    for (Eigen::Index i = 0; i < size(); ++i)
      for (Eigen::Index j = 0; j < size(); ++j)
        result(i, j) = (gradients[static_cast<std::size_t>(i)].array() *
                        stack.inverse_mass.transpose().array() * actions[static_cast<std::size_t>(j)].array())
                           .sum();
    return result;
  }

  /// The conditions without contact.
  BasicFreeVector<Real> free(const BasicFreeVector<Real>& motion) const {
    BasicFreeVector<Real> result(size());
    for (Eigen::Index i = 0; i < size(); ++i)
      result[i] = gradients[static_cast<std::size_t>(i)].dot(motion) + biases[static_cast<std::size_t>(i)];
    return result;
  }
};

/// The gradient of the angle between an interface's upper and lower block, times a factor.
template <class Real>
FreeRow<Real> angle_row(const BasicFrictionStack<Real>& stack, int interface, const Real& factor = 1) {
  FreeRow<Real> row = FreeRow<Real>::Zero(Eigen::Index{3} * stack.size());
  row[Eigen::Index{3} * interface + 2] = factor;
  if (interface > 0) row[Eigen::Index{3} * interface - 1] = -factor;
  return row;
}

/// The points of an interface that touches, of one or two: left end first; and its slip.
template <class Real>
struct TouchingPoints {
  int interface;
  std::vector<FreeRow<Real>> normals;
  std::vector<Real> normal_biases;
  FreeRow<Real> slip;
  Real slip_bias;
  Real friction;
};

template <class Real>
std::vector<TouchingPoints<Real>> touching_points(const BasicFrictionStack<Real>& stack,
                                                  const Joints<Real>& joints, const BasicBodies<Real>& bodies,
                                                  Sought sought) {
  std::vector<TouchingPoints<Real>> contacts;
  const Real bias = sought == Sought::accelerations ? 1 : 0;
  for (int k = 0; k < stack.size(); ++k) {
    const auto index = static_cast<std::size_t>(k);
    const BasicJoint<Real>& joint = joints[index];
    if (!joint.touches()) continue;
    const BasicPointRows<Real> rows = rows_of(stack.blocks, bodies, held_point(stack.blocks, k, joint));
    TouchingPoints<Real> contact{k, {}, {}, rows.slip_row, bias * rows.slip_bias, stack.friction[index]};
    if (joint.touch == Touch::flat) {
      const Overlap<Real> ends = overlap(stack, k, joint.offset);
      const FreeRow<Real> turn = angle_row(stack, k);
      contact.normals = {rows.gap_row - ends.left * turn, rows.gap_row - ends.right * turn};
    } else {
      contact.normals = {rows.gap_row};
    }
    contact.normal_biases.assign(contact.normals.size(), bias * rows.gap_bias);
    contacts.push_back(std::move(contact));
  }
  return contacts;
}

/// The way an interface slides: a direction, or 0 where it is to be found.
template <class Real>
int slip_before(const BasicJoint<Real>& joint, Sought sought) {
  return sought == Sought::velocities ? 0 : joint.slip;
}

}  // namespace rockstack
