#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <limits>
#include <optional>

namespace rockstack {

/// The most terms of a series in a number type. A Taylor series to d digits costs least at an order of about
/// d ln 2 / 2 (Jorba & Zou 2005, Experimental Mathematics 14, 99–117); a little above it the steps between
/// events are longest.
template <class Real>
inline constexpr std::size_t max_terms = std::numeric_limits<Real>::digits * 2 / 5 + 1;

/// c₀ + c₁s + … over one step, s in [0, 1]. Coefficients from `terms` on have no value.
template <class Real>
struct Polynomial {
  std::size_t terms = 0;
  std::array<Real, max_terms<Real>> coefficients;

  Polynomial() {}  // a step makes many, most of them to be filled
  Polynomial(const Polynomial& other) { *this = other; }
  Polynomial& operator=(const Polynomial& other) {
    terms = other.terms;
    std::copy_n(other.begin(), terms, begin());
    return *this;
  }
  ~Polynomial() = default;
  Polynomial(std::initializer_list<Real> values) : coefficients{} {
    for (const Real& coefficient : values) coefficients[terms++] = coefficient;
  }

  Real& operator[](std::size_t i) { return coefficients[i]; }
  const Real& operator[](std::size_t i) const { return coefficients[i]; }
  Real* begin() { return coefficients.data(); }
  Real* end() { return coefficients.data() + terms; }
  const Real* begin() const { return coefficients.data(); }
  const Real* end() const { return coefficients.data() + terms; }
};

template <class Real>
Real value(const Polynomial<Real>& polynomial, const Real& s) {
  Real sum = 0;
  for (std::size_t i = polynomial.terms; i-- > 0;) sum = sum * s + polynomial[i];
  return sum;
}

/// Derivative with respect to s.
template <class Real>
Real slope(const Polynomial<Real>& polynomial, const Real& s) {
  Real sum = 0;
  for (std::size_t i = polynomial.terms; i-- > 1;) sum = sum * s + Real(i) * polynomial[i];
  return sum;
}

/// Sum of the sizes of all coefficients but the first: how far the polynomial gets from its start, at most.
template <class Real>
Real reach(const Polynomial<Real>& polynomial) {
  using std::abs;
  Real sum = 0;
  for (std::size_t i = 1; i < polynomial.terms; ++i) sum += abs(polynomial[i]);
  return sum;
}

/// The polynomial in s/ratio: what a step becomes that is `ratio` times as long.
template <class Real>
void rescale(Polynomial<Real>& polynomial, const Real& ratio) {
  Real power = 1;
  for (Real& coefficient : polynomial) {
    coefficient *= power;
    power *= ratio;
  }
}

template <class Real>
void add(const Polynomial<Real>& summand, Polynomial<Real>& sum) {
  while (sum.terms < summand.terms) sum[sum.terms++] = 0;
  for (std::size_t i = 0; i < summand.terms; ++i) sum[i] += summand[i];
}

/// The quartic through values at s = 0, 1/4, 1/2, 3/4 and 1 (Newton's forward differences).
template <class Real>
Polynomial<Real> quartic_through(std::array<Real, 5> values) {
  for (std::size_t order = 1; order < 5; ++order) {
    for (std::size_t i = 4; i >= order; --i) values[i] -= values[i - 1];
  }
  const auto& [f, d1, d2, d3, d4] = values;
  return {f, 4 * d1 - 2 * d2 + 4 * d3 / 3 - d4, 8 * d2 - 8 * d3 + 22 * d4 / 3, 32 * d3 / 3 - 16 * d4,
          32 * d4 / 3};
}

/// Coefficients in the Bernstein basis: their hull holds the polynomial on [0, 1].
template <class Real>
Polynomial<Real> bernstein(const Polynomial<Real>& polynomial) {
  const std::size_t terms = polynomial.terms;
  Polynomial<Real> result = polynomial;
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
template <class Real>
struct Halves {
  Polynomial<Real> left, right;
};

template <class Real>
Halves<Real> halve(Polynomial<Real> coefficients) {
  const std::size_t terms = coefficients.terms;
  Halves<Real> halves;
  halves.left.terms = halves.right.terms = terms;
  for (std::size_t level = 0; level < terms; ++level) {
    halves.left[level] = coefficients[0];
    halves.right[terms - 1 - level] = coefficients[terms - 1 - level];
    for (std::size_t i = 0; i + 1 < terms - level; ++i)
      coefficients[i] = (coefficients[i] + coefficients[i + 1]) / 2;
  }
  return halves;
}

/// The largest of `least` and all values on [0, 1], to rounding: the hull of a piece tells whether it may
/// hold more.
template <class Real>
Real maximum(const Polynomial<Real>& polynomial, Real least) {
  struct Search {
    Real& best;

    void operator()(const Polynomial<Real>& coefficients) const {
      best = std::max({best, coefficients[0], coefficients[coefficients.terms - 1]});
      const Real highest = *std::max_element(coefficients.begin(), coefficients.end());
      using std::abs;
      if (highest <= best + 4 * std::numeric_limits<Real>::epsilon() * abs(best)) return;
      const auto halves = halve(coefficients);
      (*this)(halves.left);
      (*this)(halves.right);
    }
  };
  if (polynomial.terms == 0 || polynomial[0] + reach(polynomial) <= least) return least;
  Search{least}(bernstein(polynomial));
  return least;
}

/// Where a polynomial that is positive on the left of its only sign change in (low, high) crosses zero:
/// Newton's method from s, kept inside the bracket by bisection, to rounding.
template <class Real>
Real bracketed_root(const Polynomial<Real>& polynomial, Real low, Real high, Real s) {
  for (int iteration = 0; iteration < 4 * std::numeric_limits<Real>::digits; ++iteration) {
    Real height = 0;
    Real steepness = 0;
    for (std::size_t i = polynomial.terms; i-- > 0;) {
      steepness = steepness * s + height;
      height = height * s + polynomial[i];
    }
    if (height == 0) return s;
    (height > 0 ? low : high) = s;
    const Real newton = s - height / steepness;
    const Real next = newton > low && newton < high ? newton : (low + high) / 2;
    using std::abs;
    if (abs(next - s) <= std::numeric_limits<Real>::epsilon() * s) return next;
    s = next;
  }
  return s;
}

/// True where a bound on the coefficients tells that the polynomial, up to the sign `side`, stays above zero
/// for all s in (0, 1].
template <class Real>
bool stays_positive(const Polynomial<Real>& polynomial, int side = 1) {
  using std::abs;
  std::size_t first = 0;
  while (first < polynomial.terms && polynomial[first] == 0) ++first;
  if (first == polynomial.terms) return false;
  Real rest = 0;
  for (std::size_t i = first + 1; i < polynomial.terms; ++i) rest += abs(polynomial[i]);
  const Real leading = side > 0 ? polynomial[first] : -polynomial[first];
  return leading > 0 && leading >= rest;
}

/// True where a bound on the coefficients tells that the polynomial falls for all s in [0, 1].
template <class Real>
bool falls(const Polynomial<Real>& polynomial) {
  using std::abs;
  Real rest = 0;
  for (std::size_t i = 2; i < polynomial.terms; ++i) rest += Real(i) * abs(polynomial[i]);
  return polynomial.terms > 1 && -polynomial[1] > rest;
}

/// The first zero of a falling polynomial's first three terms, or 1/2 where it is not in (0, 1).
template <class Real>
Real quadratic_root(const Polynomial<Real>& polynomial) {
  using std::sqrt;
  const Real square = polynomial.terms > 2 ? polynomial[2] : Real(0);
  const Real radicand = polynomial[1] * polynomial[1] - 4 * square * polynomial[0];
  const Real root = radicand > 0 ? 2 * polynomial[0] / (sqrt(radicand) - polynomial[1]) : Real(0);
  return root > 0 && root < Real(1) ? root : Real(1) / Real(2);
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

}  // namespace rockstack
