#pragma once

#include "analytic/batch/pack.hpp"
#include "analytic/polynomials/crossing.hpp"

namespace rockstack {

// What coefficients tell of a step, taken one after the other: the bounds of polynomial.hpp for a pack of
// lanes. Where they do not hold, the step is looked at lane by lane.

/// The least and the greatest of partial sums.
template <class Real>
struct PartialSums {
  Real sum = 0;
  Real least = std::numeric_limits<double>::infinity();
  Real greatest = -std::numeric_limits<double>::infinity();

  void add(const Real& term) {
    sum += term;
    least = min(sum, least);
    greatest = max(sum, greatest);
  }
};

/// Whether an opening angle or a margin neither crosses nor grazes zero but at its start, as stays_clear().
template <class Real>
class NoCrossingBound {
 public:
  using Mask = typename Real::Mask;

  explicit NoCrossingBound(const Real& start) : start_(start) {}

  void add(const Real& coefficient) {
    reach_ += abs(coefficient);
    sum_ += coefficient;
    least_ = min(sum_, least_);
  }

  /// Sum of the sizes of all coefficients.
  Real size() const { return abs(start_) + reach_; }

  Mask holds() const {
    const Real told = select(touching_, Real(0), size());
    return least_ > 16 * std::numeric_limits<double>::epsilon() * told;
  }

 private:
  Real start_;
  Mask touching_ = start_ == Real(0);
  Real sum_ = start_;
  Real least_ = select(touching_, Real(std::numeric_limits<double>::infinity()), start_);
  Real reach_ = 0;
};

/// Whether a polynomial only rises or only falls, as is_monotone().
template <class Real>
typename Real::Mask monotone(const Real* coefficients, std::size_t terms) {
  PartialSums<Real> slopes;
  for (std::size_t i = 1; i < terms; ++i) slopes.add(counting<double>[i] * coefficients[i]);
  return (slopes.least >= Real(0)) | (slopes.greatest <= Real(0));
}

/// Whether an interface demands no more than it has before: less friction, and no less of a normal force.
template <class Real>
class ForceBounds {
 public:
  using Mask = typename Real::Mask;

  /// From the coefficient of friction that is demanded so far.
  explicit ForceBounds(const Real& friction)
      : bounded_(friction <= Real(std::numeric_limits<double>::max())),
        ratio_(select(bounded_, friction, Real(0))) {}

  void add(const Real& normal, const Real& tangential) {
    const Real held = ratio_ * normal;
    pushes_.add(normal);
    right_.add(tangential - held);
    left_.add(-(tangential + held));
  }

  Mask hold(const Real& least_normal, const Real& rounding) const {
    return (pushes_.least >= least_normal - rounding) &
           (~bounded_ | (max(right_.greatest, left_.greatest) <= rounding * (1 + ratio_)));
  }

