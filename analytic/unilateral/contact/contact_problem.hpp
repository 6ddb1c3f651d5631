#pragma once

#include <Eigen/LU>
#include <array>

#include "analytic/unilateral/contact/contact_kinematics.hpp"

namespace rockstack {

// Motion and impact are one rule for free bodies: M (v' − v) = Wᵀ λ, with v' the accelerations or the
// velocities after, v those that there would be without contact, and W the Jacobian of gaps and slips.

/// Whether velocities, those after an impact, which bounce, or accelerations are sought: the latter have a
/// part that velocities alone make.
enum class ContactLevel { velocities, impacts, accelerations };

/// What is asked of the laws of contact at one instant: the motion that follows from the one without contact.
template <class Real = double>
struct ContactQuestion {
  const ContactModel<Real>& stack;
  const Bodies<Real>& bodies;
  const FreeVector<Real>& free;  ///< the motion without contact
  ContactLevel level;

  bool of_accelerations() const { return level == ContactLevel::accelerations; }
  /// The way an interface slides: a direction, or 0 where it is to be found.
  int slip_before(const Joint<Real>& joint) const { return of_accelerations() ? joint.slip : 0; }
  ContactKinematics<Real> kinematics(int interface, const Joint<Real>& joint) const {
    return kinematics_of(stack, bodies, stack.held_point(interface, joint));
  }
};

template <class Real>
using SquareMatrix = Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic>;

/// Unknowns λ with their rows of W, those of what they do, and what else stands in their conditions W v' +
/// bias.
template <class Real>
struct ContactProblem {
  std::vector<FreeRow<Real>> jacobian, directions;
  std::vector<Real> bias;

  void add(const FreeRow<Real>& row, const FreeRow<Real>& direction, const Real& own_bias) {
    jacobian.push_back(row);
    directions.push_back(direction);
    bias.push_back(own_bias);
  }

  Eigen::Index size() const { return static_cast<Eigen::Index>(jacobian.size()); }

  /// W M⁻¹ Wᵀ: what unit unknowns, the columns, change of conditions, the rows.
  SquareMatrix<Real> matrix(const ContactModel<Real>& stack) const {
    SquareMatrix<Real> result(size(), size());
    for (Eigen::Index i = 0; i < size(); ++i)
      for (Eigen::Index j = 0; j < size(); ++j) result(i, j) = stack.effect(jacobian[i], directions[j]);
    return result;
  }

