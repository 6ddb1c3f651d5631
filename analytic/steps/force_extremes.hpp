#pragma once

#include "analytic/polynomials/crossing.hpp"
#include "analytic/scene/history.hpp"

namespace rockstack {

/// Takes a normal force and the ratio of the tangential one to it into account.
template <class Real>
void raise_demand(BasicDemand<Real>& demand, const Real& normal, const Real& ratio, const Real& time) {
  if (normal < demand.least_normal) {
    demand.least_normal = normal;
    demand.least_normal_time = time;
  }
  if (ratio > demand.friction) {
    demand.friction = ratio;
    demand.friction_time = time;
  }
}

/// Calls `note_at`, which raises a demand by what acts at s of a step, where forces demand most up to `end`
/// of its length, to rounding: where the normal force is least, and where ±T/N is largest. The latter is the
/// ratio μ at which the maximum of ±T − μN comes down to zero (Dinkelbach 1967, Management Science 13,
/// 492–498).
template <class Real, class NoteAt>
void note_extremes(const BasicDemand<Real>& demand, const Polynomial<Real>& normal,
                   const Polynomial<Real>& tangential, const Real& end, const Real& rounding,
                   const NoteAt& note_at) {
  // Where share · N + side · T passes `least` most.
  const auto note_maximum = [&](const Real& share, const Real& side, const Real& least, const Real& slack) {
    Polynomial<Real> sum = combined(share, normal, side, tangential);
    rescale(sum, end);
    if (const auto top = maximum<Real>(sum, least, slack)) note_at(top->s * end);
  };
  note_maximum(-1, 0, rounding - demand.least_normal, rounding);
  for (const Real& side : {Real(1), Real(-1)})
    for (Real before = -1; demand.friction > before && demand.friction <= std::numeric_limits<Real>::max();) {
      before = demand.friction;
      const Real negligible = rounding * (1 + before);
      note_maximum(-before, side, negligible, negligible);
    }
}

}  // namespace rockstack
