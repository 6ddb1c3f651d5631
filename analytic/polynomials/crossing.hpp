#pragma once

#include <optional>

#include "analytic/polynomials/polynomial.hpp"

namespace rockstack {

/// Where a polynomial that is positive on the left of its only sign change in (low, high) crosses zero, to
/// rounding: Newton's method from s, kept inside the bracket by bisection. Newton's method may creep, as near
/// a zero of high order. After four points for each digit of a number, bisection goes on alone. It always
/// ends: a bracket cannot be halved more often than a number has exponents and digits.
template <class Real>
Real bracketed_root(const Polynomial<Real>& polynomial, Real low, Real high, Real s) {
  const Real rounding = std::numeric_limits<Real>::epsilon();
  for (int points = 1;; ++points) {
    const auto [height, slope] = tangent(polynomial, s);
    if (height == 0) return s;
    (height > 0 ? low : high) = s;
    Real next = (low + high) / 2;
    if (points <= 4 * std::numeric_limits<Real>::digits) {
      const Real newton = s - height / slope;
      // At the root, rounding may put the next point on the bracket's end or beyond.
      if (abs(newton - s) <= rounding * s) return std::clamp(newton, low, high);
      if (newton > low && newton < high) next = newton;
    }
    if (abs(next - s) <= rounding * s) return next;
    s = next;
  }
}

/// True where its hull tells that the polynomial stays above zero over (0, 1].
template <class Real>
bool stays_positive(const Polynomial<Real>& polynomial) {
  return polynomial.terms > 0 && hull_beyond_zero(polynomial).least > 0;
}

/// True where the hull beyond zero of a polynomial tells the same of it, or of its opposite for a `side`
/// below zero, and that it does not come within rounding of zero unless it starts there: none of its
/// coefficients is larger than the hull's width.
template <class Real>
bool stays_clear(const Polynomial<Real>& polynomial, const Hull<Real>& bounds, int side = 1) {
  const Real size = polynomial[0] == 0 ? Real(0) : 2 * Real(polynomial.terms) * bounds.size();
  return (side > 0 ? bounds.least : -bounds.greatest) > 16 * std::numeric_limits<Real>::epsilon() * size;
}

/// True where the same bound on the derivative tells that the polynomial falls for all s in [0, 1].
template <class Real>
bool falls(const Polynomial<Real>& polynomial) {
  Real sum = 0;
  for (std::size_t i = 1; i < polynomial.terms; ++i) {
    sum += Real(i) * polynomial[i];
    if (!(sum < 0)) return false;
  }
  return polynomial.terms > 1;
}

/// The first zero of a falling polynomial's first three terms, or 1/2 where it is not in (0, 1).
template <class Real>
Real quadratic_root(const Polynomial<Real>& polynomial) {
  const Real square = polynomial.terms > 2 ? polynomial[2] : Real(0);
  const Real radicand = polynomial[1] * polynomial[1] - 4 * square * polynomial[0];
  const Real root = 2 * polynomial[0] / (sqrt(radicand) - polynomial[1]);
  return select((radicand > Real(0)) & (root > Real(0)) & (root < Real(1)), root, Real(0.5));
}

/// The polynomial divided by the power of s that it holds: what is left after a start exactly at zero.
template <class Real>
Polynomial<Real> deflated(const Polynomial<Real>& polynomial) {
  std::size_t zeros = 0;
  while (zeros < polynomial.terms && polynomial[zeros] == 0) ++zeros;
  Polynomial<Real> result;
  result.terms = polynomial.terms - zeros;
  std::copy(polynomial.begin() + zeros, polynomial.end(), result.begin());
  return result;
}

/// The first s in [0, 1] after which a polynomial is negative; nothing where it stays at or above zero.
/// Touching zero without crossing is no crossing, but from within rounding of zero the two cannot be told
/// apart: then it counts as one. Every crossing is found, however close to the next: an
/// interval is dropped only where no Bernstein coefficient is negative, and searched by Newton only where
/// their signs change once (Descartes). Most steps need none of that: bounds on the coefficients exclude a
/// crossing, or tell that there is one at most.
template <class Real>
std::optional<Real> first_crossing(const Polynomial<Real>& whole) {
  if (stays_positive(whole)) return std::nullopt;
  const Polynomial<Real> polynomial = deflated(whole);
  if (polynomial.terms == 0) return std::nullopt;
  if (polynomial[0] > 0 && falls(polynomial)) {
    if (value(polynomial, Real(1)) >= 0) return std::nullopt;
    return bracketed_root<Real>(polynomial, 0, 1, quadratic_root(polynomial));
  }

  struct Search {
    const Polynomial<Real>& polynomial;

    std::optional<Real> operator()(const Polynomial<Real>& coefficients, Real low, Real width) const {
      int changes = 0;
      int last = 0;
      for (const Real& coefficient : coefficients) {
        const int current = (coefficient > 0) - (coefficient < 0);
        if (current != 0 && last != 0 && current != last) ++changes;
        if (current != 0) last = current;
      }
      if (changes == 0) return last < 0 ? std::optional(low) : std::nullopt;
      if (width < std::numeric_limits<Real>::epsilon()) return low;
      if (changes == 1 && last < 0) return bracketed_root(polynomial, low, low + width, low + width / 2);
      const auto halves = halve(coefficients);
      if (const auto left = (*this)(halves.left, low, width / 2)) return left;
      return (*this)(halves.right, low + width / 2, width / 2);
    }
  };
  return Search{polynomial}(bernstein(polynomial), Real(0), Real(1));
}

/// Where a polynomial is highest on [0, 1], and how high.
template <class Real>
struct Maximum {
  Real s;
  Real height;

  void raise(const Maximum& other) {
    if (other.height > height) *this = other;
  }
};

/// The maximum to within `slack` or rounding; nothing where the polynomial does not pass `least`. It is at an
/// end or at the zero of a slope that falls, or is searched for where Bernstein coefficients may pass it.
template <class Real>
std::optional<Maximum<Real>> maximum(const Polynomial<Real>& polynomial, const Real& least,
                                     const Real& slack = 0) {
  struct Search {
    Maximum<Real> best;
    Real slack;

    void operator()(const Polynomial<Real>& coefficients, const Real& low, const Real& width) {
      best.raise({low, coefficients[0]});
      best.raise({low + width, coefficients[coefficients.terms - 1]});
      if (!(*std::max_element(coefficients.begin(), coefficients.end()) > best.height + slack)) return;
      const auto halves = halve(coefficients);
      (*this)(halves.left, low, width / 2);
      (*this)(halves.right, low + width / 2, width / 2);
    }
  };
  if (polynomial.terms == 0 || hull(polynomial).greatest <= least) return std::nullopt;
  const Real rounding = 4 * std::numeric_limits<Real>::epsilon() * (abs(polynomial[0]) + reach(polynomial));
  Search search{{0, polynomial[0]}, std::max(slack, rounding)};
  search.best.raise({1, value(polynomial, Real(1))});
  if (!is_monotone(polynomial)) {
    const Polynomial<Real> slope = derivative(polynomial);
    if (falls(slope)) {
      if (const auto s = first_crossing(slope)) search.best.raise({*s, value(polynomial, *s)});
    } else {
      search.best.raise({0, least});
      search(bernstein(polynomial), Real(0), Real(1));
    }
  }
  if (!(search.best.height > least)) return std::nullopt;
  return search.best;
}

}  // namespace rockstack
