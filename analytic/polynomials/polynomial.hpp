#pragma once

#include <initializer_list>
#include <type_traits>

#include "analytic/polynomials/numbers.hpp"

namespace rockstack {

/// c₀ + c₁s + … over one step, s in [0, 1], of numbers or vectors. Coefficients beyond `terms` have no value.
template <class Real, class Coefficient = Real>
struct Polynomial {
  std::size_t terms = 0;
  std::array<Coefficient, max_terms<Real>> coefficients;

  Polynomial() {}  // a step makes many, most of them to be filled
  Polynomial(const Polynomial& other) { *this = other; }
  Polynomial& operator=(const Polynomial& other) {
    terms = other.terms;
    std::copy_n(other.begin(), terms, begin());
    return *this;
  }
  Polynomial(std::initializer_list<Coefficient> values) {
    for (const Coefficient& coefficient : values) coefficients[terms++] = coefficient;
  }

  Coefficient& operator[](std::size_t i) { return coefficients[i]; }
  const Coefficient& operator[](std::size_t i) const { return coefficients[i]; }
  Coefficient* begin() { return coefficients.data(); }
  Coefficient* end() { return coefficients.data() + terms; }
  const Coefficient* begin() const { return coefficients.data(); }
  const Coefficient* end() const { return coefficients.data() + terms; }
};

template <class Real>
Real value(const Polynomial<Real>& polynomial, const Real& s) {
  Real sum = 0;
  for (std::size_t i = polynomial.terms; i-- > 0;) sum = sum * s + polynomial[i];
  return sum;
}

/// The value and the derivative with respect to s, each by a scheme of its own: from partial sums of the
/// value the derivative would take over their rounding, and energies would drift by a third more.
template <class Real>
struct Tangent {
  Real height, slope;
};

template <class Real, class Coefficient>
Tangent<Coefficient> tangent(const Polynomial<Real, Coefficient>& polynomial, const Real& s) {
  Tangent<Coefficient> result{zero<Coefficient>(), zero<Coefficient>()};
  Real order(polynomial.terms);
  for (std::size_t i = polynomial.terms; i-- > 1;) {
    order -= 1;
    result.slope = result.slope * s + order * polynomial[i];
    result.height = result.height * s + polynomial[i];
  }
  if (polynomial.terms > 0) result.height = result.height * s + polynomial[0];
  return result;
}

/// With respect to s.
template <class Real>
Polynomial<Real> derivative(const Polynomial<Real>& polynomial) {
  Polynomial<Real> result;
  for (std::size_t i = 1; i < polynomial.terms; ++i) result[result.terms++] = Real(i) * polynomial[i];
  return result;
}

/// Sum of the sizes of all coefficients but the first: how far the polynomial gets from its start, at most.
template <class Real>
Real reach(const Polynomial<Real>& polynomial) {
  Real sum = 0;
  for (std::size_t i = 1; i < polynomial.terms; ++i) sum += abs(polynomial[i]);
  return sum;
}

/// Bounds on a polynomial on [0, 1]: the least and the greatest of its partial sums c₀, c₀ + c₁, … It is a
/// mean of them with the weights 1 − s, s − s², …, sⁿ (Abel's summation). What is not a number stays so.
template <class Real>
struct Hull {
  Real least, greatest;

