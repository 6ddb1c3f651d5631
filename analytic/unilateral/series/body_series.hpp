#pragma once

#include "analytic/unilateral/series/series_arithmetic.hpp"

namespace rockstack {

/// A block's placement over a step, with the cosine and sine of its angle.
template <class Real>
struct BodySeries {
  Polynomial<Real> x, y, angle, cosine, sine;
};

/// Coefficient m of cosine and sine from those of the angle: c' = −s θ', s' = c θ'.
template <class Real>
void extend_direction(BodySeries<Real>& body, std::size_t m) {
  Real cosine = 0;
  Real sine = 0;
  for (std::size_t j = 1; j <= m; ++j) {
    cosine -= Real(j) * body.angle[j] * body.sine[m - j];
    sine += Real(j) * body.angle[j] * body.cosine[m - j];
  }
  put(body.cosine, m, cosine / Real(m));
  put(body.sine, m, sine / Real(m));
}

/// The ground stands still.
template <class Real>
BodySeries<Real> ground_series() {
  BodySeries<Real> ground;
  ground.x = ground.y = ground.angle = ground.sine = {Real(0)};
  ground.cosine = {Real(1)};
  return ground;
}

}  // namespace rockstack
