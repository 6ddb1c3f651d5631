#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>

namespace rockstack {

/// c₀ + c₁s + … over one step, s in [0, 1].
template <class Real, std::size_t terms>
using Polynomial = std::array<Real, terms>;

template <class Real, std::size_t terms>
Real value(const Polynomial<Real, terms>& polynomial, const Real& s) {
  Real sum = 0;
  for (std::size_t i = terms; i-- > 0;) sum = sum * s + polynomial[i];
  return sum;
}

/// Derivative with respect to s.
template <class Real, std::size_t terms>
Real slope(const Polynomial<Real, terms>& polynomial, const Real& s) {
  Real sum = 0;
  for (std::size_t i = terms; i-- > 1;) sum = sum * s + Real(i) * polynomial[i];
  return sum;
}

/// The quartic through values at s = 0, 1/4, 1/2, 3/4 and 1 (Newton's forward differences).
template <class Real>
Polynomial<Real, 5> quartic_through(Polynomial<Real, 5> values) {
  for (std::size_t order = 1; order < 5; ++order) {
    for (std::size_t i = 4; i >= order; --i) values[i] -= values[i - 1];
  }
  const auto& [f, d1, d2, d3, d4] = values;
  return {f, 4 * d1 - 2 * d2 + 4 * d3 / 3 - d4, 8 * d2 - 8 * d3 + 22 * d4 / 3, 32 * d3 / 3 - 16 * d4,
          32 * d4 / 3};
}

/// Coefficients in the Bernstein basis: their hull holds the polynomial on [0, 1].
template <class Real, std::size_t terms>
Polynomial<Real, terms> bernstein(const Polynomial<Real, terms>& polynomial) {
  Polynomial<Real, terms> result = polynomial;
  Real binomial = 1;
  for (std::size_t i = 1; i < terms; ++i) {
    binomial = binomial * Real(terms - i) / Real(i);
    result[i] /= binomial;
  }
  for (std::size_t level = 1; level < terms; ++level) {
    for (std::size_t i = terms - 1; i >= level; --i) result[i] += result[i - 1];
  }
  return result;
}

/// The two halves of a polynomial in Bernstein form (de Casteljau).
template <class Real, std::size_t terms>
struct Halves {
  Polynomial<Real, terms> left, right;
};

template <class Real, std::size_t terms>
Halves<Real, terms> halve(Polynomial<Real, terms> coefficients) {
  Halves<Real, terms> halves;
  for (std::size_t level = 0; level < terms; ++level) {
    halves.left[level] = coefficients[0];
    halves.right[terms - 1 - level] = coefficients[terms - 1 - level];
    for (std::size_t i = 0; i + 1 < terms - level; ++i)
      coefficients[i] = (coefficients[i] + coefficients[i + 1]) / 2;
  }
  return halves;
}

/// Where a polynomial that is positive on the left of its only sign change in (low, high) crosses zero:
/// Newton's method kept inside the bracket by bisection, to rounding.
template <class Real, std::size_t terms>
Real bracketed_root(const Polynomial<Real, terms>& polynomial, Real low, Real high) {
  Real s = (low + high) / 2;
  for (int iteration = 0; iteration < 4 * std::numeric_limits<Real>::digits; ++iteration) {
    const Real height = value(polynomial, s);
    if (height == 0) return s;
    (height > 0 ? low : high) = s;
    const Real newton = s - height / slope(polynomial, s);
    const Real next = newton > low && newton < high ? newton : (low + high) / 2;
    using std::abs;
    if (abs(next - s) <= std::numeric_limits<Real>::epsilon() * s) return next;
    s = next;
  }
  return s;
}

/// The first s in [0, 1] after which a polynomial is negative; nothing where it stays at or above zero.
/// Touching zero without crossing is no crossing, but from within rounding of zero the two cannot be told
/// apart: then it counts as one. Every crossing is found, however close to the next: an
/// interval is dropped only where no Bernstein coefficient is negative, and searched by Newton only where
/// their signs change once (Descartes).
template <class Real, std::size_t terms>
std::optional<Real> first_crossing(const Polynomial<Real, terms>& polynomial) {
  using std::abs;
  Real reach = 0;
  for (std::size_t i = 1; i < terms; ++i) reach += abs(polynomial[i]);
  if (polynomial[0] >= reach) return std::nullopt;

  struct Search {
    const Polynomial<Real, terms>& polynomial;

    std::optional<Real> operator()(const Polynomial<Real, terms>& coefficients, Real low, Real width) const {
      int changes = 0;
      int last = 0;
      for (const Real& coefficient : coefficients) {
        const int current = (coefficient > 0) - (coefficient < 0);
        if (current != 0 && last != 0 && current != last) ++changes;
        if (current != 0) last = current;
      }
      if (changes == 0) return last < 0 ? std::optional(low) : std::nullopt;
      if (width < std::numeric_limits<Real>::epsilon()) return low;
      if (changes == 1 && last < 0) return bracketed_root(polynomial, low, low + width);
      const auto halves = halve(coefficients);
      if (const auto left = (*this)(halves.left, low, width / 2)) return left;
      return (*this)(halves.right, low + width / 2, width / 2);
    }
  };
  return Search{polynomial}(bernstein(polynomial), Real(0), Real(1));
}

}  // namespace rockstack