  void include(const Real& sum) {
    least = std::min(sum, least);
    greatest = std::max(sum, greatest);
  }
  Real size() const { return std::max(greatest, -least); }
};

/// The hull of at least one term, from order `first` on.
template <class Real>
Hull<Real> hull(const Polynomial<Real>& polynomial, std::size_t first = 0) {
  Real sum = polynomial[first];
  Hull<Real> result{sum, sum};
  for (std::size_t i = first + 1; i < polynomial.terms; ++i) result.include(sum += polynomial[i]);
  return result;
}

/// The hull of at least one term, without a start exactly at zero.
template <class Real>
Hull<Real> hull_beyond_zero(const Polynomial<Real>& polynomial) {
  std::size_t first = 0;
  while (first + 1 < polynomial.terms && polynomial[first] == 0) ++first;
  return hull(polynomial, first);
}

/// True where the coefficients tell that the slope keeps its sign on [0, 1].
template <class Real>
bool is_monotone(const Polynomial<Real>& polynomial) {
  if (polynomial.terms < 2) return true;
  Real sum = polynomial[1];
  Hull<Real> slopes{sum, sum};
  for (std::size_t i = 2; i < polynomial.terms; ++i) slopes.include(sum += Real(i) * polynomial[i]);
  return slopes.least >= 0 || slopes.greatest <= 0;
}

/// The polynomial in s/ratio: what a step becomes that is `ratio` times as long.
template <class Real, class Coefficient>
void rescale(Polynomial<Real, Coefficient>& polynomial, const Real& ratio) {
  Real power = 1;
  for (Coefficient& coefficient : polynomial) {
    coefficient *= power;
    power *= ratio;
  }
}

template <class Real>
void add(const Polynomial<Real>& summand, const Real& factor, Polynomial<Real>& sum) {
  while (sum.terms < summand.terms) sum[sum.terms++] = 0;
  for (std::size_t i = 0; i < summand.terms; ++i) sum[i] += factor * summand[i];
}

/// The quartic through values at s = 0, 1/4, 1/2, 3/4 and 1 (Newton's forward differences).
template <class Real>
Polynomial<Real> quartic_through(std::array<Real, 5> values) {
  for (std::size_t order = 1; order < 5; ++order)
    for (std::size_t i = 4; i >= order; --i) values[i] -= values[i - 1];
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
  for (std::size_t level = 1; level < terms; ++level)
    for (std::size_t i = terms - 1; i >= level; --i) result[i] += result[i - 1];
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

/// Coefficient n of a product, of coefficients that exist.
template <class Real>
Real convolution(const Polynomial<Real>& first, const Polynomial<Real>& second, std::size_t n) {
  Real sum = 0;
  const std::size_t low = n < second.terms ? 0 : n + 1 - second.terms;
  const std::size_t high = std::min(n + 1, first.terms);
  for (std::size_t i = low; i < high; ++i) sum += first[i] * second[n - i];
  return sum;
}

/// Sets coefficient n, those before it to zero where there are none.
template <class Real>
void put(Polynomial<Real>& series, std::size_t n, const std::type_identity_t<Real>& value) {
  while (series.terms <= n) series[series.terms++] = 0;
  series[n] = value;
}

/// Coefficient n, zero beyond the last.
template <class Real>
Real coefficient(const Polynomial<Real>& series, std::size_t n) {
  return n < series.terms ? series[n] : Real(0);
}

/// Without the terms that a polynomial has no room for.
template <class Real>
Polynomial<Real> product(const Polynomial<Real>& first, const Polynomial<Real>& second) {
  Polynomial<Real> result;
  const std::size_t terms =
      first.terms == 0 || second.terms == 0 ? 0 : std::min(first.terms + second.terms - 1, max_terms<Real>);
  for (std::size_t n = 0; n < terms; ++n) result[result.terms++] = convolution(first, second, n);
  return result;
}

/// Multiplies each coefficient.
template <class Real>
Polynomial<Real> times(const std::type_identity_t<Real>& factor, const Polynomial<Real>& series) {
  Polynomial<Real> result;
  result.terms = series.terms;
  for (std::size_t i = 0; i < series.terms; ++i) result[i] = factor * series[i];
  return result;
}

/// constant + factor · series.
template <class Real>
Polynomial<Real> line(const std::type_identity_t<Real>& constant, const std::type_identity_t<Real>& factor,
                      const Polynomial<Real>& series) {
  Polynomial<Real> result = times<Real>(factor, series);
  if (result.terms == 0) return {constant};
  result[0] += constant;
  return result;
}

/// factor · first + other · second.
template <class Real>
Polynomial<Real> combined(const std::type_identity_t<Real>& factor, const Polynomial<Real>& first,
                          const std::type_identity_t<Real>& other, const Polynomial<Real>& second) {
  Polynomial<Real> result = times<Real>(factor, first);
  add<Real>(second, other, result);
  return result;
}

}  // namespace rockstack
