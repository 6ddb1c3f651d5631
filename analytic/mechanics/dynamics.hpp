#pragma once

#include "analytic/mechanics/free_motion.hpp"
#include "analytic/mechanics/linkage.hpp"
#include "analytic/polynomials/polynomial.hpp"

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

/// Sums from the top down: of what belongs to absolute angles of blocks, what belongs to relative angles.
template <class Derived>
void sum_from_top(Eigen::MatrixBase<Derived>& rows) {
  for (Eigen::Index k = rows.rows() - 2; k >= 0; --k) rows.row(k) += rows.row(k + 1);
}

/// Jᵀ M J for the relative angles of all interfaces, kg·m². Asked for so often that calls count, as below.
template <class Real, int N>
[[gnu::always_inline]] inline Matrix<Real, N> mass_matrix(const Stack<Real, N>& stack,
                                                          const Chain<Real, N>& chain) {
  const int size = stack.size();
  Matrix<Real, N> mass = Matrix<Real, N>::Zero(size, size);
  Real above = 0;  // mass of the blocks above block j
  for (int j = size - 1; j >= 0; --j) {
    const auto arm = chain.arms.col(j);
    const auto link = chain.links.col(j);
    mass(j, j) = stack.inertia[j] + stack.mass[j] * arm.squaredNorm() + above * link.squaredNorm();
    const Point<Real> moment = stack.mass[j] * arm + above * link;
    for (int i = 0; i < j; ++i) mass(i, j) = mass(j, i) = chain.links.col(i).dot(moment);
    above += stack.mass[j];
  }
  for (int j = size - 2; j >= 0; --j) mass.col(j) += mass.col(j + 1);
  for (int j = 0; j < size; ++j)
    for (int i = size - 2; i >= 0; --i) mass(i, j) += mass(i + 1, j);
  return mass;
}

/// Jᵀ M x for the relative angles of all interfaces.
template <class Real, int N>
[[gnu::always_inline]] inline Vector<Real, N> generalised_momentum(const Stack<Real, N>& stack,
                                                                   const Chain<Real, N>& chain,
                                                                   const Motion<Real, N>& motion) {
  Vector<Real, N> result = Vector<Real, N>::Zero(stack.size());
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

/// Block masses or sizes lie too far apart for the number type: in some motion that the pattern allows, what
/// is light or small is lost beside what is heavy or large.
class IllConditioned : public std::domain_error {
 public:
  using std::domain_error::domain_error;
};

/// The least share that may remain of a diagonal entry of the mass matrix when the motions of the interfaces
/// below are taken out of it. Energies keep nine digits then.
template <class Real>
inline const Real least_diagonal_share = (1 << 30) * std::numeric_limits<Real>::epsilon();

/// The allowed motion nearest to `free`, with any bias taken off: relative motions, zero where closed.
template <class Real, int N>
struct NearestMotion {
  PerBlock<Real, N> relative;
  Truth<Real> well_conditioned;  ///< rounding leaves enough of the mass matrix
};

/// `pattern` as side() takes it.
template <class Real, int N, class Sides>
[[gnu::always_inline]] inline NearestMotion<Real, N> nearest_motion(const Stack<Real, N>& stack,
                                                                    const Sides& pattern,
                                                                    const Chain<Real, N>& chain,
                                                                    const Motion<Real, N>& free) {
  const Matrix<Real, N> mass = mass_matrix(stack, chain);
  const Vector<Real, N> momentum = generalised_momentum(stack, chain, free);
  const int size = stack.size();
  PerBlock<Real, N> open;
  PerBlock<Real, N> momenta;
  for (int k = 0; k < size; ++k) {
    const Real pivots = side<Real>(pattern, k);
    open[k] = pivots * pivots;
    momenta[k] = momentum[k];
  }
  ConstrainedMass<Real, N> constrained;
  constrained.factorise(size, open, [&](std::size_t i, std::size_t j) { return mass(i, j); });
  NearestMotion<Real, N> nearest{constrained.solve(momenta), Real(0) == Real(0)};
  for (int k = 0; k < size; ++k) {
    const Truth<Real> held = open[k] == Real(0);
    const Truth<Real> enough =
        constrained.diagonal(k) > mass(k, k) * Real(least_diagonal_share<Number<Real>>);
    nearest.well_conditioned = nearest.well_conditioned & (held | enough);
  }
  return nearest;
}

/// @throws IllConditioned where rounding takes too much of the mass matrix.
template <class Real, int N>
[[gnu::always_inline]] inline Vector<Real, N> nearest_allowed(const Stack<Real, N>& stack,
                                                              const Pattern& pattern,
                                                              const Chain<Real, N>& chain,
                                                              const Motion<Real, N>& free) {
  if (is_closed(pattern)) return Vector<Real, N>::Zero(pattern.size);
  const NearestMotion<Real, N> nearest = nearest_motion(stack, pattern, chain, free);
  if (!nearest.well_conditioned)
    throw IllConditioned(
        "block masses or sizes are too far apart: rounding would leave energies fewer than nine digits");
  return Eigen::Map<const Vector<Real, N>>(nearest.relative.data(), stack.size());
}

/// Relative angular accelerations φ̈ₖ, rad/s²; zero where closed. For two blocks these are Spanos et al. 2001,
/// Eqs. (8)–(18), and (19)–(28) of the linear equations. `directions` are directions_at() the state.
template <class Real, int N>
Vector<Real, N> accelerations(const Model<Real, N>& model, const State<Real, N>& state,
                              const Directions<Real, N>& directions,
                              const std::type_identity_t<Loading<Real>>& loading) {
  const Chain<Real, N> chain = make_chain(model.stack, state.pattern, directions);
  return nearest_allowed(model.stack, state.pattern, chain,
                         free_acceleration(model, state, directions, chain, loading));
}

template <class Real, int N>
Vector<Real, N> accelerations(const Model<Real, N>& model, const State<Real, N>& state,
                              const std::type_identity_t<Loading<Real>>& loading) {
  return accelerations(model, state, directions_at(model, state.angles), loading);
}

/// Kinetic energy and height of the centres times weight, J, from the ground.
template <class Real, int N>
Real energy(const Model<Real, N>& model, const State<Real, N>& state) {
  const Chain<Real, N> chain = make_chain(model.stack, state.pattern, directions_at(model, state.angles));
  const Vector<Real, N> rates = absolute(state.velocities);
  const Points<Real, N> speeds = centre_velocities(chain, rates);
  const Points<Real, N> places = centres(chain);
  Real sum = 0;
  for (int k = 0; k < model.stack.size(); ++k) {
    sum += model.stack.mass[k] * (speeds.col(k).squaredNorm() / 2 + model.gravity * places(1, k));
    sum += model.stack.inertia[k] * rates[k] * rates[k] / 2;
  }
  if (model.equations == Equations::small_angle) {
    // From upright to θ the levers grow in a straight line.
    const Vector<Real, N> angles = absolute(state.angles);
    const auto levers = [&](const Vector<Real, N>& at) {
      return small_angle_levers(model.stack, state.pattern, Directions<Real, N>{at, at});
    };
    const Vector<Real, N> mean = (levers(Vector<Real, N>::Zero(angles.size())) + levers(angles)) / 2;
    sum -= model.gravity * mean.dot(angles);
  }
  return sum;
}

}  // namespace rockstack
