#pragma once

#include "analytic/polynomials/crossing.hpp"

namespace rockstack {

/// Where a polynomial is highest on [0, 1], and how high.
template <class Real>
struct Maximum {
  Real s;
  Real height;

  void raise(const Maximum& other) {
    if (other.height > height) *this = other;
  }
};

/// The maximum to within `slack`, or what rounding makes of it; nothing where the polynomial stays at or
/// below `least`. It is at an end or at the zero of a slope that falls; else it is searched for where
/// Bernstein coefficients may pass it.
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
  using std::abs;
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
