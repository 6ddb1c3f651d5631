#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace rockstack {

// Functions of the processor's numbers; those of other types come with them.
using std::abs;
using std::cbrt;
using std::ceil;
using std::exp;
using std::max;
using std::min;
using std::pow;
using std::sqrt;

/// The most terms of a series in a number type. A Taylor series to d digits costs least at an order of about
/// d ln 2 / 2 (Jorba & Zou 2005, Experimental Mathematics 14, 99–117); steps are longest a little above it.
template <class Real>
inline constexpr std::size_t max_terms = std::numeric_limits<Real>::digits * 2 / 5 + 1;

/// The most terms of an acceleration's series, so that the angle's has room for two more.
template <class Real>
inline constexpr std::size_t max_orders = max_terms<Real> - 2;

/// What a number of a calculation is made of: itself, or what a pack of numbers holds many of.
template <class Real>
struct NumberIn {
  using type = Real;
};
template <class Real>
using Number = typename NumberIn<Real>::type;

// One rule for a number and for a pack of numbers; of the latter, comparisons give a truth of each.
inline bool any(bool truth) {
  return truth;
}
template <class Real>
Real select(bool truth, const Real& one, const Real& other) {
  return truth ? one : other;
}

/// Zero as a number, or as a vector.
template <class Coefficient>
Coefficient zero() {
  if constexpr (requires { Coefficient::Zero(); })
    return Coefficient::Zero();
  else
    return Coefficient(0);
}

/// 1/i.
template <class Real>
inline const std::array<Real, max_terms<Real> + 1> reciprocals = [] {
  std::array<Real, max_terms<Real> + 1> result{};
  for (std::size_t i = 1; i < result.size(); ++i) result[i] = Real(1) / Real(i);
  return result;
}();

/// i, to be multiplied by.
template <class Real>
inline const std::array<Real, max_terms<Real> + 1> counting = [] {
  std::array<Real, max_terms<Real> + 1> result{};
  for (std::size_t i = 0; i < result.size(); ++i) result[i] = Real(i);
  return result;
}();

}  // namespace rockstack
