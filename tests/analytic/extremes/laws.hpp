#pragma once

#include <string>

#include "analytic/scene/history.hpp"
#include "analytic/scene/scene.hpp"
#include "tests/analytic/unilateral/solve_unilateral.hpp"

namespace rockstack::testing {

/// How far a history is from what no motion may leave. Gains are in roundings of the largest energy
/// concerned, each as large as the stack makes it: where little of an entry of the mass matrix remains when
/// the motions of the other interfaces are taken out, a rounding of the velocities weighs that much more.
struct Breaches {
  std::string fault;        ///< what is broken outright: numbers that are none, times that go back; or empty
  double impact_gain = 0;   ///< kinetic energy gained by an impact
  double flight_drift = 0;  ///< energy that changes between events of a free stack
  std::size_t events = 0;
};

/// Holds a history, with its samples, against the laws. Energies are taken at 113 bits from the numbers that
/// the history holds.
Breaches breaches(const Scene& scene, const History& history);

/// Breaches of a motion with friction: no event gains kinetic energy, none is gained between events on still
/// ground, and no block sinks into another. Roundings are those of the whole stack's energies.
Breaches contact_breaches(const Scene& scene, const History& history);

/// By how much a rounding in the solver's operations may weigh more than one of the scene's own numbers. The
/// momentum of a block about its own pivot, m r × the velocity that what is below it has at height H, is
/// rounded; so the rotation that comes out of it is off by H/r roundings of that velocity over H, and by as
/// many more as elimination leaves little of an entry of the mass matrix. Roundings of long double, where the
/// solver takes to it, are 2⁻¹¹ of those. An estimate and no bound: an angle at an impact that has hardly
/// left zero is off by more shares of itself, as a rounding of the time is (scene 7081).
double weight_of_rounding(const Scene& scene, const History& history);

}  // namespace rockstack::testing
