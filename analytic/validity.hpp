#pragma once

#include "analytic/flow.hpp"
#include "analytic/outcome.hpp"
#include "analytic/scene/history.hpp"

namespace rockstack {

// The model neither lifts nor slips. Whether real blocks would is a result: the least normal force at each
// interface, and the largest ratio of tangential to normal force, which their friction must reach; the same
// for impulses.

/// Takes what one interface bears at one time into account; what is `rounding` or less counts as zero.
template <class Real>
void note_demand(BasicDemand<Real>& demand, const Real& raw, const Real& tangential, const Real& rounding,
                 const Real& time) {
  using std::abs;
  const Real normal = abs(raw) <= rounding ? Real(0) : raw;
  if (normal == 0 && abs(tangential) <= rounding) return;
  if (normal < demand.least_normal) {
    demand.least_normal = normal;
    demand.least_normal_time = time;
  }
  const Real ratio = normal > 0 ? abs(tangential) / normal : std::numeric_limits<Real>::infinity();
  if (ratio > demand.friction) {
    demand.friction = ratio;
    demand.friction_time = time;
  }
}

/// Takes an outcome into account.
template <class Real, int N>
void note_demands(std::vector<BasicDemand<Real>>& demands, const Outcome<Real, N>& outcome,
                  const Real& time) {
  for (int k = 0; k < outcome.pattern.size; ++k) {
    note_demand(demands[static_cast<std::size_t>(k)], outcome.reactions.normal[k],
                outcome.reactions.tangential[k], outcome.rounding[k], time);
  }
}

/// Takes the forces at s into a step into account.
template <class Real, int N>
void note_demands(std::vector<BasicDemand<Real>>& demands, const Flow<Real, N>& flow, const Real& s,
                  const Real& rounding, const Real& time) {
  for (std::size_t k = 0; k < demands.size(); ++k)
    note_demand(demands[k], value(flow.forces[k].normal, s), value(flow.forces[k].tangential, s), rounding,
                time);
}

}  // namespace rockstack
