#pragma once

#include "analytic/scene/applied_forces.hpp"
#include "analytic/scene/restraint_law.hpp"

namespace rockstack {

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

}  // namespace rockstack
