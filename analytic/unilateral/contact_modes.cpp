#include "analytic/unilateral/contact_modes.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <utility>

#include "analytic/unilateral/complementarity.hpp"

namespace rockstack {
namespace {

using Row = Eigen::RowVectorXd;

/// The unknown forces of an interface that touches, with their gradients.
struct Contact2D {
  int interface;
  std::vector<Row> normals;  ///< of one or two points: left end first
  std::vector<double> normal_biases;
  Row slip;
  double slip_bias;
  double friction;
};

Row angle_row(const FrictionStack& stack, int interface) {
  Row row = Row::Zero(Eigen::Index{3} * stack.size());
  row[Eigen::Index{3} * interface + 2] = 1;
  if (interface > 0) row[Eigen::Index{3} * interface - 1] = -1;
  return row;
}

std::vector<Contact2D> contacts_of(const FrictionStack& stack, const std::vector<Joint>& joints,
                                   const Bodies& bodies, Sought sought) {
  std::vector<Contact2D> contacts;
  const double bias = sought == Sought::accelerations ? 1 : 0;
  for (int k = 0; k < stack.size(); ++k) {
    const auto index = static_cast<std::size_t>(k);
    const Joint& joint = joints[index];
    if (!joint.touches()) continue;
    const PointRows rows = rows_of(stack.blocks, bodies, held_point(stack.blocks, k, joint));
    Contact2D contact{k, {}, {}, rows.slip_row, bias * rows.slip_bias, stack.friction[index]};
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

/// A mode from what is active: which points push, and which way the interface slides.
void set_mode(const FrictionStack& stack, const Contact2D& contact, const std::vector<bool>& pushes, int slip,
              Joint& joint) {
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

/// Unknowns λ with their gradients as rows, what they do as columns, and what else stands in the problem.
struct Problem {
  std::vector<Row> gradients, actions;
  std::vector<double> biases;

  void add(const Row& gradient, const Row& action, double bias) {
    gradients.push_back(gradient);
    actions.push_back(action);
    biases.push_back(bias);
  }
  Eigen::Index size() const { return static_cast<Eigen::Index>(gradients.size()); }
  Eigen::MatrixXd matrix(const FrictionStack& stack) const {
    Eigen::MatrixXd result(size(), size());
    for (Eigen::Index i = 0; i < size(); ++i)
      for (Eigen::Index j = 0; j < size(); ++j)
        result(i, j) = (gradients[static_cast<std::size_t>(i)].array() *
                        stack.inverse_mass.transpose().array() * actions[static_cast<std::size_t>(j)].array())
                           .sum();
    return result;
  }
  Eigen::VectorXd free(const FreeVector& motion) const {
    Eigen::VectorXd result(size());
    for (Eigen::Index i = 0; i < size(); ++i)
      result[i] = gradients[static_cast<std::size_t>(i)].dot(motion) + biases[static_cast<std::size_t>(i)];
    return result;
  }
};

constexpr double round_off = 1e-12;

/// The slip of an interface before: a direction, or 0 where it is to be found.
int slip_before(const Joint& joint, Sought sought) {
  return sought == Sought::velocities ? 0 : joint.slip;
}

/// The mode in which all that sticks goes on to, if its forces allow that.
std::optional<std::vector<Joint>> sticking_mode(const FrictionStack& stack, const std::vector<Joint>& joints,
                                                const std::vector<Contact2D>& contacts,
                                                const FreeVector& free, Sought sought) {
  Problem held, points;
  std::vector<Eigen::Index> held_at;
  for (const Contact2D& contact : contacts) {
    const int slip = slip_before(joints[static_cast<std::size_t>(contact.interface)], sought);
    held_at.push_back(slip == 0 ? held.size() : -1);
    if (slip == 0) held.add(contact.slip, contact.slip, contact.slip_bias);
    for (std::size_t i = 0; i < contact.normals.size(); ++i)
      points.add(contact.normals[i], contact.normals[i] - contact.friction * slip * contact.slip,
                 contact.normal_biases[i]);
  }
  const Eigen::Index held_size = held.size();
  Problem all = held;
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
    const Contact2D& contact = contacts[c];
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
                                               const std::vector<Contact2D>& contacts, const FreeVector& free,
                                               Sought sought) {
  Problem problem;
  std::vector<Eigen::Index> cones;  // of each contact: where its friction stands, or −1
  const Row none = Row::Zero(Eigen::Index{3} * stack.size());
  for (const Contact2D& contact : contacts) {
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

}  // namespace

FrictionStack::FrictionStack(std::vector<Block> stacked, std::vector<double> coefficients)
    : blocks(std::move(stacked)),
      friction(std::move(coefficients)),
      inverse_mass(3 * static_cast<Eigen::Index>(blocks.size())) {
  for (int k = 0; k < size(); ++k) {
    const Block& block = blocks[static_cast<std::size_t>(k)];
    inverse_mass.segment<3>(Eigen::Index{3} * k) << 1 / block.mass, 1 / block.mass, 1 / block.inertia;
  }
}

Overlap overlap(const FrictionStack& stack, int interface, double offset) {
  const double upper = half_width_of(stack.blocks, interface);
  const double lower = half_width_of(stack.blocks, interface - 1);
  return {std::max(-upper, -lower - offset), std::min(upper, lower - offset)};
}

bool corner_is_below(const FrictionStack& stack, int interface, double offset, int side) {
  return half_width_of(stack.blocks, interface - 1) - side * offset < half_width_of(stack.blocks, interface);
}

ModeResponse respond(const FrictionStack& stack, const std::vector<Joint>& joints, const Bodies& bodies,
                     const FreeVector& free, Sought sought) {
  Problem problem;
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

std::optional<std::vector<Joint>> find_mode(const FrictionStack& stack, const std::vector<Joint>& joints,
                                            const Bodies& bodies, const FreeVector& free, Sought sought) {
  const std::vector<Contact2D> contacts = contacts_of(stack, joints, bodies, sought);
  if (contacts.empty()) return joints;
  if (auto mode = sticking_mode(stack, joints, contacts, free, sought)) return mode;
  return rubbing_mode(stack, joints, contacts, free, sought);
}

bool obeys(const FrictionStack& stack, const std::vector<Joint>& joints, const std::vector<Joint>& mode,
           const Bodies& bodies, const FreeVector& free, Sought sought) {
  const ModeResponse response = respond(stack, mode, bodies, free, sought);
  double size = 0;
  for (const ContactForce& force : response.forces)
    size = std::max({size, std::abs(force.normal), std::abs(force.tangential)});
  const double motion_rounding = 1e-9 * free.lpNorm<Eigen::Infinity>();
  const double force_rounding = 1e-9 * size;
  for (const Contact2D& contact : contacts_of(stack, joints, bodies, sought)) {
    const auto index = static_cast<std::size_t>(contact.interface);
    const Joint& joint = mode[index];
    const ContactForce& force = response.forces[index];
    for (std::size_t i = 0; i < contact.normals.size(); ++i)
      if (contact.normals[i].dot(response.motion) + contact.normal_biases[i] < -motion_rounding) return false;
    if (force.normal < -force_rounding) return false;
    if (std::abs(force.tangential) > contact.friction * force.normal + force_rounding) return false;
    if (joint.touch == Touch::flat) {
      const Overlap ends = overlap(stack, contact.interface, joint.offset);
      if (force.normal * ends.right + force.moment < -force_rounding * (ends.right - ends.left)) return false;
      if (-force.moment - force.normal * ends.left < -force_rounding * (ends.right - ends.left)) return false;
    }
    const double slip = contact.slip.dot(response.motion) + contact.slip_bias;
    if (joint.slip != 0 && slip_before(joints[index], sought) == 0 && slip * joint.slip < -motion_rounding)
      return false;
  }
  return true;
}

}  // namespace rockstack
