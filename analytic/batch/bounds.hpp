#pragma once

#include <limits>

#include "analytic/batch/pack.hpp"

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

/// Whether an opening angle or a margin neither crosses zero nor grazes it, as stays_clear(); a start at zero
/// is none of both.
template <class Real>
class Clearance {
 public:
  using Mask = typename Real::Mask;

  explicit Clearance(const Real& start)
      : start_(start),
        touching_(start == Real(0)),
        sum_(start),
        least_(select(touching_, Real(std::numeric_limits<double>::infinity()), start)) {}

  void add(const Real& coefficient) {
    reach_ += abs(coefficient);
    sum_ += coefficient;
    least_ = min(sum_, least_);
  }

  Mask holds() const {
    const Real size = select(touching_, Real(0), abs(start_) + reach_);
    return least_ > 16 * std::numeric_limits<double>::epsilon() * size;
  }

 private:
  Real start_;
  Mask touching_;
  Real sum_, least_;
  Real reach_ = 0;
};

/// How far a block leans in a step, and whether it only rises or only falls.
template <class Real>
class Leaning {
 public:
  using Mask = typename Real::Mask;

  explicit Leaning(const Real& start) { heights_.add(start); }

  /// The next coefficient: of order 1, 2, …
  void add(const Real& order, const Real& coefficient) {
    heights_.add(coefficient);
    slopes_.add(order * coefficient);
  }

  Real size() const { return max(heights_.greatest, -heights_.least); }
  Mask is_monotone() const { return (slopes_.least >= Real(0)) | (slopes_.greatest <= Real(0)); }

 private:
  PartialSums<Real> heights_, slopes_;
};

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

}  // namespace rockstack
