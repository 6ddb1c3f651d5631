#include "analytic/unilateral/contact_modes.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <limits>
#include <utility>

#include "analytic/unilateral/complementarity.hpp"

namespace rockstack {
namespace {

using Row = Eigen::RowVectorXd;

/// A mode from what is active: which points push, and which way the interface slides.
void set_mode(const FrictionStack& stack, const TouchingPoints& contact, const std::vector<bool>& pushes,
              int slip, Joint& joint) {
  const bool any = std::find(pushes.begin(), pushes.end(), true) != pushes.end();
  if (!any) {
    joint.touch = Touch::apart;
    joint.slip = 0;
    return;
  }
  joint.slip = slip;
  if (joint.touch != Touch::flat || (pushes[0] && pushes[1])) return;
  joint.touch = pushes[0] ? Touch::left : Touch::right;
  joint.corner_below = corner_is_below(stack, contact.interface, joint.offset, joint.side());
}

constexpr double round_off = 1e-12;

/// The mode in which all that sticks goes on to, if its forces allow that.
std::optional<std::vector<Joint>> sticking_mode(const FrictionStack& stack, const std::vector<Joint>& joints,
                                                const std::vector<TouchingPoints>& contacts,
                                                const FreeVector& free, Sought sought) {
  ContactProblem held, points;
  std::vector<Eigen::Index> held_at;
  for (const TouchingPoints& contact : contacts) {
    const int slip = slip_before(joints[static_cast<std::size_t>(contact.interface)], sought);
    held_at.push_back(slip == 0 ? held.size() : -1);
    if (slip == 0) held.add(contact.slip, contact.slip, contact.slip_bias);
    for (std::size_t i = 0; i < contact.normals.size(); ++i)
      points.add(contact.normals[i], contact.normals[i] - contact.friction * slip * contact.slip,
                 contact.normal_biases[i]);
  }
  const Eigen::Index held_size = held.size();
  ContactProblem all = held;
  for (std::size_t i = 0; i < points.gradients.size(); ++i)
    all.add(points.gradients[i], points.actions[i], points.biases[i]);
  const Eigen::MatrixXd matrix = all.matrix(stack);
  const Eigen::VectorXd vector = all.free(free);
  const Eigen::Index size = points.size();
  Eigen::MatrixXd reduced = matrix.bottomRightCorner(size, size);
  Eigen::VectorXd reduced_vector = vector.tail(size);
  Eigen::MatrixXd tangential_per_normal(held_size, size);
  Eigen::VectorXd tangential(held_size);
  if (held_size > 0) {
    const Eigen::PartialPivLU<Eigen::MatrixXd> lu(matrix.topLeftCorner(held_size, held_size));
    tangential_per_normal = -lu.solve(matrix.topRightCorner(held_size, size));
    tangential = -lu.solve(vector.head(held_size));
    reduced += matrix.bottomLeftCorner(size, held_size) * tangential_per_normal;
    reduced_vector += matrix.bottomLeftCorner(size, held_size) * tangential;
  }
  const double scale = reduced.diagonal().cwiseAbs().maxCoeff();
  const auto solution = solve_complementarity(reduced / scale, reduced_vector);
  if (!solution) return std::nullopt;
  const Eigen::VectorXd normals = solution->z / scale;
  tangential += tangential_per_normal * normals;
  const double parting =
      round_off * (reduced_vector.lpNorm<Eigen::Infinity>() + vector.lpNorm<Eigen::Infinity>());
  const double force_rounding = round_off * (normals.lpNorm<Eigen::Infinity>() +
                                             (held_size > 0 ? tangential.lpNorm<Eigen::Infinity>() : 0));
  std::vector<Joint> mode = joints;
  Eigen::Index at = 0;
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    const TouchingPoints& contact = contacts[c];
    Joint& joint = mode[static_cast<std::size_t>(contact.interface)];
    std::vector<bool> pushes;
    double normal = 0;
    for (std::size_t i = 0; i < contact.normals.size(); ++i, ++at) {
      pushes.push_back(!(solution->w[at] > parting));
      normal += normals[at];
    }
    const int slip = slip_before(joint, sought);
    set_mode(stack, contact, pushes, slip, joint);
    if (slip == 0 && std::abs(tangential[held_at[c]]) > contact.friction * normal + force_rounding)
      return std::nullopt;
  }
  return mode;
}

/// A mode by Lemke's method, for each interface points, friction to the right and to the left, and slip.
std::optional<std::vector<Joint>> rubbing_mode(const FrictionStack& stack, const std::vector<Joint>& joints,
                                               const std::vector<TouchingPoints>& contacts,
                                               const FreeVector& free, Sought sought) {
  ContactProblem problem;
  std::vector<Eigen::Index> cones;  // of each contact: where its friction stands, or −1
  const Row none = Row::Zero(Eigen::Index{3} * stack.size());
  for (const TouchingPoints& contact : contacts) {
    const int slip = slip_before(joints[static_cast<std::size_t>(contact.interface)], sought);
    for (std::size_t i = 0; i < contact.normals.size(); ++i)
      problem.add(contact.normals[i], contact.normals[i] - contact.friction * slip * contact.slip,
                  contact.normal_biases[i]);
    cones.push_back(slip == 0 ? problem.size() : -1);
    if (slip != 0) continue;
    problem.add(contact.slip, contact.slip, contact.slip_bias);
    problem.add(-contact.slip, -contact.slip, -contact.slip_bias);
    problem.add(none, none, 0);
  }
  Eigen::MatrixXd matrix = problem.matrix(stack);
  matrix /= matrix.diagonal().cwiseAbs().maxCoeff();
  const Eigen::VectorXd vector = problem.free(free);
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    if (cones[c] < 0) continue;
    const Eigen::Index slack = cones[c] + 2;
    const auto points = static_cast<Eigen::Index>(contacts[c].normals.size());
    matrix(cones[c], slack) = matrix(cones[c] + 1, slack) = 1;
    matrix(slack, cones[c]) = matrix(slack, cones[c] + 1) = -1;
    for (Eigen::Index i = 1; i <= points; ++i) matrix(slack, cones[c] - i) = contacts[c].friction;
  }
  const auto solution = solve_complementarity(matrix, vector);
  if (!solution) return std::nullopt;
  const double parting = round_off * vector.lpNorm<Eigen::Infinity>();
  std::vector<Joint> mode = joints;
  Eigen::Index at = 0;
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    Joint& joint = mode[static_cast<std::size_t>(contacts[c].interface)];
    std::vector<bool> pushes;
    for (std::size_t i = 0; i < contacts[c].normals.size(); ++i, ++at)
      pushes.push_back(!(solution->w[at] > parting));
    int slip = slip_before(joint, sought);
    if (cones[c] >= 0) {
      // Of the two conditions slack ± slip ≥ 0, that of the way it does not slide is met with equality.
      if (solution->z[at + 2] > parting) slip = solution->w[at] > solution->w[at + 1] ? 1 : -1;
      at += 3;
    }
    set_mode(stack, contacts[c], pushes, slip, joint);
  }
  return mode;
}

