#pragma once

#include "analytic/unilateral/contact/bodies.hpp"
#include "analytic/unilateral/series/body_series.hpp"

namespace rockstack {

/// A point over a face along a step: its place along the face and above the middle of the face's body, in
/// that body's frame, m.
template <class Real>
struct FaceSeries {
  Polynomial<Real> along, above;
};

/// What an interface carries over a step, in units of the step's own; see BasicContactForce.
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

  GrowingPoint(const std::vector<Block>& blocks, const CornerOnFace<Real>& point,
               const BodySeries<Real>* face_body, const BodySeries<Real>* point_body)
      : corner(point),
        body_arm(Point<Real>(point.x, point.y) - centre_of<Real>(blocks, point.body)),
        face_centre(centre_of<Real>(blocks, point.face)),
        face(face_body),
        body(point_body) {}

  /// Of the block above it, from 0.
  std::size_t interface() const { return static_cast<std::size_t>(std::max(corner.body, corner.face)); }

  void extend(std::size_t n) {
    const PlaneCoefficient<Real> arm = turned(*body, body_arm, n);
    put(arm_x, n, arm.x);
    put(arm_y, n, arm.y);
    put(apart_x, n, coefficient(body->x, n) - coefficient(face->x, n) + arm.x);
    put(apart_y, n, coefficient(body->y, n) - coefficient(face->y, n) + arm.y);
    put(place.along, n, convolution(apart_x, face->cosine, n) - convolution(apart_y, face->sine, n));
    put(place.above, n, convolution(apart_x, face->sine, n) + convolution(apart_y, face->cosine, n));
  }

  FaceSeries<Real> place_from_middle() const {
    FaceSeries<Real> result = place;
    result.along[0] += face_centre.x();
    result.above[0] += face_centre.y();
    return result;
  }

  void extend_force(const ForceSeries<Real>& force, std::size_t n) {
    const Real sign = corner.upward;
    put(force_x, n,
        sign * (convolution(force.normal, face->sine, n) + convolution(force.tangential, face->cosine, n)));
    put(force_y, n,
        sign * (convolution(force.normal, face->cosine, n) - convolution(force.tangential, face->sine, n)));
  }

  /// Adds coefficient n of the force, and of its moment, on both bodies.
  void add_force(const ForceSeries<Real>& force, std::size_t n, BasicFreeVector<Real>& result) const {
    if (corner.body >= 0) {
      result[Eigen::Index{3} * corner.body] += force_x[n];
      result[Eigen::Index{3} * corner.body + 1] += force_y[n];
      result[Eigen::Index{3} * corner.body + 2] +=
          convolution(force_x, arm_y, n) - convolution(force_y, arm_x, n);
    }
    if (corner.face >= 0) {
      result[Eigen::Index{3} * corner.face] -= force_x[n];
      result[Eigen::Index{3} * corner.face + 1] -= force_y[n];
      result[Eigen::Index{3} * corner.face + 2] +=
          corner.upward *
          (convolution(force.normal, place.along, n) - convolution(force.tangential, place.above, n));
    }
  }
};

}  // namespace rockstack
