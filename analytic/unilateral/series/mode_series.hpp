#pragma once

#include "analytic/polynomials/polynomial.hpp"
#include "analytic/unilateral/contact/contact_model.hpp"

namespace rockstack {

/// A block's pose over a step, with the cosine and sine of its angle.
template <class Real>
struct BodySeries {
  Polynomial<Real> x, y, angle, cosine, sine;
  Polynomial<Real> turning;  ///< coefficients of the angle, each times its order, while series grow
};

/// Coefficient m of cosine and sine, but for what that of the angle will add: c' = −s θ', s' = c θ'.
template <class Real>
void begin_direction(BodySeries<Real>& body, std::size_t m) {
  Real cosine = 0;
  Real sine = 0;
  for (std::size_t j = 1; j < m; ++j) {
    cosine -= body.turning[j] * body.sine[m - j];
    sine += body.turning[j] * body.cosine[m - j];
  }
  put(body.cosine, m, cosine / Real(m));
  put(body.sine, m, sine / Real(m));
}

/// Coefficient m of the angle, and what it adds.
template <class Real>
void turn(BodySeries<Real>& body, std::size_t m, const Real& angle) {
  put(body.angle, m, angle);
  put(body.turning, m, Real(m) * angle);
  body.cosine[m] -= angle * body.sine[0];
  body.sine[m] += angle * body.cosine[0];
}

/// The ground stands still.
template <class Real>
BodySeries<Real> ground_series() {
  BodySeries<Real> ground;
  ground.x = ground.y = ground.angle = ground.sine = {Real(0)};
  ground.cosine = {Real(1)};
  return ground;
}

/// A point over a face along a step: its place along the face and above the middle of the face's body, in
/// that body's frame, m.
template <class Real>
struct FaceSeries {
  Polynomial<Real> along, above;
};

/// What an interface carries over a step, in units of the step's own; see ContactForce.
template <class Real>
struct ForceSeries {
  Polynomial<Real> normal, tangential, moment;
};

template <class Real>
struct PlaneCoefficient {
  Real x, y;
};

/// Coefficient n of a body vector in the frame of the ground.
template <class Real>
PlaneCoefficient<Real> turned(const BodySeries<Real>& body, const Point<Real>& vector, std::size_t n) {
  const Real cosine = coefficient(body.cosine, n);
  const Real sine = coefficient(body.sine, n);
  return {vector.x() * cosine + vector.y() * sine, vector.y() * cosine - vector.x() * sine};
}

/// Coefficient n of a plane vector (x, y) across and along a face, x sin θ + y cos θ and x cos θ − y sin θ
/// with θ the angle of its body. A force across and along it is turned back so: to (N sin θ + T cos θ, N cos
/// θ − T sin θ).
template <class Real>
struct FaceCoefficient {
  Real across, along;
};

template <class Real>
FaceCoefficient<Real> on_face(const Polynomial<Real>& x, const Polynomial<Real>& y,
                              const BodySeries<Real>& face, std::size_t n) {
  FaceCoefficient<Real> sum{0, 0};
  const std::size_t first = n < face.cosine.terms ? 0 : n + 1 - face.cosine.terms;
  for (std::size_t i = first, end = std::min(n + 1, x.terms); i < end; ++i) {
    const Real& cosine = face.cosine[n - i];
    const Real& sine = face.sine[n - i];
    sum.across += x[i] * sine + y[i] * cosine;
    sum.along += x[i] * cosine - y[i] * sine;
  }
  return sum;
}

/// Coefficient n of x y' − y x', of vectors (x, y) and (x', y') whose own coefficients end where they may.
template <class Real>
Real moment(const Polynomial<Real>& x, const Polynomial<Real>& y, const Polynomial<Real>& arm_x,
            const Polynomial<Real>& arm_y, std::size_t n) {
  if (arm_x.terms != arm_y.terms || x.terms != y.terms)
    return convolution(x, arm_y, n) - convolution(y, arm_x, n);
  Real sum = 0;
  const std::size_t first = n < arm_x.terms ? 0 : n + 1 - arm_x.terms;
  for (std::size_t i = first, end = std::min(n + 1, x.terms); i < end; ++i)
    sum += x[i] * arm_y[n - i] - y[i] * arm_x[n - i];
  return sum;
}

/// A point against a face while its series grow.
template <class Real>
struct GrowingPoint {
  CornerOnFace<Real> corner;
  Point<Real> body_arm;     ///< from the centre of mass of the point's body, in its frame, m
  Point<Real> face_centre;  ///< of mass of the face's body, from its middle, m
  const BodySeries<Real>* face;
  const BodySeries<Real>* body;
  Polynomial<Real> apart_x, apart_y;  ///< from the centre of mass of the face's body
  Polynomial<Real> arm_x, arm_y;
  FaceSeries<Real> place;             ///< from there too
  Polynomial<Real> force_x, force_y;  ///< on the point's body

