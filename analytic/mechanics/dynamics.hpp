#pragma once

#include "analytic/mechanics/linkage.hpp"
#include "analytic/polynomials/polynomial.hpp"
#include "analytic/scene/applied_forces.hpp"
#include "analytic/scene/restraint_law.hpp"

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
template <class Real, int N = Eigen::Dynamic>
struct Motion {
  Points<Real, N> centre;
  Vector<Real, N> rotation;
};

/// A stack under gravity, in the number type of a calculation.
template <class Real, int N = Eigen::Dynamic>
struct Model {
  Stack<Real, N> stack;
  Real gravity;                                ///< m/s², across the ground
  Equations equations = Equations::nonlinear;  ///< other: no velocity terms
  std::vector<PushPoint<Real>> pushes = {};
  std::vector<RestraintLaw<Real>> restraints = {};  ///< as they are now
};

template <class Real, int N = Eigen::Dynamic>
Model<Real, N> make_model(const Scene& scene) {
  Stack<Real, N> stack = make_stack<Real, N>(scene);
  if (scene.equations == Equations::small_angle) stack = small_angle_stack(std::move(stack));
  return {std::move(stack), Real(scene.gravity) * cos(Real(scene.inclination)), scene.equations,
          push_points<Real>(scene), restraint_laws<Real>(scene)};
}

/// Where the stack is and how it moves: relative angles φₖ in rad and their rates in rad/s, exactly zero at
/// closed interfaces. Relative, because an impact happens where φₖ = 0 and must be resolved there.
template <class Real, int N = Eigen::Dynamic>
struct State {
  Pattern pattern;
  Vector<Real, N> angles;
  Vector<Real, N> velocities;

  int size() const { return N == Eigen::Dynamic ? pattern.size : N; }

  Interfaces closed() const {
    Interfaces result;
    for (int k = 0; k < size(); ++k) result.set(k, pattern[k] == Contact::closed);
    return result;
  }
};

/// Directions of blocks at a state: upright for the linear equations, (1, θ) for those of small angles.
template <class Real, int N>
Directions<Real, N> directions_at(const Model<Real, N>& model, const Vector<Real, N>& relative_angles) {
  const auto size = relative_angles.size();
  if (model.equations == Equations::linear) return {Vector<Real, N>::Ones(size), Vector<Real, N>::Zero(size)};
  if (model.equations == Equations::small_angle)
    return {Vector<Real, N>::Ones(size), absolute(relative_angles)};
  return directions<Real, N>(absolute(relative_angles));
}

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

/// Accelerations of the centres that would remain if no relative angle accelerated, m/s².
template <class Real, int N>
Points<Real, N> centripetal(const Chain<Real, N>& chain, const Vector<Real, N>& angular_velocities) {
  Points<Real, N> result = Points<Real, N>::Zero(2, chain.arms.cols());
  Point<Real> pivot = Point<Real>::Zero();
  for (Eigen::Index k = 0; k < chain.arms.cols(); ++k) {
    const Real square = angular_velocities[k] * angular_velocities[k];
    result.col(k) = pivot - square * chain.arms.col(k);
    pivot -= square * chain.links.col(k);
  }
  return result;
}

/// The horizontal lever of what hangs on each pivot as far as it turns with one block, Sₓ + Sᵧθ of a
/// small-angle stack, kg·m; S as in linkage.hpp.
template <class Real, int N>
Vector<Real, N> small_angle_levers(const Stack<Real, N>& stack, const Pattern& pattern,
                                   const Directions<Real, N>& directions) {
  Vector<Real, N> levers = Vector<Real, N>::Zero(stack.size());
  Real above = 0;  // mass, kg
  Real next = 0;   // where the pivot above is, from the middle, m
  for (int k = stack.size() - 1; k >= 0; --k) {
    const Real pivot = Real(sign(pattern[k])) * stack.half_width[k];
    const Real upright = (2 * above + stack.mass[k]) * stack.half_height[k];
    levers[k] = above * (next - pivot) - stack.mass[k] * pivot + upright * directions.sine[k];
    above += stack.mass[k];
    next = pivot;
  }
  return levers;
}

