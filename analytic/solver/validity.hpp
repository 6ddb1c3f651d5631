#pragma once

#include "analytic/steps/dense_output.hpp"
#include "analytic/steps/force_extremes.hpp"

namespace rockstack {

// The model neither lifts nor slips. Whether real blocks would is a result: the least normal force at each
// interface, and the largest ratio of tangential to normal force, which their friction must reach; the same
// for impulses.

/// Takes what one interface bears at one time into account; what is `rounding` or less counts as zero.
template <class Real>
void note_demand(BasicDemand<Real>& demand, const Real& raw, const Real& tangential, const Real& rounding,
                 const Real& time) {
  const Real normal = abs(raw) <= rounding ? Real(0) : raw;
  if (normal == 0 && abs(tangential) <= rounding) return;
  const Real ratio = normal > 0 ? abs(tangential) / normal : std::numeric_limits<Real>::infinity();
  raise_demand(demand, normal, ratio, time);
}

/// Keeps the first times of what has come to be, both no earlier than they are known.
template <class Real>
void note_first(BasicDemand<Real>& demand, const Real& available, const Real& pull_time,
                const Real& slip_time) {
  if (demand.least_normal < 0) demand.first_pull_time = std::min(demand.first_pull_time, pull_time);
  if (demand.friction > available) demand.first_slip_time = std::min(demand.first_slip_time, slip_time);
}

/// Takes a solution into account, but for interfaces that bear no more than is negligible.
template <class Real, int N>
void note_demands(std::vector<BasicDemand<Real>>& demands, const PatternSolution<Real, N>& solution,
                  const Real& negligible, const std::vector<Real>& available, const Real& time) {
  for (int k = 0; k < solution.pattern.size; ++k) {
    const Real& normal = solution.reactions.normal[k];
    const Real& tangential = solution.reactions.tangential[k];
    if (abs(normal) <= negligible && abs(tangential) <= negligible) continue;
    BasicDemand<Real>& demand = demands[k];
    note_demand(demand, normal, tangential, solution.rounding[k], time);
    note_first(demand, available[k], time, time);
  }
}

/// Since when, along a step up to `end` of its length, the interface pulls, or needs more than `available`
/// friction: `start` and `length` are those of the step, s.
template <class Real>
void note_first_along(BasicDemand<Real>& demand, const ForcePolynomials<Real>& force, const Real& end,
                      const Real& available, const Real& start, const Real& length) {
  // Where `share` · N + side · T first falls below zero.
  const auto first_below = [&](const Real& share, const Real& side) {
    const Polynomial<Real> room = combined(share, force.normal, side, force.tangential);
    if (room[0] < 0) return start;
    const auto crossing = first_crossing(room);
    return start + std::min(crossing.value_or(end), end) * length;
  };
  note_first(demand, available, first_below(1, 0),
             std::min(first_below(available, 1), first_below(available, -1)));
}

/// True where sums of coefficients (Hull) tell that a step demands no more than was known.
template <class Real>
bool demands_no_more(const BasicDemand<Real>& demand, const ForcePolynomials<Real>& force,
                     const Real& rounding) {
  const bool bounded = demand.friction <= std::numeric_limits<Real>::max();
  const Real ratio = bounded ? demand.friction : Real(0);
  const Real least = demand.least_normal - rounding;
  const Real negligible = bounded ? rounding * (1 + ratio) : std::numeric_limits<Real>::infinity();
  Real normal = 0;
  Real right = 0, left = 0;  // T − μN and −T − μN
  for (std::size_t n = 0; n < force.normal.terms; ++n) {
    const Real held = ratio * force.normal[n];
    normal += force.normal[n];
    right += force.tangential[n] - held;
    left -= force.tangential[n] + held;
    if (!(normal >= least && right <= negligible && left <= negligible)) return false;
  }
  return true;
}

/// The greatest demands along a step up to `end` of its length; `start` and `length` are the step's, s.
template <class Real>
void note_demand_along(BasicDemand<Real>& demand, const ForcePolynomials<Real>& force, const Real& end,
                       const Real& rounding, const Real& available, const Real& start, const Real& length) {
  if (demands_no_more(demand, force, rounding)) return;
  if (end < 1) {
    ForcePolynomials<Real> part = force;
    rescale(part.normal, end);
    rescale(part.tangential, end);
    if (demands_no_more(demand, part, rounding)) return;
  }
  note_extremes(demand, force.normal, force.tangential, end, rounding, [&](const Real& s) {
    note_demand(demand, value(force.normal, s), value(force.tangential, s), rounding, start + s * length);
  });
  // Where it pulls, or needs more friction than surfaces have, and it is not known since when.
  const Real never = std::numeric_limits<Real>::infinity();
  if ((demand.least_normal < 0 && demand.first_pull_time == never) ||
      (demand.friction > available && demand.first_slip_time == never))
    note_first_along(demand, force, end, available, start, length);
}

}  // namespace rockstack
