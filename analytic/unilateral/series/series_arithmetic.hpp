#pragma once

#include <type_traits>

#include "analytic/polynomials/polynomial.hpp"

namespace rockstack {

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

/// Of each coefficient.
template <class Real>
Polynomial<Real> times(const std::type_identity_t<Real>& factor, Polynomial<Real> series) {
  for (Real& coefficient : series) coefficient *= factor;
  return series;
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

template <class Real>
Polynomial<Real> sum(Polynomial<Real> first, const Polynomial<Real>& second) {
  add(second, Real(1), first);
  return first;
}

}  // namespace rockstack