  GrowingPoint(const ContactModel<Real>& stack, const CornerOnFace<Real>& point,
               const BodySeries<Real>* face_body, const BodySeries<Real>* point_body)
      : corner(point),
        body_arm(Point<Real>(point.x, point.y) - stack.centre(point.body)),
        face_centre(stack.centre(point.face)),
        face(face_body),
        body(point_body) {}

  /// Of the block above it, from 0.
  std::size_t interface() const { return static_cast<std::size_t>(std::max(corner.body, corner.face)); }

  /// Coefficient n of places, from those of bodies.
  void extend(std::size_t n) {
    extend_apart(n);
    const FaceCoefficient<Real> there = on_face(apart_x, apart_y, *face, n);
    put(place.along, n, there.along);
    put(place.above, n, there.across);
  }

  void extend_apart(std::size_t n) {
    const PlaneCoefficient<Real> arm = turned(*body, body_arm, n);
    put(arm_x, n, arm.x);
    put(arm_y, n, arm.y);
    put(apart_x, n, coefficient(body->x, n) - coefficient(face->x, n) + arm.x);
    put(apart_y, n, coefficient(body->y, n) - coefficient(face->y, n) + arm.y);
  }

  FaceSeries<Real> place_from_middle() const {
    FaceSeries<Real> result = place;
    result.along[0] += face_centre.x();
    result.above[0] += face_centre.y();
    return result;
  }

  /// Coefficient n on the ground's axes of a force across and along the face, as far as that is known.
  void extend_force(const ForceSeries<Real>& force, std::size_t n) {
    const FaceCoefficient<Real> turned_back = on_face(force.normal, force.tangential, *face, n);
    put(force_x, n, corner.upward * turned_back.across);
    put(force_y, n, corner.upward * turned_back.along);
  }

  /// Adds coefficient n of the force, and of its moment, on both bodies.
  void add_force(const ForceSeries<Real>& force, std::size_t n, FreeVector<Real>& result) const {
    if (corner.body >= 0) {
      result[Eigen::Index{3} * corner.body] += force_x[n];
      result[Eigen::Index{3} * corner.body + 1] += force_y[n];
      result[Eigen::Index{3} * corner.body + 2] += moment(force_x, force_y, arm_x, arm_y, n);
    }
    if (corner.face >= 0) {
      result[Eigen::Index{3} * corner.face] -= force_x[n];
      result[Eigen::Index{3} * corner.face + 1] -= force_y[n];
      result[Eigen::Index{3} * corner.face + 2] +=
          corner.upward * moment(force.normal, force.tangential, place.above, place.along, n);
    }
  }
};

/// The motion in one mode as Taylor series in s, the share of the step: 0 ≤ s ≤ 1.
///
/// Gaps that are held stay zero: each order of the accelerations and forces solves the same linear equations,
/// those of respond(), with what lower orders add to forces and gaps on their right side.
template <class Real>
struct ModeSeries {
  Real length = 0;      ///< s
  Real force_unit = 0;  ///< of the series of forces, N; that of moments is N·m
  ShortVector<BodySeries<Real>> bodies;
  ShortVector<ForceSeries<Real>> forces;
  ShortVector<FaceSeries<Real>> held;  ///< of held points; empty where apart

  Bodies<Real> at(const Real& s) const {
    Bodies<Real> result;
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
FaceSeries<Real> corner_series(const ContactModel<Real>& stack, const ModeSeries<Real>& series,
                               const CornerOnFace<Real>& corner) {
  const BodySeries<Real> ground = ground_series<Real>();
  const auto of = [&](int body) { return body < 0 ? &ground : &series.bodies[body]; };
  GrowingPoint<Real> point(stack, corner, of(corner.face), of(corner.body));
  for (std::size_t n = 0; n < series.bodies.front().x.terms; ++n) point.extend(n);
  return point.place_from_middle();
}

/// What an interface between blocks carries along and across the upper face, where `force` tells it of the
/// lower one.
template <class Real>
ForceSeries<Real> on_upper_face(const ModeSeries<Real>& series, int interface,
                                const ForceSeries<Real>& force) {
  const BodySeries<Real>& upper = series.bodies[interface];
  const BodySeries<Real>& lower = series.bodies[interface - 1];
  const Polynomial<Real> cosine = sum(product(upper.cosine, lower.cosine), product(upper.sine, lower.sine));
  const Polynomial<Real> sine =
      sum(product(upper.sine, lower.cosine), times(-1, product(upper.cosine, lower.sine)));
  return {sum(product(force.tangential, sine), product(force.normal, cosine)),
          sum(product(force.tangential, cosine), times(-1, product(force.normal, sine))), force.moment};
}

}  // namespace rockstack
