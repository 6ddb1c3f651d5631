#pragma once

#include "analytic/outcome.hpp"
#include "analytic/scene/history.hpp"

namespace rockstack {

// The model neither lifts nor slips. Whether real blocks would is a result: the least normal force at each
// interface, and the largest ratio of tangential to normal force, which their friction must reach; the same
// for impulses.

/// Takes what one interface bears at one time into account.
template <class Real>
void note_demand(BasicDemand<Real>& demand, const Real& normal, const Real& tangential, const Real& time) {
  using std::abs;
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

/// Takes an outcome into account; what is rounding counts as zero.
template <class Real, int N>
void note_demands(std::vector<BasicDemand<Real>>& demands, const Outcome<Real, N>& outcome,
                  const Real& time) {
  using std::abs;
  for (int k = 0; k < outcome.pattern.size; ++k) {
    const Real& raw = outcome.reactions.normal[k];
    const Real normal = abs(raw) <= outcome.rounding ? Real(0) : raw;
    const Real& tangential = outcome.reactions.tangential[k];
    if (normal == 0 && abs(tangential) <= outcome.rounding) continue;
    note_demand(demands[static_cast<std::size_t>(k)], normal, tangential, time);
  }
}

}  // namespace rockstack
