#pragma once

#include "analytic/unilateral/friction_stack.hpp"

namespace rockstack {

// Motion and impact are one rule for free bodies: M (v' − v) = Wᵀ λ, with v' the accelerations or the
// velocities after, v those that there would be without contact, and W the gradients of gaps and slips.

/// Whether velocities or accelerations are sought: the latter have a part that velocities alone make.
enum class Sought { velocities, accelerations };

/// Unknowns λ with their gradients, what they do, and what else stands in their conditions W v' + bias.
struct ContactProblem {
  std::vector<Eigen::RowVectorXd> gradients, actions;
  std::vector<double> biases;

  void add(const Eigen::RowVectorXd& gradient, const Eigen::RowVectorXd& action, double bias);
  Eigen::Index size() const { return static_cast<Eigen::Index>(gradients.size()); }
  /// What unit unknowns, the columns, change of conditions, the rows.
  Eigen::MatrixXd matrix(const FrictionStack& stack) const;
  /// The conditions without contact.
  Eigen::VectorXd free(const FreeVector& motion) const;
};

/// The points of an interface that touches, of one or two: left end first; and its slip.
struct TouchingPoints {
  int interface;
  std::vector<Eigen::RowVectorXd> normals;
  std::vector<double> normal_biases;
  Eigen::RowVectorXd slip;
  double slip_bias;
  double friction;
};

std::vector<TouchingPoints> touching_points(const FrictionStack& stack, const std::vector<Joint>& joints,
                                            const Bodies& bodies, Sought sought);

/// The gradient of the angle between an interface's upper and lower block.
Eigen::RowVectorXd angle_row(const FrictionStack& stack, int interface);

/// The way an interface slides: a direction, or 0 where it is to be found.
int slip_before(const Joint& joint, Sought sought);

}  // namespace rockstack
