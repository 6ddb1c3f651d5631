#pragma once

#include "analytic/mechanics/linkage.hpp"
#include "analytic/polynomials/polynomial.hpp"

namespace rockstack {

/// The series of a block in a chain over one step, order by order (chain_series.hpp).
template <class Real>
struct BlockSeries {
  using Point2 = PlaneVector<Real>;
  using Series = std::array<Real, max_terms<Real>>;
  using PlaneSeries = std::array<Point2, max_terms<Real>>;

  Series weighted;        ///< i times coefficient i of ψ
  PlaneSeries direction;  ///< cosine and sine of ψ
  PlaneSeries coupling;   ///< what they are multiplied by in the block's equation
  Series relative;        ///< φ''
  Series reaction;        ///< moment about the pivot, about the middle of a closed interface
  PlaneSeries force;      ///< on the block and all above

  /// The known parts of (c'')ₙ and (s'')ₙ.
  template <class Order>
  Point2 known_second_derivative(Order n) const {
    Point2 sum = weighted[1] * direction[n + 1];
    for (std::size_t j = 2; j < n + 2; ++j) sum = sum + weighted[j] * direction[n + 2 - j];
    return {-Real(n + 1) * sum.y, Real(n + 1) * sum.x};
  }

  /// Order n of Sₖ⊥ · (…) + Lₖ⊥ · (…), but for order n of the coupling: products of lower orders alone, of
  /// which the first `couplings` of the coupling are not zero.
  template <class Order>
  Real past_moment(Order n, std::size_t couplings) const {
    Point2 sum{Real(0), Real(0)};
    for (std::size_t i = couplings; i-- > 0;)
      sum = {sum.x + direction[n - i].x * coupling[i].x, sum.y + direction[n - i].y * coupling[i].y};
    return sum.x + sum.y;
  }
};

/// The derivative of a direction by its angle.
template <class Real>
PlaneVector<Real> ahead(const PlaneVector<Real>& direction) {
  return {-direction.y, direction.x};
}

/// What the cosine and sine of a block's angle are multiplied by for (x, y)⊥ · push, (x, y) in its frame.
template <class Real>
PlaneVector<Real> coupling_of(const PlaneVector<Real>& push, const Real& x, const Real& y) {
  return {y * push.x - x * push.y, -(x * push.x + y * push.y)};
}

}  // namespace rockstack
