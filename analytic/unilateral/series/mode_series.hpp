#pragma once

#include "analytic/polynomials/polynomial.hpp"
#include "analytic/unilateral/contact/contact_model.hpp"

namespace rockstack {

/// Plane vectors over a step, or pairs of what is across and along a face.
template <class Real>
using PlaneSeries = Polynomial<Real, Point<Real>>;

/// A block's pose over a step, its axes on the ground's: along, (cos θ, −sin θ), and up, (sin θ, cos θ).
template <class Real>
struct BodySeries {
  PlaneSeries<Real> centre;
  Polynomial<Real> angle;
  PlaneSeries<Real> along, up;
  Polynomial<Real> turning;  ///< coefficients of the angle, each times its order, while series grow
};

/// One of the two numbers of each coefficient.
template <class Real>
Polynomial<Real> component(const PlaneSeries<Real>& series, int which, std::size_t terms) {
  Polynomial<Real> result;
  for (; result.terms < terms; ++result.terms) result[result.terms] = series[result.terms][which];
  return result;
}

template <class Real>
void set_axes(BodySeries<Real>& body, std::size_t m, const Point<Real>& up) {
  body.up[m] = up;
  body.along[m] = quarter_turned(up);
}

/// Coefficient m of the axes, but for what that of the angle will add: up' = along θ', along' = −up θ'.
template <class Real>
void begin_axes(BodySeries<Real>& body, std::size_t m) {
  Point<Real> sum = Point<Real>::Zero();
  for (std::size_t j = 1; j < m; ++j) sum += body.turning[j] * body.along[m - j];
  set_axes<Real>(body, m, sum / Real(static_cast<int>(m)));
}

/// Coefficient m of the angle, and what it adds.
template <class Real>
void turn(BodySeries<Real>& body, std::size_t m, const Real& angle) {
  body.angle[m] = angle;
  body.turning[m] = Real(static_cast<int>(m)) * angle;
  set_axes<Real>(body, m, body.up[m] + angle * body.along[0]);
}

/// The ground stands still.
template <class Real>
inline const BodySeries<Real> ground_series = [] {
  BodySeries<Real> ground;
  for (std::size_t m = 0; m < max_terms<Real>; ++m) {
    ground.centre[m] = Point<Real>::Zero();
    ground.angle[m] = 0;
    set_axes<Real>(ground, m, {Real(0), Real(m == 0 ? 1 : 0)});
  }
  ground.up.terms = ground.along.terms = 1;
  return ground;
}();

/// A point over a face along a step: along the face and above the middle of its body, in that one's frame, m.
template <class Real>
struct FaceSeries {
  Polynomial<Real> along, above;
};

/// What an interface carries over a step, in units of the step's own; see ContactForce.
template <class Real>
struct ForceSeries {
  Polynomial<Real> normal, tangential, moment;

  Point<Real> operator[](std::size_t i) const { return {normal[i], tangential[i]}; }
};

/// Three numbers, x, y and angle, of the ground, which are zero, and of each block.
template <class Real>
using ChainVector = std::array<Real, std::size_t{3} * (max_blocks + 1)>;

/// Coefficient n of a body vector in the frame of the ground.
template <class Real>
Point<Real> turned(const BodySeries<Real>& body, const Point<Real>& vector, std::size_t n) {
  return vector.x() * body.along[n] + vector.y() * body.up[n];
}

/// Coefficient n of a plane vector (x, y) across and along a face, x sin θ + y cos θ and x cos θ − y sin θ
/// with θ the angle of its body. A force across and along it is turned back by the same: to (N sin θ + T cos
/// θ, N cos θ − T sin θ). The vector has so many terms.
template <class Real, class Series>
Point<Real> on_face(const Series& vector, std::size_t terms, const BodySeries<Real>& face, std::size_t n) {
  Point<Real> sum = Point<Real>::Zero();
  const std::size_t first = n < face.up.terms ? 0 : n + 1 - face.up.terms;
  for (std::size_t i = first, end = std::min(n + 1, terms); i < end; ++i) {
    auto&& at = vector[i];
    sum += at.x() * face.up[n - i] + at.y() * face.along[n - i];
  }
  return sum;
}

/// Coefficient n of x y' − y x', of vectors (x, y) and (x', y') of which the first has so many terms.
template <class Real, class Series>
Real moment(const Series& force, std::size_t terms, const PlaneSeries<Real>& arm, std::size_t n) {
  Real sum = 0;
  for (std::size_t i = 0, end = std::min(n + 1, terms); i < end; ++i) {
    auto&& at = force[i];
    sum += at.x() * arm[n - i].y() - at.y() * arm[n - i].x();
  }
  return sum;
}

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
  ShortVector<Polynomial<Real>> along;         ///< the faces: of held points, m
  std::vector<Polynomial<Real>> lengths = {};  ///< of restraints, m

  const BodySeries<Real>* body(int k) const { return k < 0 ? &ground_series<Real> : &bodies[k]; }

