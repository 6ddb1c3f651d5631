#pragma once

#include "analytic/mechanics/model.hpp"

namespace rockstack {

// What blocks would do if nothing held them, of which dynamics.hpp takes the nearest motion that a pattern
// allows.

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
[[gnu::cold]] void add_pushes(const Model<Real, N>& model, const Directions<Real, N>& directions,
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
[[gnu::cold]] void add_restraints(const Model<Real, N>& model, const State<Real, N>& state,
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
[[gnu::cold]] void follow_restraints(Model<Real, N>& model, const State<Real, N>& state) {
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

}  // namespace rockstack
