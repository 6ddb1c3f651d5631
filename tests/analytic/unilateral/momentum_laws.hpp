#pragma once

#include "tests/analytic/unilateral/solve_unilateral.hpp"

namespace rockstack::testing {

/// A change of velocities, by impulses or by forces over a short time, and what there would be of it without
/// contact, of each block alike.
struct Change {
  Poses<> at;          ///< where
  Poses<> rate;        ///< of what slides, after it
  Poses<> of_rates;    ///< the change
  Point<double> free;  ///< m/s
  double scale;        ///< of impulses, N·s
};

/// Whether all interfaces obey Coulomb's and Signorini's laws, as blocks' momenta alone tell; which face a
/// pair of corners is on may be either.
bool obeys_laws(const Scene& scene, const Change& change);

/// What a corner on a face may approach it with.
struct Approach {
  double speed;  ///< of roundings, m/s
  double time;   ///< s until the next event, in which it may go in by roundings of its coordinates
};

/// Whether no corner that is on a face goes into it.
bool nothing_approaches(const Scene& scene, const Bodies<>& bodies, const Approach& harmless);

Poses<> difference(const Poses<>& one, const Poses<>& other);

/// Impacts without bounce that take more than a thousandth of what a fall from the stack's height would, and
/// those that do not obey.
struct ImpactTally {
  int impacts = 0, broken = 0;
};
ImpactTally impacts_by_momenta(const Scene& scene, const History& history);

}  // namespace rockstack::testing
