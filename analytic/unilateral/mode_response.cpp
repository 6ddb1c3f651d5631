#include "analytic/unilateral/mode_response.hpp"

#include <Eigen/LU>

namespace rockstack {

ModeResponse respond(const FrictionStack& stack, const std::vector<Joint>& joints, const Bodies& bodies,
                     const FreeVector& free, Sought sought) {
  ContactProblem problem;
  const double bias = sought == Sought::accelerations ? 1 : 0;
  for (int k = 0; k < stack.size(); ++k) {
    const auto index = static_cast<std::size_t>(k);
    const Joint& joint = joints[index];
    if (!joint.touches()) continue;
    const PointRows rows = rows_of(stack.blocks, bodies, held_point(stack.blocks, k, joint));
    // Turned by its half-width, all rows are of one unit.
    const Row turn = half_width_of(stack.blocks, k) * angle_row(stack, k);
    if (joint.touch == Touch::flat) problem.add(turn, turn, 0);
    problem.add(rows.gap_row, rows.gap_row - joint.slip * stack.friction[index] * rows.slip_row,
                bias * rows.gap_bias);
    if (joint.slip == 0) problem.add(rows.slip_row, rows.slip_row, bias * rows.slip_bias);
  }
  ModeResponse response{free, std::vector<ContactForce>(joints.size())};
  if (problem.size() == 0) return response;
  const Eigen::VectorXd forces =
      Eigen::PartialPivLU<Eigen::MatrixXd>(problem.matrix(stack)).solve(-problem.free(free));
  for (Eigen::Index i = 0; i < forces.size(); ++i)
    response.motion +=
        forces[i] * stack.inverse_mass.cwiseProduct(problem.actions[static_cast<std::size_t>(i)].transpose());
  Eigen::Index at = 0;
  for (std::size_t k = 0; k < joints.size(); ++k) {
    if (!joints[k].touches()) continue;
    ContactForce& force = response.forces[k];
    if (joints[k].touch == Touch::flat) force.moment = forces[at++] * stack.blocks[k].half_width;
    force.normal = forces[at++];
    force.tangential =
        joints[k].slip == 0 ? forces[at++] : -joints[k].slip * stack.friction[k] * force.normal;
  }
  return response;
}

}  // namespace rockstack
