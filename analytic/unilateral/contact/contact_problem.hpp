#pragma once

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "analytic/unilateral/contact/contact_kinematics.hpp"
#include "analytic/unilateral/contact/contact_model.hpp"

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

/// What one interface does to the block above it: forces in N and N·m, or impulses; the moment is about its
/// held point, and that of a pivot is zero.
template <class Real>
struct BasicContactForce {
  Real normal = 0, tangential = 0, moment = 0;
};

/// What a mode leads to.
template <class Real>
struct BasicModeResponse {
  BasicFreeVector<Real> motion;
  std::vector<BasicContactForce<Real>> forces;
};

using ModeResponse = BasicModeResponse<double>;

/// What joints hold, as equations for what holds it.
template <class Real>
ContactProblem<Real> held_by(const BasicFrictionStack<Real>& stack, const Joints<Real>& joints,
                             const BasicBodies<Real>& bodies, Sought sought) {
  ContactProblem<Real> problem;
  const Real bias = sought == Sought::accelerations ? 1 : 0;
  for (int k = 0; k < stack.size(); ++k) {
    const auto index = static_cast<std::size_t>(k);
    const BasicJoint<Real>& joint = joints[index];
    if (!joint.touches()) continue;
    const BasicPointRows<Real> rows = rows_of(stack.blocks, bodies, held_point(stack.blocks, k, joint));
    // Turned by its half-width, all rows are of one unit.
    const FreeRow<Real> turn = angle_row(stack, k, half_width_of<Real>(stack.blocks, k));
    if (joint.touch == Touch::flat) problem.add(turn, turn, 0);
    problem.add(rows.gap_row, rows.gap_row - joint.slip * stack.friction[index] * rows.slip_row,
                bias * rows.gap_bias);
    if (joint.slip == 0) problem.add(rows.slip_row, rows.slip_row, bias * rows.slip_bias);
  }
  return problem;
}

/// The motion that is left of a free one where joints hold as they say.
template <class Real>
BasicModeResponse<Real> respond(const BasicFrictionStack<Real>& stack, const Joints<Real>& joints,
                                const BasicBodies<Real>& bodies, const BasicFreeVector<Real>& free,
                                Sought sought) {
  const ContactProblem<Real> problem = held_by(stack, joints, bodies, sought);
  BasicModeResponse<Real> response{free, std::vector<BasicContactForce<Real>>(joints.size())};
  if (problem.size() == 0) return response;
  const BasicFreeVector<Real> forces =
      Eigen::PartialPivLU<SquareMatrix<Real>>(problem.matrix(stack)).solve(-problem.free(free));
  for (Eigen::Index i = 0; i < forces.size(); ++i)
    response.motion +=
        forces[i] * stack.inverse_mass.cwiseProduct(problem.actions[static_cast<std::size_t>(i)].transpose());
  Eigen::Index at = 0;
  for (std::size_t k = 0; k < joints.size(); ++k) {
    if (!joints[k].touches()) continue;
    BasicContactForce<Real>& force = response.forces[k];
    if (joints[k].touch == Touch::flat) force.moment = forces[at++] * Real(stack.blocks[k].half_width);
    force.normal = forces[at++];
    force.tangential =
        joints[k].slip == 0 ? Real(forces[at++]) : Real(-joints[k].slip * stack.friction[k] * force.normal);
  }
  return response;
}

/// A rounding over what it makes of contact forces, in shares of them, of a stack that stands and sticks: the
/// reciprocal condition number, by largest rows' sums, of what forces do, each in the unit of its own effect.
template <class Real>
Real conditioning(const BasicFrictionStack<Real>& stack) {
  Joints<Real> joints(stack.blocks.size());
  BasicBodies<Real> bodies{Placements<Real>(joints.size()), Placements<Real>(joints.size())};
  place(stack.blocks, joints, bodies);
  const SquareMatrix<Real> effects = held_by(stack, joints, bodies, Sought::velocities).matrix(stack);
  const BasicFreeVector<Real> units = effects.diagonal().cwiseSqrt().cwiseInverse();
  const SquareMatrix<Real> scaled = units.asDiagonal() * effects * units.asDiagonal();
  const SquareMatrix<Real> inverse = Eigen::PartialPivLU<SquareMatrix<Real>>(scaled).inverse();
  const auto size = [](const SquareMatrix<Real>& matrix) {
    return matrix.cwiseAbs().rowwise().sum().maxCoeff();
  };
  return 1 / (size(scaled) * size(inverse));
}

/// A rounding of places over what it makes of the smallest half-size, in shares of that.
template <class Real>
Real fineness(const BasicFrictionStack<Real>& stack) {
  Real height = 0;
  Real smallest = std::numeric_limits<Real>::infinity();
  for (const Block& block : stack.blocks) {
    height += 2 * block.half_height;
    smallest = std::min<Real>(smallest, std::min(block.half_width, block.half_height));
  }
  return smallest / height;
}

/// Whether contact forces and sizes keep so many digits of a number type.
template <class Real>
bool keeps_digits(const BasicFrictionStack<Real>& stack, int digits) {
  using std::pow;
  return std::min(conditioning(stack), fineness(stack)) >=
         pow(Real(10), digits) * std::numeric_limits<Real>::epsilon();
}

/// @throws std::domain_error where masses or sizes are so far apart that contact forces or sizes keep fewer
/// than six digits.
template <class Real>
void require_digits(const BasicFrictionStack<Real>& stack) {
  if (!keeps_digits(stack, 6))
    throw std::domain_error(
        "block masses or sizes are too far apart: rounding would leave contact forces fewer than six digits");
}

}  // namespace rockstack