/// Of all modes that obey, the one whose forces change the motion least.
std::optional<std::vector<Joint>> nearest_mode(const FrictionStack& stack, const std::vector<Joint>& joints,
                                               const Bodies& bodies, const FreeVector& free, Sought sought) {
  constexpr std::size_t most = 100000;
  std::optional<std::vector<Joint>> nearest;
  double least = std::numeric_limits<double>::infinity();
  for (auto& mode : modes_that_obey(stack, joints, bodies, free, sought, most)) {
    const FreeVector change = respond(stack, mode, bodies, free, sought).motion - free;
    const double size = change.cwiseAbs2().cwiseQuotient(stack.inverse_mass).sum();
    if (!(size < least)) continue;
    least = size;
    nearest = std::move(mode);
  }
  return nearest;
}

}  // namespace

std::optional<std::vector<Joint>> find_mode(const FrictionStack& stack, const std::vector<Joint>& joints,
                                            const Bodies& bodies, const FreeVector& free, Sought sought) {
  const std::vector<TouchingPoints> contacts = touching_points(stack, joints, bodies, sought);
  if (contacts.empty()) return joints;
  if (auto mode = sticking_mode(stack, joints, contacts, free, sought)) return mode;
  auto mode = rubbing_mode(stack, joints, contacts, free, sought);
  if (mode && obeys(stack, joints, *mode, bodies, free, sought)) return mode;
  auto other = nearest_mode(stack, joints, bodies, free, sought);
  return other ? other : mode;
}

}  // namespace rockstack
