#pragma once

#include <utility>

#include "analytic/polynomials/crossing.hpp"
#include "analytic/unilateral/contact/tolerance.hpp"
#include "analytic/unilateral/springs/spring_series.hpp"

namespace rockstack {

/// What happens to a point where a course becomes negative.
enum class SpringChange : std::uint8_t {
  touch,         ///< it meets the face
  push_again,    ///< it has left a spring behind, and comes upon it
  part,          ///< it would have to pull
  leave,         ///< off the face, after it has left the spring behind
  slide,         ///< the slider starts to move
  grip,          ///< the slider stops
  pass,          ///< the slider passes the end of the face
  fall,          ///< nothing is left of the face
  bed_depth,     ///< an end of a bed passes its surface
  bed_pressure,  ///< kδ + cδ̇ changes its sign there
  bed_crossing,  ///< zeros of depth and pressure pass each other
};

/// Something of a point that stays positive for as long as its law has one form.
template <class Real>
struct SpringCourse {
  Polynomial<Real> series;
  SpringChange change{};
  std::size_t point = 0;
  int way = 0;          ///< of `slide`: the way the slider will move; of a bed: the sign that ends
  std::size_t end = 0;  ///< of a bed
  bool below = false;   ///< of `touch`: a corner of the block below
  Polynomial<Real> within = {}, within_other = {};  ///< of `touch`: how far it is inside either end, m
};

/// The share of a step in which forces come to be told from rounding.
template <class Real>
inline const Real spring_moment = root_tolerance<Real>(1e-6);

/// The least that a series comes to up to `share` of a step, or less (Hull); zero where it stays above.
template <class Real>
Real least_below(const Polynomial<Real>& series, const Real& share) {
  Real least = 0;
  Real sum = 0;
  Real power = 1;
  for (const Real& coefficient : series) {
    sum += coefficient * power;
    least = std::min(least, sum);
    power *= share;
  }
  return least;
}

/// Those of all points that end first, at s of a step.
template <class Real>
struct FirstSpringChange {
  Real s = 1;
  std::vector<SpringCourse<Real>> courses;

  /// Takes a course into account. By the event that has just been, its first `zeros` coefficients are not
  /// below zero, however they round; and what is above zero a moment later has been so all the while. A
  /// course that ends after `until` is another's matter.
  void consider(SpringCourse<Real> course, std::size_t zeros = 0, const Real& until = 1) {
    for (std::size_t i = 0; i < zeros && i < course.series.terms; ++i)
      course.series[i] = std::max(course.series[i], Real(0));
    if (zeros > 0 && course.series.terms > 0 && value(course.series, spring_moment<Real>) >= 0)
      course.series[0] -= 2 * least_below(course.series, spring_moment<Real>);
    const std::optional<Real> crossing = first_crossing(course.series);
    if (!crossing || *crossing > std::min(s, until)) return;
    if (course.change == SpringChange::touch && course.within.terms > 0) {
      const Real slack = -tolerance<Real>(1e-12) * (course.within[0] + course.within_other[0]);
      if (value(course.within, *crossing) < slack || value(course.within_other, *crossing) < slack) return;
    }
    if (*crossing < s) courses.clear();
    s = *crossing;
    courses.push_back(std::move(course));
  }
};

/// Gathers the courses of points along a step.
template <class Real>
class SpringCourses {
 public:
  SpringCourses(const BasicFrictionStack<Real>& stack, const SpringPoints<Real>& points,
                const ModeSeries<Real>& motion, const SpringSeries<Real>& series)
      : stack_(stack), points_(points), motion_(motion), series_(series) {}

  FirstSpringChange<Real> first() && {
    for (const GrowingSpring<Real>& spring : series_.springs()) add_pushing(spring);
    for (std::size_t i = 0; i < points_.size(); ++i) {
      if (points_[i].is_bed()) {
        add_bed(i);
        continue;
      }
      if (points_[i].press == Press::left_behind) add_left_behind(i);
      if (points_[i].press == Press::off) add_touching(i);
    }
    return std::move(found_);
  }

 private:
  void add_pushing(const GrowingSpring<Real>& spring) {
    const std::size_t i = spring.index;
    const SpringPoint<Real>& start = spring.start;
    const PointLaw<Real>& law = spring.law;
    if (!start.is_bed())
      found_.consider({spring.force.normal, SpringChange::part, i},
                      start.at_no_force || start.at_face ? 1 : 0);
    if (law.friction == 0) return add_ends(spring, spring.slip);
    if (start.slide == 0) {
      // What parts has no force left along the face either: it does not slide a moment before.
      const std::optional<Real> parts = start.is_bed() ? std::nullopt : first_crossing(spring.force.normal);
      const Real until = parts && *parts > spring_moment<Real> ? Real(*parts - spring_moment<Real>) : Real(1);
      // Without a dashpot, a slider that has just stopped is at its strength as the slip comes to a halt.
      const std::size_t zeros = law.tangential_damping > 0 ? 1 : 2;
      for (const int way : {-1, 1}) {
        SpringCourse<Real> course{
            sum(times(law.friction, spring.force.normal), times(way, spring.force.tangential)),
            SpringChange::slide, i, way};
        const bool at_limit = way * spring.force.tangential[0] < 0 || course.series[0] <= 0;
        found_.consider(std::move(course), start.at_grip && at_limit ? zeros : 0, until);
      }
      return;
    }
    const Polynomial<Real> slider = sum(spring.slip, times(-1, spring.stretch));
    found_.consider({times(start.slide, derivative(slider)), SpringChange::grip, i},
                    start.at_grip && law.tangential_damping > 0 ? 1 : 0);
    add_ends(spring, slider);
  }

