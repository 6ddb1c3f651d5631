#pragma once

#include <array>
#include <cmath>
#include <cstddef>

namespace rockstack {

// Functions of the processor's numbers; those of other types come with them.
using std::abs;
using std::atan2;
using std::cos;
using std::hypot;
using std::sin;
using std::sqrt;

// Cosine and sine of an angle in double precision, by one rule for a number and for numbers side by side, so
// that both have the same bits: what a library has for each parts in the last one. Up to one radian, which
// few blocks lean past, Taylor's polynomials leave less than an eighth of a rounding out; beyond it the
// library's functions take over, number by number.

/// (−1)ⁱ/(2i + first)!: of the cosine for first 0, of the sine for 1.
template <std::size_t Terms>
constexpr std::array<double, Terms> alternating_reciprocal_factorials(int first) {
  std::array<double, Terms> result{};
  long double factorial = 1;
  for (std::size_t i = 0; i < Terms; ++i) {
    const int order = 2 * static_cast<int>(i) + first;
    for (int j = order - 1; j <= order; ++j)
      if (j > 1) factorial *= j;
    result[i] = static_cast<double>((i % 2 == 0 ? 1 : -1) / factorial);
  }
  return result;
}

/// Whether an angle is within reach of near_upright().
template <class Real>
auto is_near_upright(const Real& angle) {
  return abs(angle) <= Real(1);
}

template <class Real>
struct PlaneDirection {
  Real cosine, sine;
};

/// c₀ + c₁x + … without the terms before `first`, over x to that power: terms of even and of odd order by
/// turns, as either has not to wait for the other.
template <std::size_t first, std::size_t Terms, class Real>
Real sum_by_turns(const std::array<double, Terms>& coefficients, const Real& x) {
  const Real square = x * x;
  Real last(coefficients[Terms - 1]);
  Real before(coefficients[Terms - 2]);
  for (std::size_t i = Terms - 2; i > first + 1; i -= 2) {
    last = last * square + Real(coefficients[i - 1]);
    before = before * square + Real(coefficients[i - 2]);
  }
  return before + last * x;
}

/// Precondition: is_near_upright(angle). What rounding takes of the cosine's 1 − h is added again.
template <class Real>
PlaneDirection<Real> near_upright(const Real& angle) {
  constexpr auto even = alternating_reciprocal_factorials<10>(0);
  constexpr auto odd = alternating_reciprocal_factorials<9>(1);
  const Real square = angle * angle;
  const Real cosine = sum_by_turns<2>(even, square);
  const Real sine = sum_by_turns<1>(odd, square);
  const Real half = square * Real(0.5);
  const Real upright = Real(1) - half;
  const Real lost = (Real(1) - upright) - half;
  return {upright + (lost + square * square * cosine), angle + angle * square * sine};
}

/// Direction of one angle.
inline PlaneDirection<double> direction_of(double angle) {
  if (is_near_upright(angle)) return near_upright(angle);
  return {std::cos(angle), std::sin(angle)};
}

/// In number types that are not computed side by side.
template <class Real>
PlaneDirection<Real> direction_of(const Real& angle) {
  return {cos(angle), sin(angle)};
}

}  // namespace rockstack
