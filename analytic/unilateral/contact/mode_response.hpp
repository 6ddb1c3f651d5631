#pragma once

#include <Eigen/LU>

#include "analytic/unilateral/contact/contact_problem.hpp"

namespace rockstack {

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

}  // namespace rockstack
