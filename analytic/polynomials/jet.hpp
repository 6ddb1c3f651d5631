#pragma once

#include "analytic/polynomials/polynomial.hpp"

namespace rockstack {

/// A function over a step as its Taylor series in s. Arithmetic on jets of as many terms gives the terms of
/// the result, so that equations of motion that are templates on their number type give series of rates.
struct Jet {
  Polynomial<double> series;

  double& operator[](std::size_t i) { return series[i]; }
  double operator[](std::size_t i) const { return series[i]; }
  std::size_t terms() const { return series.terms; }
};

/// A jet of so many terms whose coefficient n is of(n).
template <class Of>
Jet jet(std::size_t terms, const Of& of) {
  Jet result;
  result.series.terms = terms;
  for (std::size_t n = 0; n < terms; ++n) result[n] = of(n);
  return result;
}

inline Jet operator+(const Jet& a, const Jet& b) {
  return jet(a.terms(), [&](std::size_t n) { return a[n] + b[n]; });
}
inline Jet operator-(const Jet& a, const Jet& b) {
  return jet(a.terms(), [&](std::size_t n) { return a[n] - b[n]; });
}
inline Jet operator*(double factor, const Jet& a) {
  return jet(a.terms(), [&](std::size_t n) { return factor * a[n]; });
}
inline Jet operator-(const Jet& a) {
  return -1.0 * a;
}
inline Jet operator*(const Jet& a, const Jet& b) {
  return jet(a.terms(), [&](std::size_t n) { return convolution(a.series, b.series, n); });
}
/// From q b = a, order by order. Precondition: b does not start at zero.
inline Jet operator/(const Jet& a, const Jet& b) {
  Jet quotient;
  for (std::size_t n = 0; n < a.terms(); ++n) {
    double sum = a[n];
    for (std::size_t i = 0; i < n; ++i) sum -= quotient[i] * b[n - i];
    put(quotient.series, n, sum / b[0]);
  }
  return quotient;
}
/// From r² = a. Precondition: a starts above zero.
inline Jet sqrt(const Jet& a) {
  Jet root;
  for (std::size_t n = 0; n < a.terms(); ++n) {
    double sum = a[n];
    for (std::size_t i = 1; i < n; ++i) sum -= root[i] * root[n - i];
    put(root.series, n, n == 0 ? std::sqrt(sum) : sum / (2 * root[0]));
  }
  return root;
}

/// The part that does not change over the step.
inline double& constant_part(double& number) {
  return number;
}
inline double& constant_part(Jet& function) {
  return function[0];
}

template <class T>
struct SineCosine {
  T sine, cosine;
};
inline SineCosine<double> sine_cosine(double angle) {
  return {std::sin(angle), std::cos(angle)};
}
/// From sin' = cos · a' and cos' = −sin · a'.
inline SineCosine<Jet> sine_cosine(const Jet& a) {
  SineCosine<Jet> result;
  auto& [sine, cosine] = result;
  for (std::size_t n = 0; n < a.terms(); ++n) {
    double of_sine = 0, of_cosine = 0;
    for (std::size_t i = 1; i <= n; ++i) {
      of_sine += static_cast<double>(i) * a[i] * cosine[n - i];
      of_cosine -= static_cast<double>(i) * a[i] * sine[n - i];
    }
    const auto order = static_cast<double>(n);
    put(sine.series, n, n == 0 ? std::sin(a[0]) : of_sine / order);
    put(cosine.series, n, n == 0 ? std::cos(a[0]) : of_cosine / order);
  }
  return result;
}

}  // namespace rockstack