  /// The conditions without contact.
  FreeVector<Real> free(const FreeVector<Real>& motion) const {
    FreeVector<Real> result(size());
    for (Eigen::Index i = 0; i < size(); ++i) result[i] = jacobian[i].dot(motion) + bias[i];
    return result;
  }
};

/// The Jacobian of the angle between an interface's upper and lower block, times a factor.
template <class Real>
FreeRow<Real> angle_row(const ContactModel<Real>& stack, int interface, const Real& factor = 1) {
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

/// What an impact adds to the condition of a point: by Newton's law its speed across the face is 0 ≤ u + e u⁻
/// ⟂ λ ≥ 0 where it met it, u⁻ < 0, so that e u⁻ is what a pushing point keeps, backwards.
template <class Real>
Real bounce_of(const ContactQuestion<Real>& question, const FreeRow<Real>& gap_row) {
  if (question.level != ContactLevel::impacts || !question.stack.bounces_by(RestitutionLaw::newton)) return 0;
  return question.stack.restitution * std::min<Real>(gap_row.dot(question.free), 0);
}

/// Rows of gaps at both ends of a flat contact, left first.
template <class Real>
std::array<FreeRow<Real>, 2> end_rows(const ContactModel<Real>& stack, int interface,
                                      const FreeRow<Real>& gap_row, const Overlap<Real>& ends) {
  const FreeRow<Real> turn = angle_row(stack, interface);
  return {gap_row - ends.left * turn, gap_row - ends.right * turn};
}

template <class Real>
std::vector<TouchingPoints<Real>> touching_points(const ContactQuestion<Real>& question,
                                                  const Joints<Real>& joints) {
  std::vector<TouchingPoints<Real>> contacts;
  const Real bias = question.of_accelerations() ? 1 : 0;
  for (int k = 0; k < question.stack.size(); ++k) {
    const Joint<Real>& joint = joints[k];
    if (!joint.touches()) continue;
    const ContactKinematics<Real> rows = question.kinematics(k, joint);
    TouchingPoints<Real> contact{
        k, {rows.gap_row}, {}, rows.slip_row, bias * rows.slip_bias, question.stack.friction[k]};
    if (joint.touch == Touch::flat) {
      const auto [left, right] =
          end_rows(question.stack, k, rows.gap_row, overlap(question.stack, k, joint.offset));
      contact.normals = {left, right};
    }
    for (const FreeRow<Real>& normal : contact.normals)
      contact.normal_biases.push_back(bias * rows.gap_bias + bounce_of(question, normal));
    contacts.push_back(std::move(contact));
  }
  return contacts;
}

/// What one interface does to the block above it: forces in N and N·m, or impulses; the moment is about its
/// held point, and that of a pivot is zero.
template <class Real>
struct ContactForce {
  Real normal = 0, tangential = 0, moment = 0;
};

/// What a mode leads to.
template <class Real = double>
struct ModeResponse {
  FreeVector<Real> motion;
  std::vector<ContactForce<Real>> forces;

  /// The largest part of a force along or across a face.
  Real largest_force() const {
    using std::abs;
    Real size = 0;
    for (const ContactForce<Real>& force : forces)
      size = std::max<Real>({size, Real(abs(force.normal)), Real(abs(force.tangential))});
    return size;
  }
};

/// What joints hold, as equations for what holds it.
template <class Real>
ContactProblem<Real> held_by(const ContactQuestion<Real>& question, const Joints<Real>& joints) {
  ContactProblem<Real> problem;
  const Real bias = question.of_accelerations() ? 1 : 0;
  for (int k = 0; k < question.stack.size(); ++k) {
    const Joint<Real>& joint = joints[k];
    if (!joint.touches()) continue;
    const ContactKinematics<Real> rows = question.kinematics(k, joint);
    // Turned by its half-width, all rows are of one unit.
    const Real half_width = question.stack.half_width(k);
    const FreeRow<Real> turn = angle_row(question.stack, k, half_width);
    Real gap_bounce = bounce_of(question, rows.gap_row), turn_bounce = 0;
    if (joint.touch == Touch::flat && question.level == ContactLevel::impacts) {
      // A line through what both ends keep.
      const Overlap<Real> ends = overlap(question.stack, k, joint.offset);
      const auto [left, right] = end_rows(question.stack, k, rows.gap_row, ends);
      const Real at_left = bounce_of(question, left);
      turn_bounce = (at_left - bounce_of(question, right)) / (ends.right - ends.left);
      gap_bounce = at_left + ends.left * turn_bounce;
    }
    if (joint.touch == Touch::flat) problem.add(turn, turn, turn_bounce * half_width);
    problem.add(rows.gap_row, rows.gap_row - joint.slip * question.stack.friction[k] * rows.slip_row,
                bias * rows.gap_bias + gap_bounce);
    if (joint.slip == 0) problem.add(rows.slip_row, rows.slip_row, bias * rows.slip_bias);
  }
  return problem;
}

/// The motion that is left of a free one where joints hold as they say.
template <class Real>
ModeResponse<Real> respond(const ContactQuestion<Real>& question, const Joints<Real>& joints) {
  const ContactModel<Real>& stack = question.stack;
  const ContactProblem<Real> problem = held_by(question, joints);
  ModeResponse<Real> response{question.free, std::vector<ContactForce<Real>>(joints.size())};
  if (problem.size() == 0) return response;
  const FreeVector<Real> forces =
      Eigen::PartialPivLU<SquareMatrix<Real>>(problem.matrix(stack)).solve(-problem.free(question.free));
  for (Eigen::Index i = 0; i < forces.size(); ++i)
    response.motion += forces[i] * stack.inverse_mass.cwiseProduct(problem.directions[i].transpose());
  Eigen::Index at = 0;
  for (std::size_t k = 0; k < joints.size(); ++k) {
    if (!joints[k].touches()) continue;
    ContactForce<Real>& force = response.forces[k];
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
Real conditioning(const ContactModel<Real>& stack) {
  Joints<Real> joints(stack.blocks.size());
  Bodies<Real> bodies{Poses<Real>(joints.size()), Poses<Real>(joints.size())};
  place(stack, joints, bodies);
  const FreeVector<Real> none;
  const SquareMatrix<Real> effects =
      held_by<Real>({stack, bodies, none, ContactLevel::velocities}, joints).matrix(stack);
  const FreeVector<Real> units = effects.diagonal().cwiseSqrt().cwiseInverse();
  const SquareMatrix<Real> scaled = units.asDiagonal() * effects * units.asDiagonal();
  const SquareMatrix<Real> inverse = Eigen::PartialPivLU<SquareMatrix<Real>>(scaled).inverse();
  const auto size = [](const SquareMatrix<Real>& matrix) {
    return matrix.cwiseAbs().rowwise().sum().maxCoeff();
  };
  return 1 / (size(scaled) * size(inverse));
}

/// A rounding of poses over what it makes of the smallest half-size, in shares of that.
template <class Real>
Real fineness(const ContactModel<Real>& stack) {
  Real smallest = std::numeric_limits<Real>::infinity();
  for (const Block& block : stack.blocks)
    smallest = std::min<Real>(smallest, std::min(block.half_width, block.half_height));
  return smallest / stack.height();
}

/// Whether contact forces and sizes keep so many digits of a number type.
template <class Real>
bool keeps_digits(const ContactModel<Real>& stack, int digits) {
  using std::pow;
  return std::min(conditioning(stack), fineness(stack)) >=
         pow(Real(10), digits) * std::numeric_limits<Real>::epsilon();
}

/// @throws std::domain_error where masses or sizes are so far apart that contact forces or sizes keep fewer
/// than six digits.
template <class Real>
void require_digits(const ContactModel<Real>& stack) {
  if (!keeps_digits(stack, 6))
    throw std::domain_error(
        "block masses or sizes are too far apart: rounding would leave contact forces fewer than six digits");
}

}  // namespace rockstack
