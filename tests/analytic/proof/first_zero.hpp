#pragma once

#include <optional>
#include <vector>

#include "tests/analytic/proof/ball.hpp"

namespace rockstack::proof {

/// A function of the time since a step's start that is > 0 until an event: sign · Σ cₙ tⁿ, with |cₙ| ≤ bound
/// / radiusⁿ of all coefficients, by Cauchy's estimate on the disc of that radius. Coefficients of orders
/// below `zeros` are exactly zero.
struct Guard {
  arb_srcptr coefficients;
  slong terms;
  int zeros;
  int sign;
  Ball bound, radius;  ///< the radius in s
};

/// Where a guard is positive, and where not any more.
struct ZeroSearch {
  std::vector<Ball> cover;   ///< ends of cells, from 0 on, in each of which the guard is positive after 0
  std::optional<Ball> zero;  ///< it falls through zero once in this interval, and is positive before it
};

/// The first zero of a guard within a time, 0 < length < radius. It is divided by t^zeros, and cells are
/// halved until the mean value form is positive, or until it falls strictly with a change of sign; then
/// follows Newton's method in intervals.
/// @throws Undecided where neither happens: where the guard touches zero, or is zero at an end.
ZeroSearch first_zero(const Guard& guard, const Ball& length);

}  // namespace rockstack::proof