  Bodies<Real> at(const Real& s) const {
    Bodies<Real> result{Poses<Real>(bodies.size()), Poses<Real>(bodies.size())};
    for (std::size_t k = 0; k < bodies.size(); ++k) {
      const auto centre = tangent(bodies[k].centre, s);
      const auto angle = tangent(bodies[k].angle, s);
      result.pose[k] = {centre.height.x(), centre.height.y(), angle.height};
      result.velocity[k] = {centre.slope.x() / length, centre.slope.y() / length, angle.slope / length};
    }
    return result;
  }
};

/// A point against a face while its series grow.
template <class Real>
struct GrowingPoint {
  CornerOnFace<Real> corner;
  Point<Real> body_arm;     ///< from the centre of mass of the point's body, in its frame, m
  Point<Real> face_centre;  ///< of mass of the face's body, from its middle, m
  const BodySeries<Real>* face;
  const BodySeries<Real>* body;
  PlaneSeries<Real> apart;  ///< from the centre of mass of the face's body
  PlaneSeries<Real> arm;
  PlaneSeries<Real> place;  ///< as apart, above and along the face
  PlaneSeries<Real> force;  ///< on the point's body

  GrowingPoint() {}  // of a list that has room for it
  GrowingPoint(const ContactModel<Real>& stack, const ModeSeries<Real>& series,
               const CornerOnFace<Real>& point)
      : corner(point),
        body_arm(Point<Real>(point.x, point.y) - stack.centre(point.body)),
        face_centre(stack.centre(point.face)),
        face(series.body(point.face)),
        body(series.body(point.body)) {}

  /// Coefficient n of places, from those of bodies.
  void extend(std::size_t n) {
    extend_apart(n);
    place[n] = on_face(apart, max_terms<Real>, *face, n);
  }

  void extend_apart(std::size_t n) {
    arm[n] = turned(*body, body_arm, n);
    apart[n] = body->centre[n] - face->centre[n] + arm[n];
  }

  /// Place to `terms` terms.
  FaceSeries<Real> place_from_middle(std::size_t terms) const {
    FaceSeries<Real> result{component(place, 1, terms), component(place, 0, terms)};
    result.along[0] += face_centre.x();
    result.above[0] += face_centre.y();
    return result;
  }

  /// Coefficient n on the ground's axes of a force across and along the face; so many terms are known.
  void extend_force(const ForceSeries<Real>& carried, std::size_t terms, std::size_t n) {
    force[n] = Real(corner.upward) * on_face(carried, terms, *face, n);
  }

  /// Adds coefficient n of the force, and of its moment, on both bodies.
  void add_force(const ForceSeries<Real>& carried, std::size_t terms, std::size_t n,
                 ChainVector<Real>& forces) const {
    if (corner.body >= 0) {
      Real* own = &forces[3 * static_cast<std::size_t>(corner.body + 1)];
      own[0] += force[n].x();
      own[1] += force[n].y();
      own[2] += moment(force, n + 1, arm, n);
    }
    if (corner.face >= 0) {
      Real* other = &forces[3 * static_cast<std::size_t>(corner.face + 1)];
      other[0] -= force[n].x();
      other[1] -= force[n].y();
      other[2] += corner.upward * moment(carried, terms, place, n);
    }
  }
};

/// Any corner over any face along a step.
template <class Real>
FaceSeries<Real> corner_series(const ContactModel<Real>& stack, const ModeSeries<Real>& series,
                               const CornerOnFace<Real>& corner) {
  GrowingPoint<Real> point(stack, series, corner);
  const std::size_t terms = series.bodies.front().centre.terms;
  for (std::size_t n = 0; n < terms; ++n) point.extend(n);
  return point.place_from_middle(terms);
}

/// What an interface between blocks carries along and across the upper face; `force` is of the lower one.
template <class Real>
ForceSeries<Real> on_upper_face(const ModeSeries<Real>& series, int interface,
                                const ForceSeries<Real>& force) {
  const BodySeries<Real>& upper = series.bodies[interface];
  const BodySeries<Real>& lower = series.bodies[interface - 1];
  const auto sine_of = [](const BodySeries<Real>& body) { return component(body.up, 0, body.up.terms); };
  const auto cosine_of = [](const BodySeries<Real>& body) { return component(body.up, 1, body.up.terms); };
  const Polynomial<Real> cosine =
      combined(1, product(cosine_of(upper), cosine_of(lower)), 1, product(sine_of(upper), sine_of(lower)));
  const Polynomial<Real> sine =
      combined(1, product(sine_of(upper), cosine_of(lower)), -1, product(cosine_of(upper), sine_of(lower)));
  return {combined(1, product(force.tangential, sine), 1, product(force.normal, cosine)),
          combined(1, product(force.tangential, cosine), -1, product(force.normal, sine)), force.moment};
}

}  // namespace rockstack
