#pragma once

#include <Eigen/Cholesky>
#include <stdexcept>

#include "analytic/scene/kinematics.hpp"

namespace rockstack {

// One rule gives the accelerations between events and the velocities after an impact (Gauss's principle of
// least constraint, and its counterpart for impulses). The blocks would move freely; the pattern allows them
// only motions x = bias + J q, with q the relative motions of the open interfaces. The motion that takes
// place is the allowed one nearest to the free one, measured by kinetic energy:
//
//     q = (Jᵀ M J)⁻¹ Jᵀ M (free − bias)
//
// For accelerations, free is the pull of gravity and moving ground, and the bias is centripetal: Lagrange's
// equations of the chain, of which Spanos et al. 2001, Eqs. (8)–(28), are the four patterns of two blocks.
// For velocities, free is the motion before the impact and there is no bias: angular momentum of all that is
// above a pivot is kept about it, Spanos et al. 2001, Sections 3 and 4.

/// Motion of every block: its centre (m/s² or m/s) and its rotation (rad/s² or rad/s, clockwise positive).
template <class Real>
struct Motion {
  Points<Real> centre;
  Vector<Real> rotation;
};

/// A stack under gravity, in the number type of a calculation.
template <class Real>
struct Model {
  Stack<Real> stack;
  Real gravity;                                ///< m/s²
  Equations equations = Equations::nonlinear;  ///< linear: geometry upright, no velocity terms
};

template <class Real>
Model<Real> make_model(const Scene& scene) {
  return {make_stack<Real>(scene), Real(scene.gravity), scene.equations};
}

/// Where the stack is and how it moves: relative angles φₖ in rad and their rates in rad/s, exactly zero at
/// closed interfaces. Relative, because an impact happens where φₖ = 0 and must be resolved there.
template <class Real>
struct State {
  Pattern pattern;
  Vector<Real> angles;
  Vector<Real> velocities;
};

/// The chain at a state; upright for the linear equations.
template <class Real>
Chain<Real> chain_at(const Model<Real>& model, const Pattern& pattern, const Vector<Real>& relative_angles) {
  if (model.equations == Equations::linear) {
    return make_chain<Real>(model.stack, pattern, Vector<Real>::Zero(relative_angles.size()));
  }
  return make_chain<Real>(model.stack, pattern, absolute<Real>(relative_angles));
}

/// Sums from the top down: turns what belongs to the absolute angles of blocks into what belongs to relative
/// angles.
template <class Derived>
void sum_from_top(Eigen::MatrixBase<Derived>& rows) {
  for (Eigen::Index k = rows.rows() - 2; k >= 0; --k) rows.row(k) += rows.row(k + 1);
}

/// Jᵀ M J for the relative angles of all interfaces, kg·m².
template <class Real>
Matrix<Real> mass_matrix(const Stack<Real>& stack, const Chain<Real>& chain) {
  const int size = stack.size();
  Matrix<Real> mass(size, size);
  Real above = 0;  // mass of the blocks above block j
  for (int j = size - 1; j >= 0; --j) {
    const auto arm = chain.arms.col(j);
    const auto link = chain.links.col(j);
    mass(j, j) = stack.inertia[j] + stack.mass[j] * arm.squaredNorm() + above * link.squaredNorm();
    const Point<Real> moment = stack.mass[j] * arm + above * link;
    for (int i = 0; i < j; ++i) mass(i, j) = mass(j, i) = chain.links.col(i).dot(moment);
    above += stack.mass[j];
  }
  sum_from_top(mass);
  Matrix<Real> transposed = mass.transpose();
  sum_from_top(transposed);
  return transposed;
}

/// Jᵀ M x for the relative angles of all interfaces.
template <class Real>
Vector<Real> generalised_momentum(const Stack<Real>& stack, const Chain<Real>& chain,
                                  const Motion<Real>& motion) {
  Vector<Real> result(stack.size());
  Point<Real> above = Point<Real>::Zero();  // momentum of the blocks above block k
  for (int k = stack.size() - 1; k >= 0; --k) {
    const Point<Real> own = stack.mass[k] * motion.centre.col(k);
    result[k] = stack.inertia[k] * motion.rotation[k] + quarter_turned<Real>(chain.arms.col(k)).dot(own) +
                quarter_turned<Real>(chain.links.col(k)).dot(above);
    above += own;
  }
  sum_from_top(result);
  return result;
}

/// The allowed motion nearest to `free` (with any bias already taken off), as relative motions of the
/// interfaces; zero where they are closed.
/// @throws std::domain_error where rounding makes the mass matrix singular.
template <class Real>
Vector<Real> nearest_allowed(const Stack<Real>& stack, const Pattern& pattern, const Chain<Real>& chain,
                             const Motion<Real>& free) {
  std::array<int, max_blocks> open{};
  int count = 0;
  for (int k = 0; k < pattern.size; ++k) {
    if (pattern[k] != Contact::closed) open[static_cast<std::size_t>(count++)] = k;
  }
  Vector<Real> result = Vector<Real>::Zero(pattern.size);
  if (count == 0) return result;
  const auto index = [&](int i) { return open[static_cast<std::size_t>(i)]; };
  const Matrix<Real> mass = mass_matrix(stack, chain);
  const Vector<Real> momentum = generalised_momentum(stack, chain, free);
  Matrix<Real> reduced(count, count);
  Vector<Real> right(count);
  for (int i = 0; i < count; ++i) {
    right[i] = momentum[index(i)];
    for (int j = 0; j < count; ++j) reduced(i, j) = mass(index(i), index(j));
  }
  const Eigen::LLT<Matrix<Real>> factors(reduced);
  if (factors.info() != Eigen::Success) {
    throw std::domain_error(
        "the mass matrix is singular to rounding: block masses or sizes are too far apart");
  }
  right = factors.solve(right);
  for (int i = 0; i < count; ++i) result[index(i)] = right[i];
  return result;
}

/// Accelerations of the centres that would remain if no relative angle accelerated, m/s².
template <class Real>
Points<Real> centripetal(const Chain<Real>& chain, const Vector<Real>& angular_velocities) {
  Points<Real> result(2, chain.arms.cols());
  Point<Real> pivot = Point<Real>::Zero();
  for (Eigen::Index k = 0; k < chain.arms.cols(); ++k) {
    const Real square = angular_velocities[k] * angular_velocities[k];
    result.col(k) = pivot - square * chain.arms.col(k);
    pivot -= square * chain.links.col(k);
  }
  return result;
}

/// What the blocks would do if nothing held them, less the centripetal bias, in the frame of the ground.
/// `ground` is (ẍg, ÿg) in m/s².
template <class Real>
Motion<Real> free_acceleration(const Model<Real>& model, const Chain<Real>& chain,
                               const Vector<Real>& velocities, const Point<Real>& ground) {
  const int size = model.stack.size();
  Motion<Real> free{Points<Real>(2, size), Vector<Real>::Zero(size)};
  const Point<Real> pull{-ground.x(), -(model.gravity + ground.y())};
  if (model.equations == Equations::linear) {
    free.centre.colwise() = pull;
  } else {
    free.centre = -centripetal<Real>(chain, absolute<Real>(velocities));
    free.centre.colwise() += pull;
  }
  return free;
}

/// Relative angular accelerations φ̈ₖ, rad/s²; zero where closed. Spanos et al. 2001, Eqs. (8)–(18), and
/// (19)–(28) for the linear equations, are the values for two blocks.
template <class Real>
Vector<Real> accelerations(const Model<Real>& model, const State<Real>& state, const Point<Real>& ground) {
  const Chain<Real> chain = chain_at(model, state.pattern, state.angles);
  return nearest_allowed(model.stack, state.pattern, chain,
                         free_acceleration(model, chain, state.velocities, ground));
}

/// Kinetic energy and height of the centres times weight, J, from the ground.
template <class Real>
Real energy(const Model<Real>& model, const State<Real>& state) {
  const Chain<Real> chain = chain_at(model, state.pattern, state.angles);
  const Vector<Real> rates = absolute<Real>(state.velocities);
  const Points<Real> speeds = centre_velocities(chain, rates);
  const Points<Real> places = centres(chain);
  Real sum = 0;
  for (int k = 0; k < model.stack.size(); ++k) {
    sum += model.stack.mass[k] * (speeds.col(k).squaredNorm() / 2 + model.gravity * places(1, k));
    sum += model.stack.inertia[k] * rates[k] * rates[k] / 2;
  }
  return sum;
}

}  // namespace rockstack
