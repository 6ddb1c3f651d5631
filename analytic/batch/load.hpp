#pragma once

#include "analytic/batch/pack.hpp"
#include "analytic/batch/step_rows.hpp"

namespace rockstack {

// What rows hold of the lanes of a pack, from `lane` on.

template <class Real>
Real load(const LaneRow& row, std::size_t lane) {
  return Real::load(row.lanes.data() + lane);
}

template <class Real, int N>
Linkage<Real, N> load_linkage(const StepRows<static_cast<std::size_t>(N)>& rows, std::size_t lane) {
  Linkage<Real, N> linkage;
  linkage.blocks = N;
  for (std::size_t k = 0; k < linkage.size(); ++k) {
    linkage.moment_x[k] = load<Real>(rows.moment_x[k], lane);
    linkage.moment_y[k] = load<Real>(rows.moment_y[k], lane);
    linkage.link_x[k] = load<Real>(rows.link_x[k], lane);
    linkage.link_y[k] = load<Real>(rows.link_y[k], lane);
    linkage.inertia[k] = load<Real>(rows.inertia[k], lane);
    linkage.mass[k] = load<Real>(rows.mass[k], lane);
    linkage.width[k] = load<Real>(rows.width[k], lane);
    linkage.free[k] = load<Real>(rows.free[k], lane);
  }
  return linkage;
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

}  // namespace rockstack
