#pragma once

#include "analytic/unilateral/springs/spring_rounding.hpp"
#include "analytic/unilateral/springs/spring_series.hpp"

namespace rockstack {

/// What happens to a point where a guard becomes negative.
enum class SpringChange : std::uint8_t {
  touch,         ///< it meets the face
  push_again,    ///< it has left a spring behind, and comes upon it
  part,          ///< it would have to pull
  leave,         ///< off the face, after it has left the spring behind
  slide,         ///< the slider starts to move
  grip,          ///< the slider stops
  pass,          ///< the corner of the other block comes to be farther inside its face
  fall,          ///< nothing is left of the face
  bed_depth,     ///< an end of a bed passes its surface
  bed_pressure,  ///< kδ + cδ̇ changes its sign there
  bed_crossing,  ///< zeros of depth and pressure pass each other
};

/// Something of a point that stays positive for as long as its law has one form.
template <class Real>
struct SpringGuard {
  Polynomial<Real> series;
  SpringChange change{};
  std::size_t point = 0;
  int way = 0;          ///< of `slide`: the way the slider will move; of a bed: the sign that ends
  std::size_t end = 0;  ///< of a bed
  bool below = false;   ///< of `touch`: a corner of the block below
  Polynomial<Real> within = {}, within_other = {};  ///< of `touch`: how far it is inside either end, m
  Polynomial<Real> other = {};                      ///< of `fall` from flight: what is negative beside it
};

/// The share of a step before a corner parts in which it does not come to slide.
template <class Real>
inline const Real parting_look_ahead = root_tolerance<Real>(1e-6);

/// Those of all points that end first, at s of a step.
template <class Real>
struct FirstSpringChange {
  Real s = 1;
  std::vector<SpringGuard<Real>> guards;

  /// Takes a guard into account, whose values round by `rounding`.
  void consider(SpringGuard<Real> guard, const Real& rounding) {
    const std::optional<Real> crossing = told_crossing(guard.series, rounding);
    if (crossing && guard.within.terms > 0 &&
        std::min(value(guard.within, *crossing), value(guard.within_other, *crossing)) < -rounding)
      return;
    if (crossing && guard.other.terms > 0 && value(guard.other, *crossing) >= 0) return;
    note(std::move(guard), crossing);
  }

  /// A fall from flight: beyond an end of the face, and no longer above it. m.
  void consider_fall(std::size_t point, const Polynomial<Real>& inside, const Polynomial<Real>& height) {
    for (const auto& [series, other] : {std::pair(inside, height), std::pair(height, inside)})
      consider({.series = series, .change = SpringChange::fall, .point = point, .other = other}, 0);
  }

  /// One that ends at `crossing`, if at all.
  void note(SpringGuard<Real> guard, const std::optional<Real>& crossing) {
    if (!crossing || *crossing > s) return;
    if (*crossing < s) guards.clear();
    s = *crossing;
    guards.push_back(std::move(guard));
  }
};

/// Gathers the guards of points along a step.
template <class Real>
class SpringGuards {
 public:
  SpringGuards(const ContactModel<Real>& stack, const SpringPoints<Real>& points, const Bodies<Real>& bodies,
               const ModeSeries<Real>& motion, const SpringSeries<Real>& series)
      : stack_(stack), points_(points), motion_(motion), series_(series), rounding_(stack, bodies) {}

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
    const SpringLaw<Real>& law = spring.law;
    if (!start.is_bed())
      found_.consider({spring.force.normal, SpringChange::part, i}, series_.unit() * rounding_.normal(law));
    if (law.friction == 0) return add_ends(spring, spring.slip);
    if (start.slide == 0) return add_sliding(spring);
    const Polynomial<Real> slider = combined(1, spring.slip, -1, spring.stretch);
    found_.consider({times(start.slide, derivative(slider)), SpringChange::grip, i},
                    motion_.length * rounding_.slider_rate(law));
    add_ends(spring, slider);
  }

  void add_sliding(const GrowingSpring<Real>& spring) {
    const SpringLaw<Real>& law = spring.law;
    const Polynomial<Real>& normal = spring.force.normal;
    // What parts has no force left along the face either: it does not slide just before.
    const std::optional<Real> parts = spring.start.is_bed() ? std::nullopt : first_crossing(normal);
    const Real until =
        parts && *parts > parting_look_ahead<Real> ? Real(*parts - parting_look_ahead<Real>) : Real(1);
    const Real rounding = series_.unit() * rounding_.strength(law);
    for (const int way : {-1, 1}) {
      SpringGuard<Real> guard{combined(law.friction, normal, way, spring.force.tangential),
                              SpringChange::slide, spring.index, way};
      std::optional<Real> crossing = told_crossing(guard.series, rounding);
      if (crossing && value(normal, *crossing) <= series_.unit() * rounding_.normal(law))
        crossing = first_crossing(line(rounding, 1, guard.series));
      if (crossing && *crossing <= until) found_.note(std::move(guard), crossing);
    }
  }

  /// The ends of the face that a slider may come to.
  void add_ends(const GrowingSpring<Real>& spring, const Polynomial<Real>& slider) {
    const CornerOnFace<Real>& corner = spring.point.corner;
    if (corner.face < 0) return;
    const Real end = stack_.half_width(corner.face);
    if (spring.start.is_bed()) {  // it holds as long as its middle is over the other face
      for (const int way : {-1, 1})
        found_.consider({line(end, way, slider), SpringChange::fall, spring.index}, 0);
      return;
    }
    const int outward = spring.start.side * corner.upward;
    const int way = spring.start.slide * outward;  // zero where there is no friction, and no way it must go
    SpringPoint<Real> other = spring.start;
    other.corner_below = !other.corner_below;
    if (way >= 0)
      found_.consider(
          {combined(1, inside_of(spring.start), -1, inside_of(other)), SpringChange::pass, spring.index},
          rounding_.place);
    if (way <= 0) found_.consider({line(end, outward, slider), SpringChange::fall, spring.index}, 0);
  }