  /// The ends of the face that a slider may come to.
  void add_ends(const GrowingSpring<Real>& spring, const Polynomial<Real>& slider) {
    const CornerOnFace<Real>& corner = spring.point.corner;
    if (corner.face < 0) return;
    if (spring.start.is_bed()) return add_bed_falling(spring.index, corner, slider);
    const Real end = half_width_of<Real>(stack_.blocks, corner.face);
    const int outward = spring.start.side * corner.upward;
    const int way = spring.start.slide * outward;  // zero where there is no friction, and no way it must go
    if (way >= 0)
      found_.consider({line(end, -outward, slider), SpringChange::pass, spring.index},
                      spring.start.at_end ? 1 : 0);
    if (way <= 0) found_.consider({line(end, outward, slider), SpringChange::fall, spring.index});
  }

  /// A bed holds as long as its middle is over the other face.
  void add_bed_falling(std::size_t i, const CornerOnFace<Real>& middle, const Polynomial<Real>& along) {
    const Real end = half_width_of<Real>(stack_.blocks, middle.face);
    for (const int way : {-1, 1}) found_.consider({line(end, way, along), SpringChange::fall, i});
  }

  void add_bed(std::size_t i) {
    const SpringPoint<Real>& point = points_[i];
    const PointLaw<Real> law = law_of(stack_, point.interface);
    const auto corners = bed_corners(stack_.blocks, point);
    std::array<Polynomial<Real>, 2> depth;
    std::array<Polynomial<Real>, 2> pressure;
    for (std::size_t end = 0; end < 2; ++end) {
      const BedEnd& sign = point.bed.ends[end];
      const CornerOnFace<Real>& corner = corners[end];
      depth[end] = depth_of(corner, corner_series(stack_.blocks, motion_, corner));
      if (sign.at_face) depth[end][0] = 0;
      pressure[end] =
          sum(times(law.stiffness, depth[end]), times(law.damping / motion_.length, derivative(depth[end])));
      consider_sign(i, SpringChange::bed_depth, end, sign.deep, sign.at_face, depth[end]);
      if (law.damping > 0)
        consider_sign(i, SpringChange::bed_pressure, end, sign.presses, sign.at_no_force, pressure[end]);
    }
    if (law.damping > 0 && has_crossing(point.bed))
      consider_sign(i, SpringChange::bed_crossing, 0, point.bed.crossed, point.bed.at_crossing,
                    sum(product(pressure[0], depth[1]), times(-1, product(pressure[1], depth[0]))));
    const CornerOnFace<Real> middle = corner_of(stack_.blocks, point);
    if (middle.face >= 0 && !point.pushes())
      add_bed_falling(i, middle, corner_series(stack_.blocks, motion_, middle).along);
  }

  /// A quantity of a bed that keeps its sign up to the change.
  void consider_sign(std::size_t i, SpringChange change, std::size_t end, bool above, bool zero,
                     const Polynomial<Real>& quantity) {
    const int way = above ? 1 : -1;
    SpringCourse<Real> course{times(way, quantity), change, i, way};
    course.end = end;
    found_.consider(std::move(course), zero ? 1 : 0);
  }

  Polynomial<Real> depth_of(const CornerOnFace<Real>& corner, const FaceSeries<Real>& place) const {
    return line(half_height_of<Real>(stack_.blocks, corner.face), -corner.upward, place.above);
  }

  void add_left_behind(std::size_t i) {
    const SpringPoint<Real>& point = points_[i];
    const CornerOnFace<Real> corner = corner_of(stack_.blocks, point);
    const Polynomial<Real> depth = depth_of(corner, corner_series(stack_.blocks, motion_, corner));
    const PointLaw<Real> law = law_of(stack_, point.interface);
    found_.consider({depth, SpringChange::leave, i});
    const Polynomial<Real> force =
        sum(times(law.stiffness, depth), times(law.damping / motion_.length, derivative(depth)));
    found_.consider({times(-1, force), SpringChange::push_again, i}, point.at_no_force ? 1 : 0);
  }

  void add_touching(std::size_t i) {
    const SpringPoint<Real>& point = points_[i];
    for (const bool below : {false, true}) {
      if (below && point.interface == 0) continue;
      SpringPoint<Real> candidate = point;
      candidate.corner_below = below;
      const CornerOnFace<Real> corner = corner_of(stack_.blocks, candidate);
      const FaceSeries<Real> place = corner_series(stack_.blocks, motion_, corner);
      SpringCourse<Real> course{times(-1, depth_of(corner, place)), SpringChange::touch, i};
      course.below = below;
      if (corner.face >= 0) {
        const Real end = half_width_of<Real>(stack_.blocks, corner.face);
        course.within = line(end, -1, place.along);
        course.within_other = line(end, 1, place.along);
        // A block that is wholly beyond an end of the face below falls.
        if (!below && lies_open(point.interface))
          found_.consider({line(end, point.side, place.along), SpringChange::fall, i});
      }
      found_.consider(std::move(course), point.at_face ? 1 : 0);
    }
  }

  bool lies_open(int interface) const {
    return std::none_of(points_.begin(), points_.end(), [&](const SpringPoint<Real>& point) {
      return point.interface == interface && point.pushes();
    });
  }

  const BasicFrictionStack<Real>& stack_;
  const SpringPoints<Real>& points_;
  const ModeSeries<Real>& motion_;
  const SpringSeries<Real>& series_;
  FirstSpringChange<Real> found_;
};

}  // namespace rockstack
