#pragma once

#include <Eigen/LU>
#include <algorithm>
#include <limits>

#include "analytic/unilateral/contact/complementarity.hpp"

namespace rockstack {

/// A mode from what is active: which points push, and which way the interface slides.
template <class Real>
void set_mode(const BasicFrictionStack<Real>& stack, const TouchingPoints<Real>& contact,
              const std::vector<bool>& pushes, int slip, BasicJoint<Real>& joint) {
  const bool any = std::find(pushes.begin(), pushes.end(), true) != pushes.end();
  if (!any) {
    joint.touch = Touch::apart;
    joint.slip = 0;
    return;
  }
  joint.slip = slip;
  if (joint.touch != Touch::flat || (pushes[0] && pushes[1])) return;
  joint.touch = pushes[0] ? Touch::left : Touch::right;
  joint.corner_below = corner_is_below(stack, contact.interface, joint.offset, joint.side(), slip);
}

/// The mode in which all that sticks goes on to, if its forces allow that.
template <class Real>
std::optional<Joints<Real>> sticking_mode(const BasicFrictionStack<Real>& stack, const Joints<Real>& joints,
                                          const std::vector<TouchingPoints<Real>>& contacts,
                                          const BasicFreeVector<Real>& free, Sought sought) {
  ContactProblem<Real> held, points;
  std::vector<Eigen::Index> held_at;
  for (const TouchingPoints<Real>& contact : contacts) {
    const int slip = slip_before(joints[static_cast<std::size_t>(contact.interface)], sought);
    held_at.push_back(slip == 0 ? held.size() : -1);
    if (slip == 0) held.add(contact.slip, contact.slip, contact.slip_bias);
    for (std::size_t i = 0; i < contact.normals.size(); ++i)
      points.add(contact.normals[i], contact.normals[i] - contact.friction * slip * contact.slip,
                 contact.normal_biases[i]);
  }
  const Eigen::Index held_size = held.size();
  ContactProblem<Real> all = held;
  for (std::size_t i = 0; i < points.gradients.size(); ++i)
    all.add(points.gradients[i], points.actions[i], points.biases[i]);
  const SquareMatrix<Real> matrix = all.matrix(stack);
  const BasicFreeVector<Real> vector = all.free(free);
  const Eigen::Index size = points.size();
  SquareMatrix<Real> reduced = matrix.bottomRightCorner(size, size);
  BasicFreeVector<Real> reduced_vector = vector.tail(size);
  SquareMatrix<Real> tangential_per_normal(held_size, size);
  BasicFreeVector<Real> tangential(held_size);
  if (held_size > 0) {
    const Eigen::PartialPivLU<SquareMatrix<Real>> lu(matrix.topLeftCorner(held_size, held_size));
    tangential_per_normal = -lu.solve(matrix.topRightCorner(held_size, size));
    tangential = -lu.solve(vector.head(held_size));
    reduced += matrix.bottomLeftCorner(size, held_size) * tangential_per_normal;
    reduced_vector += matrix.bottomLeftCorner(size, held_size) * tangential;
  }
  const Real scale = reduced.diagonal().cwiseAbs().maxCoeff();
  const auto solution = solve_complementarity<Real>(reduced / scale, reduced_vector);
  if (!solution) return std::nullopt;
  const BasicFreeVector<Real> normals = solution->z / scale;
  tangential += tangential_per_normal * normals;
  const Real parting = tolerance<Real>(1e-12) * (reduced_vector.template lpNorm<Eigen::Infinity>() +
                                                 vector.template lpNorm<Eigen::Infinity>());
  const Real force_rounding =
      tolerance<Real>(1e-12) * (normals.template lpNorm<Eigen::Infinity>() +
                                (held_size > 0 ? tangential.template lpNorm<Eigen::Infinity>() : Real(0)));
  Joints<Real> mode = joints;
  Eigen::Index at = 0;
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    const TouchingPoints<Real>& contact = contacts[c];
    BasicJoint<Real>& joint = mode[static_cast<std::size_t>(contact.interface)];
    std::vector<bool> pushes;
    Real normal = 0;
    for (std::size_t i = 0; i < contact.normals.size(); ++i, ++at) {
      pushes.push_back(!(solution->w[at] > parting));
      normal += normals[at];
    }
    const int slip = slip_before(joint, sought);
    set_mode(stack, contact, pushes, slip, joint);
    using std::abs;
    if (slip == 0 && abs(tangential[held_at[c]]) > contact.friction * normal + force_rounding)
      return std::nullopt;
  }
  return mode;
}

}  // namespace rockstack
