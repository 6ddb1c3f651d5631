#pragma once

#include "analytic/polynomials/crossing.hpp"
#include "analytic/unilateral/contact/tolerance.hpp"
#include "analytic/unilateral/springs/spring_point.hpp"

namespace rockstack {

// What a contact does that presses by roundings alone, and how long a slider may stick and slip.
//
// Places round to ρ = 9 ε H and velocities to ν = 9 ε v, with H the height of the stack and v the fastest
// velocity in it. So a depth rounds to ρ, a normal force kδ + cδ̇ to N₀ = kρ + cν, the force along the face
// likewise to T₀, and what parts standing still from sliding, F = μN − |k_t τ + c_t τ̇|, to μN₀ + T₀. Where
// springs bear nothing yet, or no longer, all of these are roundings: each has a sign, which says nothing.
// Blocks that are set down unloaded come to press one after another: in a column N of interface k goes with
// tᵏ behind dashpots, and with t²ᵏ without them.
//
// The rule: what is within its rounding of zero has no sign. A point goes on with what it does until one of
// its quantities has left that range, to either side. The change is late by the time that takes, but the
// forces that act meanwhile are wrong by no more than they round to.
//
// It also ends what would stick and slip without end. Where a slider starts or stops, the force along the
// face and the rate of its stretch are continuous in places, velocities and stretches: behind a dashpot as
// the force is clamped to ±μN, without one as the stretch is (a sweeping process). So accelerations are, and
// F has one rate on both sides of F = 0. Filippov's sliding, where either side drives F back to zero, does
// not occur. A slider that is at F = 0 for a while, as where N and T vanish together, creeps: it sticks or
// slips, whichever it did, while F is within its rounding, and the difference is one of rounding. Between two
// changes F goes through twice that.

/// What roundings make of places and velocities, and so of the quantities of points. SI units.
template <class Real>
struct SpringRounding {
  Real place = 0;  ///< ρ, m
  Real speed = 0;  ///< ν, m/s

  SpringRounding(const BasicFrictionStack<Real>& stack, const BasicBodies<Real>& bodies) {
    using std::abs;
    Real height = 0;
    for (const Block& block : stack.blocks) height += 2 * Real(block.half_height);
    Real fastest = 0;
    for (const BasicBodyPlacement<Real>& rate : bodies.rate)
      fastest = std::max<Real>(fastest, abs(rate.x) + abs(rate.y) + height * abs(rate.angle));
    place = tolerance<Real>(2e-15) * height;
    speed = tolerance<Real>(2e-15) * fastest;
  }

  /// Of a normal force, N.
  Real normal(const PointLaw<Real>& law) const { return law.stiffness * place + law.damping * speed; }

  /// Of what a point's friction has left, N.
  Real strength(const PointLaw<Real>& law) const {
    return law.friction * normal(law) + law.tangential_stiffness * place + law.tangential_damping * speed;
  }

  /// Of a slider's rate, m/s: (k_t τ + c_t τ̇ − μN)/c_t of the slip, or without dashpots τ̇ − μkδ̇/k_t.
  Real slider_rate(const PointLaw<Real>& law) const {
    if (law.tangential_damping > 0) return strength(law) / law.tangential_damping;
    return speed * (1 + law.friction * law.stiffness / law.tangential_stiffness);
  }
};

/// Where a series becomes negative. From a start within its rounding of zero it does so where it first leaves
/// that range downwards, or, once it has left it upwards, where it is zero.
template <class Real>
std::optional<Real> told_crossing(Polynomial<Real> series, const Real& rounding) {
  using std::abs;
  if (series.terms == 0 || !(abs(series[0]) <= rounding)) return first_crossing(series);
  series[0] = std::max<Real>(series[0], 0);
  const std::optional<Real> crossing = first_crossing(series);
  if (!crossing) return crossing;
  const std::optional<Real> leaves = first_crossing(line(rounding, -1, series));
  if (leaves && *leaves < *crossing) return crossing;
  return first_crossing(line(rounding, 1, series));
}

}  // namespace rockstack
