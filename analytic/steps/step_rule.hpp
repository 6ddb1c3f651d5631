#pragma once

#include "analytic/steps/chain_series.hpp"

namespace rockstack {

// What decides how long a Taylor step is, and of which order. One rule for a number and for a pack of
// numbers; of the latter, comparisons give a truth of each.

inline bool any(bool truth) {
  return truth;
}

template <class Real>
Real select(bool truth, const Real& one, const Real& other) {
  return truth ? one : other;
}

/// What a step starts from, and how long it is at most.
template <class Real, int N>
struct StepStart {
  PerBlock<Real, N> sides;     ///< signs of contacts
  PerBlock<Real, N> angles;    ///< φ, rad
  PerBlock<Real, N> advances;  ///< φ̇ times the length
  Real length;                 ///< s
  Real rate;                   ///< √(g/H), H the stack's height, 1/s

  void shorten(const Real& ratio) {
    length *= ratio;
    for (Real& advance : advances) advance *= ratio;
  }

  /// The share of a step by whose end the first interface that is open has come back, as far as accelerations
  /// at its start can tell; what lies behind that impact is not worth a series. Below a millionth of √(H/g)
  /// three orders do in any case, and a landing that rounding keeps away must not be foreseen for ever.
  /// `series` has its order 0.
  Real landing(const ChainSeries<Real, N>& series) const {
    using std::max;
    using std::min;
    using std::sqrt;
    const Real zero = 0;
    Real first = 1;
    for (std::size_t k = 0; k < series.size(); ++k) {
      const Real angle = sides[k] * angles[k];
      const Real speed = sides[k] * advances[k];
      const Real acceleration = sides[k] * series.relative(k, 0);
      const Real radicand = speed * speed - 2 * acceleration * angle;
      const auto returns = (radicand > zero) & ((speed < zero) | (acceleration < zero));
      if (!any(returns)) continue;
      const Real root = sqrt(radicand);
      const Real s = select(speed < zero, 2 * angle / (root - speed), (root + speed) / -acceleration);
      const Real end = s * (1 + s * length * rate) * Real(1.0625);
      first = select(returns & (s > zero), min(first, end), first);
    }
    return max(first, Real(1e-6) / (length * rate));
  }
};

/// Follows the orders of a series until what is left out is below a tolerance, relative to the step's motion.
/// What is left out is estimated by the last coefficients, and at least by a 64th of those before them, which
/// may be small by chance.
template <class Real>
class Convergence {
 public:
  explicit Convergence(const Real& tolerance) : tolerance_(tolerance) {}

  /// An order of the series: 0, 1, … Whether what is left out from there on is below the tolerance.
  template <int N>
  auto note_order(const StepStart<Real, N>& start, const ChainSeries<Real, N>& series, std::size_t order) {
    using std::abs;
    using std::max;
    Real last = 0;
    for (std::size_t k = 0; k < series.size(); ++k) {
      const Real size = abs(series.relative(k, order));
      last = max(last, size);
      if (order < 2)
        scale_ =
            max(scale_, abs(start.advances[k]) + size + abs(start.angles[k]) * start.length * start.rate);
    }
    rest_ = max(last, earlier_ / 64);
    allowed_ = tolerance_ * Real(static_cast<Number<Real>>(order + 1)) * scale_;
    earlier_ = last;
    return rest_ <= allowed_;
  }

  /// How many times the tolerance is left out.
  Real excess() const { return rest_ / allowed_; }

 private:
  Real tolerance_;
  Real scale_ = 0;
  Real earlier_ = std::numeric_limits<Number<Real>>::infinity();
  Real rest_ = 0;
  Real allowed_ = 0;
};

}  // namespace rockstack
