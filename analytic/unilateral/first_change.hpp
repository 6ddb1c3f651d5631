#pragma once

#include <optional>
#include <utility>

#include "analytic/polynomials/crossing.hpp"
#include "analytic/unilateral/fresh_joints.hpp"

namespace rockstack {

/// Angles below it are flat, rad.
template <class Real>
Real flat_angle() {
  return tolerance<Real>(1e-14);
}

/// The first changes of a step, at s of its length.
template <class Real>
struct FirstChange {
  Real s = 1;
  std::vector<Course<Real>> courses;  ///< those that end there
};

/// p(first + (1 − first) u) as a polynomial in u.
template <class Real>
Polynomial<Real> from(const Polynomial<Real>& polynomial, const Real& first) {
  Polynomial<Real> shifted = polynomial;
  for (std::size_t i = 0; i + 1 < shifted.terms; ++i) {
    for (std::size_t j = shifted.terms - 1; j > i; --j) shifted[j - 1] += first * shifted[j];
  }
  rescale<Real>(shifted, 1 - first);
  return shifted;
}

/// Whether a corner is on its face, to rounding, and not about to pass its end.
template <class Real>
bool is_inside(const Polynomial<Real>& within, const Real& s, const Real& rounding) {
  const auto [distance, slope] = tangent(within, s);
  return distance > rounding || (distance >= -rounding && slope >= 0);
}

/// Whether a corner that meets a face is the one that the block above leans to, and on the face.
template <class Real>
bool lands(const ModeSeries<Real>& series, const Course<Real>& course, const Real& s) {
  const auto k = static_cast<std::size_t>(course.interface);
  const Real angle =
      value(series.bodies[k].angle, s) - (k > 0 ? value(series.bodies[k - 1].angle, s) : Real(0));
  if (course.side * angle < -flat_angle<Real>()) return false;
  return course.within.terms == 0 ||
         (is_inside(course.within, s, course.rounding) && is_inside(course.within_other, s, course.rounding));
}

/// The changes that end a step. Courses that start at zero by a decision at `time` are looked at from
/// `skipped` of the step on.
template <class Real>
FirstChange<Real> first_change(std::vector<Course<Real>> courses, const ModeSeries<Real>& series,
                               const FreshJoints<Real>& fresh, const Real& time, bool decided,
                               const Real& skipped) {
  FirstChange<Real> found;
  for (Course<Real>& course : courses) {
    Polynomial<Real>& whole = course.series;
    const bool starts = fresh.starts(course, time, decided);
    Real first = starts ? skipped : Real(0);
    const bool lower = course.change == Change::landing && whole[0] < -course.rounding;
    if (lower) {
      // Beside its face a corner may be lower, and come up before it lands.
      const std::optional<Real> above = first_crossing(times(-1, whole));
      if (!above) continue;
      first = *above;
    } else if (course.change == Change::landing && whole[0] <= (starts ? course.rounding : Real(0))) {
      // A corner that has not just parted may come down from within rounding above the face.
      whole[0] = 0;
    }
    Polynomial<Real> rest = first > 0 ? from(whole, first) : whole;
    if (lower) rest[0] = 0;
    std::optional<Real> crossing = first_crossing(rest);
    if (crossing) *crossing = first + (1 - first) * *crossing;
    if (!crossing || *crossing > found.s) continue;
    if (course.change == Change::landing && !lands(series, course, *crossing)) continue;
    if (*crossing < found.s) found = {*crossing, {}};
    found.courses.push_back(std::move(course));
  }
  return found;
}

}  // namespace rockstack
