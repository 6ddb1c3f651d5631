#pragma once

#include "analytic/polynomials/polynomial.hpp"

namespace rockstack {

/// The share of a step by whose end an open angle has come back, or all of it, as far as the angle, its rate
/// and its acceleration at the start can tell, both by the step's length; `rate` is √(g/H). What lies behind
/// that impact is not worth a series.
template <class Real>
Real landing(const Real& angle, const Real& speed, const Real& acceleration, const Real& length,
             const Real& rate) {
  const Real zero = 0, whole = 1;
  const Real radicand = speed * speed - 2 * acceleration * angle;
  const auto returns = (radicand > zero) & ((speed < zero) | (acceleration < zero));
  if (!any(returns)) return whole;
  const Real root = sqrt(radicand);
  const Real s = select(speed < zero, 2 * angle / (root - speed), (root + speed) / -acceleration);
  const Real end = s * (1 + s * length * rate) * Real(1.0625);
  return select(returns & (s > zero), min(whole, end), whole);
}

}  // namespace rockstack