  /// How far a point's corner is inside the end of its face, m.
  Polynomial<Real> inside_of(const SpringPoint<Real>& point) const {
    const CornerOnFace<Real> corner = corner_of(stack_, point);
    return line(stack_.half_width(corner.face), -point.side, corner_series(stack_, motion_, corner).along);
  }

  void add_bed(std::size_t i) {
    const SpringPoint<Real>& point = points_[i];
    const SpringLaw<Real>& law = stack_.springs[point.interface];
    std::array<Polynomial<Real>, 2> depth, pressure;
    for (std::size_t end = 0; end < 2; ++end) {
      const BedEnd& sign = point.bed.ends[end];
      const CornerOnFace<Real> corner = bed_corner(stack_, point, end);
      depth[end] = depth_of(corner, corner_series(stack_, motion_, corner));
      if (sign.at_face) depth[end][0] = 0;
      pressure[end] =
          combined(law.stiffness, depth[end], law.damping / motion_.length, derivative(depth[end]));
    }
    for (std::size_t end = 0; end < 2; ++end) {
      consider_sign(i, SpringChange::bed_depth, end, &BedEnd::deep, rounding_.place, depth);
      if (law.damping > 0)
        consider_sign(i, SpringChange::bed_pressure, end, &BedEnd::presses, rounding_.normal(law), pressure);
    }
    // Depth and pressure both have a zero inside, not the same one.
    const auto& [left, right] = point.bed.ends;
    if (law.damping > 0 && left.deep != right.deep && left.presses != right.presses)
      add_crossing(i, depth, pressure, rounding_.normal(law));
    const CornerOnFace<Real> middle = corner_of(stack_, point);
    if (middle.face < 0 || point.pushes()) return;
    const FaceSeries<Real> place = corner_series(stack_, motion_, middle);
    for (const int way : {-1, 1})
      found_.consider_fall(i, line(stack_.half_width(middle.face), way, place.along),
                           times(-1, depth_of(middle, place)));
  }

  /// A quantity of a bed that keeps its sign at an end up to the change. Where it has another sign at the
  /// other end, its zero between them must not be lost in what it is taken to round by.
  void consider_sign(std::size_t i, SpringChange change, std::size_t end, bool BedEnd::*above,
                     const Real& rounding, const std::array<Polynomial<Real>, 2>& quantity) {
    const auto& ends = points_[i].bed.ends;
    const int way = ends[end].*above ? 1 : -1;
    const bool alike = ends[end].*above == ends[1 - end].*above;
    found_.consider({times(way, quantity[end]), change, i, way, end},
                    alike ? rounding : std::min<Real>(rounding, abs(quantity[1 - end][0]) / 8));
  }

  void add_crossing(std::size_t i, const std::array<Polynomial<Real>, 2>& depth,
                    const std::array<Polynomial<Real>, 2>& pressure, const Real& rounding) {
    const int way = points_[i].bed.crossed ? 1 : -1;
    const Polynomial<Real> difference =
        combined(1, product(pressure[0], depth[1]), -1, product(pressure[1], depth[0]));
    found_.consider({times(way, difference), SpringChange::bed_crossing, i, way},
                    rounding_.place * (abs(pressure[0][0]) + abs(pressure[1][0])) +
                        rounding * (abs(depth[0][0]) + abs(depth[1][0])));
  }

  Polynomial<Real> depth_of(const CornerOnFace<Real>& corner, const FaceSeries<Real>& place) const {
    return line(stack_.half_height(corner.face), -corner.upward, place.above);
  }

  void add_left_behind(std::size_t i) {
    const SpringPoint<Real>& point = points_[i];
    const CornerOnFace<Real> corner = corner_of(stack_, point);
    const Polynomial<Real> depth = depth_of(corner, corner_series(stack_, motion_, corner));
    const SpringLaw<Real>& law = stack_.springs[point.interface];
    found_.consider({depth, SpringChange::leave, i}, rounding_.place);
    const Polynomial<Real> force =
        combined(law.stiffness, depth, law.damping / motion_.length, derivative(depth));
    found_.consider({times(-1, force), SpringChange::push_again, i}, rounding_.normal(law));
  }

  void add_touching(std::size_t i) {
    const SpringPoint<Real>& point = points_[i];
    for (const bool below : {false, true}) {
      if (below && point.interface == 0) continue;
      SpringPoint<Real> candidate = point;
      candidate.corner_below = below;
      const CornerOnFace<Real> corner = corner_of(stack_, candidate);
      const FaceSeries<Real> place = corner_series(stack_, motion_, corner);
      SpringGuard<Real> guard{times(-1, depth_of(corner, place)), SpringChange::touch, i, 0, 0, below};
      if (corner.face >= 0) {
        const Real end = stack_.half_width(corner.face);
        guard.within = line(end, -1, place.along);
        guard.within_other = line(end, 1, place.along);
        const auto pushes_here = [&](const SpringPoint<Real>& other) {
          return other.interface == point.interface && other.pushes();
        };
        if (!below && std::none_of(points_.begin(), points_.end(), pushes_here))
          found_.consider_fall(i, line(end, point.side, place.along), guard.series);
      }
      found_.consider(std::move(guard), rounding_.place);
    }
  }

  const ContactModel<Real>& stack_;
  const SpringPoints<Real>& points_;
  const ModeSeries<Real>& motion_;
  const SpringSeries<Real>& series_;
  SpringRounding<Real> rounding_;
  FirstSpringChange<Real> found_;
};

}  // namespace rockstack
