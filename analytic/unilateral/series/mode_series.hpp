#pragma once

#include "analytic/unilateral/series/point_series.hpp"

namespace rockstack {

/// The motion in one mode as Taylor series in s, the share of the step: 0 ≤ s ≤ 1.
///
/// Gaps that are held stay zero: each order of the accelerations and forces solves the same linear equations,
/// those of respond(), with what lower orders add to forces and gaps on their right side.
template <class Real>
struct ModeSeries {
  Real length = 0;      ///< s
  Real force_unit = 0;  ///< of the series of forces, N; that of moments is N·m
  std::vector<BodySeries<Real>> bodies;
  std::vector<ForceSeries<Real>> forces;
  std::vector<FaceSeries<Real>> held;  ///< of held points; empty where apart

  BasicBodies<Real> at(const Real& s) const {
    BasicBodies<Real> result;
    for (const BodySeries<Real>& body : bodies) {
      const auto x = tangent(body.x, s);
      const auto y = tangent(body.y, s);
      const auto angle = tangent(body.angle, s);
      result.at.push_back({x.height, y.height, angle.height});
      result.rate.push_back({x.slope / length, y.slope / length, angle.slope / length});
    }
    return result;
  }
};

/// Any corner over any face along a step.
template <class Real>
FaceSeries<Real> corner_series(const std::vector<Block>& blocks, const ModeSeries<Real>& series,
                               const CornerOnFace<Real>& corner) {
  const BodySeries<Real> ground = ground_series<Real>();
  const auto of = [&](int body) {
    return body < 0 ? &ground : &series.bodies[static_cast<std::size_t>(body)];
  };
  GrowingPoint<Real> point(blocks, corner, of(corner.face), of(corner.body));
  for (std::size_t n = 0; n < series.bodies.front().x.terms; ++n) point.extend(n);
  return point.place_from_middle();
}

/// What an interface between blocks carries along and across the upper face, where `force` tells it of the
/// lower one.
template <class Real>
ForceSeries<Real> on_upper_face(const ModeSeries<Real>& series, int interface,
                                const ForceSeries<Real>& force) {
  const BodySeries<Real>& upper = series.bodies[static_cast<std::size_t>(interface)];
  const BodySeries<Real>& lower = series.bodies[static_cast<std::size_t>(interface - 1)];
  const Polynomial<Real> cosine = sum(product(upper.cosine, lower.cosine), product(upper.sine, lower.sine));
  const Polynomial<Real> sine =
      sum(product(upper.sine, lower.cosine), times(-1, product(upper.cosine, lower.sine)));
  return {sum(product(force.tangential, sine), product(force.normal, cosine)),
          sum(product(force.tangential, cosine), times(-1, product(force.normal, sine))), force.moment};
}

}  // namespace rockstack
