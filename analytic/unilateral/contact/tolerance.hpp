#pragma once

#include <cmath>
#include <limits>

namespace rockstack {

/// What roundings make of numbers, in a number type, from what it is in double.
template <class Real>
Real tolerance(double in_double) {
  return Real(in_double) *
         (std::numeric_limits<Real>::epsilon() / Real(std::numeric_limits<double>::epsilon()));
}

/// What goes with the root of roundings: the time over which a force or a gap comes to be told from them.
template <class Real>
Real root_tolerance(double in_double) {
  using std::sqrt;
  return Real(in_double) *
         sqrt(std::numeric_limits<Real>::epsilon() / Real(std::numeric_limits<double>::epsilon()));
}

}  // namespace rockstack
