#pragma once

#include "analytic/batch/pack.hpp"
#include "analytic/batch/step_rows.hpp"

namespace rockstack {

// What rows hold of the lanes of a pack, from `lane` on.

template <class Real>
Real load(const LaneRow& row, std::size_t lane) {
  return Real::load(row.lanes.data() + lane);
}

template <class Real>
void store(const Real& values, LaneRow& row, std::size_t lane) {
  values.store(row.lanes.data() + lane);
}

template <class Real>
void store_truth(const typename Real::Mask& mask, LaneRow& row, std::size_t lane) {
  store(select(mask, Real(1), Real(0)), row, lane);
}

template <class Real, int N>
Stack<Real, N> load_stack(const StepRows<static_cast<std::size_t>(N)>& rows, std::size_t lane) {
  Stack<Real, N> stack;
  for (std::size_t k = 0; k < rows.mass.size(); ++k) {
    stack.half_width[k] = load<Real>(rows.half_width[k], lane);
    stack.half_height[k] = load<Real>(rows.half_height[k], lane);
    stack.mass[k] = load<Real>(rows.mass[k], lane);
    stack.inertia[k] = load<Real>(rows.inertia[k], lane);
    stack.centre_x[k] = load<Real>(rows.centre_x[k], lane);
    stack.centre_y[k] = load<Real>(rows.centre_y[k], lane);
    stack.overhangs[k] = load<Real>(rows.face[k], lane) > Real(0);
  }
  return stack;
}

template <class Real, std::size_t N>
ScaledBodyForce<Real> load_body_force(const StepRows<N>& rows, std::size_t lane) {
  ScaledBodyForce<Real> body_force;
  const Real most = load<Real>(rows.body_force_terms, lane);
  std::size_t terms = 0;
  while (terms < max_terms<Real> && any(most > Real(static_cast<double>(terms)))) {
    body_force.x[terms] = load<Real>(rows.body_force_x[terms], lane);
    body_force.y[terms] = load<Real>(rows.body_force_y[terms], lane);
    ++terms;
  }
  body_force.x.terms = body_force.y.terms = terms;
  return body_force;
}

/// Directions of the angles of a pack, as direction_of() gives them.
template <class Set>
PlaneDirection<Pack<Set>> direction_of_each(const Pack<Set>& angle) {
  using Real = Pack<Set>;
  PlaneDirection<Real> result = near_upright(angle);
  if (!any(!is_near_upright(angle))) return result;
  struct alignas(64) Numbers {
    std::array<double, Real::size> lanes;
  } angles, cosines, sines;
  angle.store(angles.lanes.data());
  result.cosine.store(cosines.lanes.data());
  result.sine.store(sines.lanes.data());
  for (std::size_t lane = 0; lane < Real::size; ++lane) {
    if (std::abs(angles.lanes[lane]) <= 1) continue;
    cosines.lanes[lane] = std::cos(angles.lanes[lane]);
    sines.lanes[lane] = std::sin(angles.lanes[lane]);
  }
  return {Real::load(cosines.lanes.data()), Real::load(sines.lanes.data())};
}

}  // namespace rockstack