/// Adds what pushes alone make of free blocks: accelerations, or velocities of impulses.
template <class Real, int N>
void add_pushes(const Model<Real, N>& model, const Directions<Real, N>& directions,
                const Loading<Real>& loading, Motion<Real, N>& free) {
  const auto turn = [&](int k, const Point<Real>& arm) {
    return turned<Real>(arm.x(), arm.y(), directions.cosine[k], directions.sine[k]);
  };
  each_push(model.pushes, loading, turn, [&](int k, const Point<Real>& force, const Real& moment) {
    free.centre.col(k) += force / model.stack.mass[k];
    free.rotation[k] += moment / model.stack.inertia[k];
  });
}

/// Adds what restraints alone make of free blocks.
template <class Real, int N>
void add_restraints(const Model<Real, N>& model, const State<Real, N>& state,
                    const Directions<Real, N>& directions, const Chain<Real, N>& chain,
                    Motion<Real, N>& free) {
  const Points<Real, N> places = centres(chain);
  const Vector<Real, N> rates = absolute(state.velocities);
  const Points<Real, N> speeds = centre_velocities(chain, rates);
  const auto motion_of = [&](int k, const Point<Real>& own) -> PointMotion<Real> {
    if (k < 0) return {own, Point<Real>::Zero(), own};
    const Point<Real> arm = turned<Real>(own.x(), own.y(), directions.cosine[k], directions.sine[k]);
    return {places.col(k) + arm, speeds.col(k) + rates[k] * quarter_turned(arm), arm};
  };
  each_restraint(model.restraints, motion_of, [&](int k, const Point<Real>& force, const Real& moment) {
    free.centre.col(k) += force / model.stack.mass[k];
    free.rotation[k] += moment / model.stack.inertia[k];
  });
}

/// Lets restraints go to the lengths that they have at a state.
template <class Real, int N>
void follow_restraints(Model<Real, N>& model, const State<Real, N>& state) {
  const Directions<Real, N> directions = directions_at(model, state.angles);
  const Points<Real, N> places = centres(make_chain(model.stack, state.pattern, directions));
  const auto place = [&](int k, const Point<Real>& arm) -> Point<Real> {
    if (k < 0) return arm;
    return places.col(k) + turned<Real>(arm.x(), arm.y(), directions.cosine[k], directions.sine[k]);
  };
  for (RestraintLaw<Real>& law : model.restraints)
    law.follow(Point<Real>(place(law.to, law.to_arm) - place(law.from, law.from_arm)).norm());
}

/// What the blocks would do if nothing held them, less the centripetal bias, in the frame of the ground. A
/// small-angle stack has arms without width: weight has levers.
template <class Real, int N>
Motion<Real, N> free_acceleration(const Model<Real, N>& model, const State<Real, N>& state,
                                  const Directions<Real, N>& directions, const Chain<Real, N>& chain,
                                  const std::type_identity_t<Loading<Real>>& loading) {
  const int size = model.stack.size();
  const Point<Real>& ground = loading.ground;
  Motion<Real, N> free{Points<Real, N>::Zero(2, size), Vector<Real, N>::Zero(size)};
  const Point<Real> body_force{-ground.x(), -(model.gravity + ground.y())};
  if (model.equations == Equations::nonlinear) {
    free.centre = -centripetal(chain, absolute(state.velocities));
    free.centre.colwise() += body_force;
  } else {
    free.centre.colwise() = body_force;
  }
  if (model.equations == Equations::small_angle)
    free.rotation =
        -body_force.y() *
        small_angle_levers(model.stack, state.pattern, directions).cwiseQuotient(model.stack.inertia);
  if (loading.pushes > 0) add_pushes(model, directions, loading, free);
  if (!model.restraints.empty()) add_restraints(model, state, directions, chain, free);
  return free;
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