 private:
  Mask bounded_;
  Real ratio_;
  PartialSums<Real> pushes_, right_, left_;
};

// Where a step ends in the impact of one interface, the kernel follows it there, as first_crossing() would.

/// Where the polynomials of a pack cross zero, in those of its lanes in which one is told.
template <class Real>
struct Roots {
  Real s;
  typename Real::Mask found;
};

/// Gives bracketed_root() over (0, 1) from s, in the lanes asked for; not found where Newton's method creeps.
template <class Real>
Roots<Real> bracketed_roots(const Polynomial<Real>& polynomial, Real s, const typename Real::Mask& asked) {
  constexpr int most_points = 64;
  const Real rounding = std::numeric_limits<double>::epsilon();
  Real low = 0, high = 1;
  auto open = asked;
  for (int points = 0; any(open) && points < most_points; ++points) {
    const auto [height, slope] = tangent(polynomial, s);
    open = open & (height != Real(0));
    low = select(height > Real(0), s, low);
    high = select(height > Real(0), high, s);
    const Real newton = s - height / slope;
    const auto converged = abs(newton - s) <= rounding * s;
    const Real clamped = select(newton < low, low, select(high < newton, high, newton));
    const Real halfway = (low + high) / 2;
    const Real within = select((newton > low) & (newton < high), newton, halfway);
    const Real next = select(converged, clamped, within);
    const auto ends = converged | (abs(next - s) <= rounding * s);
    s = select(open, next, s);
    open = open & ~ends;
  }
  return {s, asked & ~open};
}

/// Whether the signs of Bernstein coefficients change once, to below zero, in lanes of so many terms each.
template <class Real>
typename Real::Mask crosses_once(Polynomial<Real> coefficients, const Real& terms) {
  Real binomial = 1;
  for (std::size_t i = 1; i < coefficients.terms; ++i) {
    binomial = binomial * (terms - counting<double>[i]) / counting<double>[i];
    coefficients[i] = coefficients[i] / binomial;
  }
  for (std::size_t level = 1; level < coefficients.terms; ++level)
    for (std::size_t i = coefficients.terms - 1; i >= level; --i) coefficients[i] += coefficients[i - 1];
  Real changes = 0, last = 0;
  for (std::size_t i = 0; i < coefficients.terms; ++i) {
    const Real& height = coefficients[i];
    const auto counts = (height != Real(0)) & (terms > counting<double>[i]);
    const Real sign = select(height > Real(0), Real(1), Real(-1));
    changes += select(counts & (last * sign < Real(0)), Real(1), Real(0));
    last = select(counts, sign, last);
  }
  return (changes == Real(1)) & (last < Real(0));
}

/// Gives first_crossing() of polynomials of so many terms each that start at or above zero, and fall from
/// there on or from a rise, or cross once; not found in the others.
template <class Real>
Roots<Real> first_crossings(const Polynomial<Real>& whole, const Real& terms,
                            const typename Real::Mask& asked) {
  const auto touching = whole[0] == Real(0);
  Polynomial<Real> polynomial;  // deflated where it starts at zero
  polynomial.terms = whole.terms;
  PartialSums<Real> heights, slopes;
  for (std::size_t i = 0; i < whole.terms; ++i) {
    const Real after = i + 1 < whole.terms ? whole[i + 1] : Real(0);
    polynomial[i] = select(touching, after, whole[i]);
    heights.add(polynomial[i]);
    if (i > 0) slopes.add(counting<double>[i] * polynomial[i]);
  }
  const auto may_cross = asked & (polynomial[0] > Real(0)) & (heights.least <= Real(0));
  const auto falls = slopes.greatest < Real(0);
  auto crosses = may_cross & falls & (value(polynomial, Real(1)) < Real(0));
  Real s = quadratic_root(polynomial);
  if (any(may_cross & ~falls)) {
    s = select(falls, s, Real(0.5));
    crosses =
        crosses | (may_cross & ~falls & crosses_once(polynomial, terms - select(touching, Real(1), Real(0))));
  }
  return bracketed_roots(polynomial, s, crosses);
}

/// The opening angle of the one interface that may close, lane by lane; and which it is, from 0.
template <class Real>
struct Closing {
  Polynomial<Real> angle;
  Real interface = 0;
  typename Real::Mask alone;  ///< whether there is one such interface, and no other
};

template <class Real, std::size_t N>
Closing<Real> closing(const std::array<Polynomial<Real>, N>& angles, const std::array<Real, N>& sides,
                      const std::array<typename Real::Mask, N>& may_close) {
  Closing<Real> result;
  result.angle.terms = angles[0].terms;
  Real count = 0;
  for (std::size_t k = 0; k < N; ++k) {
    count += select(may_close[k], Real(1), Real(0));
    result.interface = select(may_close[k], Real(static_cast<double>(k)), result.interface);
    for (std::size_t i = 0; i < result.angle.terms; ++i) {
      const Real coefficient = angles[k][i] * sides[k];
      result.angle[i] = k == 0 ? coefficient : select(may_close[k], coefficient, result.angle[i]);
    }
  }
  result.alone = count == Real(1);
  return result;
}

}  // namespace rockstack
