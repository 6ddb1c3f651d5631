#pragma once

#include <optional>

#include "analytic/unilateral/contact/contact_laws.hpp"
#include "analytic/unilateral/contact/sticking_mode.hpp"

namespace rockstack {

/// A mode by Lemke's method, for each interface points, friction to the right and to the left, and slip.
template <class Real>
std::optional<Joints<Real>> rubbing_mode(const BasicFrictionStack<Real>& stack, const Joints<Real>& joints,
                                         const std::vector<TouchingPoints<Real>>& contacts,
                                         const BasicFreeVector<Real>& free, Sought sought) {
  ContactProblem<Real> problem;
  std::vector<Eigen::Index> cones;  // of each contact: where its friction stands, or −1
  const FreeRow<Real> none = FreeRow<Real>::Zero(Eigen::Index{3} * stack.size());
  for (const TouchingPoints<Real>& contact : contacts) {
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
  SquareMatrix<Real> matrix = problem.matrix(stack);
  matrix /= matrix.diagonal().cwiseAbs().maxCoeff();
  const BasicFreeVector<Real> vector = problem.free(free);
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
  const Real parting = tolerance<Real>(1e-12) * vector.template lpNorm<Eigen::Infinity>();
  Joints<Real> mode = joints;
  Eigen::Index at = 0;
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    BasicJoint<Real>& joint = mode[static_cast<std::size_t>(contacts[c].interface)];
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
template <class Real>
std::optional<Joints<Real>> nearest_mode(const BasicFrictionStack<Real>& stack, const Joints<Real>& joints,
                                         const BasicBodies<Real>& bodies, const BasicFreeVector<Real>& free,
                                         Sought sought) {
  constexpr std::size_t most = 100000;
  std::optional<Joints<Real>> nearest;
  Real least = std::numeric_limits<Real>::infinity();
  for (auto& mode : modes_that_obey(stack, joints, bodies, free, sought, most)) {
    const BasicFreeVector<Real> change = respond(stack, mode, bodies, free, sought).motion - free;
    const Real size = change.cwiseAbs2().cwiseQuotient(stack.inverse_mass).sum();
    if (!(size < least)) continue;
    least = size;
    nearest = std::move(mode);
  }
  return nearest;
}

/// The mode that obeys all laws of contact among those in which what touches may stay, part or pivot, and
/// what sticks may slide; of velocities everything may stick. Where several do, the one in which all that
/// sticks goes on to stick comes first, then the one that Lemke's method finds, then, where rounding leads
/// that astray, of all others the one nearest to the motion without contact in the metric of kinetic energy.
/// Where none does to rounding, what Lemke's method finds all the same; nothing where it finds none, which
/// happens for accelerations alone (Painlevé).
template <class Real>
std::optional<Joints<Real>> find_mode(const BasicFrictionStack<Real>& stack, const Joints<Real>& joints,
                                      const BasicBodies<Real>& bodies, const BasicFreeVector<Real>& free,
                                      Sought sought) {
  const std::vector<TouchingPoints<Real>> contacts = touching_points(stack, joints, bodies, sought);
  if (contacts.empty()) return joints;
  if (auto mode = sticking_mode(stack, joints, contacts, free, sought)) return mode;
  auto mode = rubbing_mode(stack, joints, contacts, free, sought);
  if (mode && obeys(stack, joints, *mode, bodies, free, sought)) return mode;
  auto other = nearest_mode(stack, joints, bodies, free, sought);
  return other ? other : mode;
}

}  // namespace rockstack
