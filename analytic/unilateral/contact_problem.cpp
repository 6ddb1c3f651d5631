#include "analytic/unilateral/contact_problem.hpp"

#include <utility>

namespace rockstack {

using Row = Eigen::RowVectorXd;

void ContactProblem::add(const Row& gradient, const Row& action, double bias) {
  gradients.push_back(gradient);
  actions.push_back(action);
  biases.push_back(bias);
}

Eigen::MatrixXd ContactProblem::matrix(const FrictionStack& stack) const {
  Eigen::MatrixXd result(size(), size());
  for (Eigen::Index i = 0; i < size(); ++i)
    for (Eigen::Index j = 0; j < size(); ++j)
      result(i, j) = (gradients[static_cast<std::size_t>(i)].array() *
                      stack.inverse_mass.transpose().array() * actions[static_cast<std::size_t>(j)].array())
                         .sum();
  return result;
}

Eigen::VectorXd ContactProblem::free(const FreeVector& motion) const {
  Eigen::VectorXd result(size());
  for (Eigen::Index i = 0; i < size(); ++i)
    result[i] = gradients[static_cast<std::size_t>(i)].dot(motion) + biases[static_cast<std::size_t>(i)];
  return result;
}

Row angle_row(const FrictionStack& stack, int interface) {
  Row row = Row::Zero(Eigen::Index{3} * stack.size());
  row[Eigen::Index{3} * interface + 2] = 1;
  if (interface > 0) row[Eigen::Index{3} * interface - 1] = -1;
  return row;
}

std::vector<TouchingPoints> touching_points(const FrictionStack& stack, const std::vector<Joint>& joints,
                                            const Bodies& bodies, Sought sought) {
  std::vector<TouchingPoints> contacts;
  const double bias = sought == Sought::accelerations ? 1 : 0;
  for (int k = 0; k < stack.size(); ++k) {
    const auto index = static_cast<std::size_t>(k);
    const Joint& joint = joints[index];
    if (!joint.touches()) continue;
    const PointRows rows = rows_of(stack.blocks, bodies, held_point(stack.blocks, k, joint));
    TouchingPoints contact{k, {}, {}, rows.slip_row, bias * rows.slip_bias, stack.friction[index]};
    if (joint.touch == Touch::flat) {
      const Overlap ends = overlap(stack, k, joint.offset);
      const Row turn = angle_row(stack, k);
      contact.normals = {rows.gap_row - ends.left * turn, rows.gap_row - ends.right * turn};
    } else {
      contact.normals = {rows.gap_row};
    }
    contact.normal_biases.assign(contact.normals.size(), bias * rows.gap_bias);
    contacts.push_back(std::move(contact));
  }
  return contacts;
}

int slip_before(const Joint& joint, Sought sought) {
  return sought == Sought::velocities ? 0 : joint.slip;
}

}  // namespace rockstack
