#pragma once

#include "analytic/unilateral/series/mode_series.hpp"
#include "analytic/unilateral/springs/spring_point.hpp"

namespace rockstack {

/// An end of a bed, where one of the two forces of its couple acts.
template <class Real>
struct BedEndSeries {
  GrowingPoint<Real> point;
  ForceSeries<Real> force;  ///< in the unit of the step's series
};

/// A point that pushes, along a step in s, its share.
template <class Real>
struct GrowingSpring {
  std::size_t index;  ///< of the point
  SpringPoint<Real> start;
  PointLaw<Real> law;
  GrowingPoint<Real> point;
  ForceSeries<Real> force = {};               ///< in the unit of the step's series
  Polynomial<Real> depth = {}, slip = {};     ///< m
  Polynomial<Real> stretch = {};              ///< of the tangential spring, m
  std::vector<BedEndSeries<Real>> ends = {};  ///< of a bed alone
  GrowingBed<Real> bed = {};
};

/// The forces of springs along a step: coefficient n of a force is that of kδ + cδ̇, which the places' up to
/// n + 1 make.
template <class Real>
class SpringSeries {
 public:
  /// Keeps references to all but `bodies`.
  SpringSeries(const ContactModel<Real>& stack, const SpringPoints<Real>& points, const Bodies<Real>& bodies)
      : stack_(stack), points_(points), bodies_(bodies) {}

  /// `body_of` tells a body's series.
  template <class BodyOf>
  void begin(const BodyOf& body_of, const Real& length) {
    length_ = length;
    unit_ = length * length;
    growing_.clear();
    growing_.reserve(points_.size());
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const SpringPoint<Real>& point = points_[i];
      if (!point.pushes()) continue;
      const CornerOnFace<Real> corner = corner_of(stack_, point);
      GrowingSpring<Real>& spring = growing_.emplace_back(GrowingSpring<Real>{
          i, point, law_of(stack_, point.interface),
          GrowingPoint<Real>(stack_, corner, body_of(corner.face), body_of(corner.body))});
      const ContactKinematics<Real> rows = kinematics_of(stack_, bodies_, corner);
      put(spring.depth, 0, point.at_face ? Real(0) : Real(-rows.gap));
      put(spring.slip, 0, rows.slip);
      put(spring.stretch, 0, rows.slip - point.slider);
      if (point.is_bed()) begin_bed(body_of, point, spring);
    }
    extend_places(0);
    extend_places(1);
  }

  void extend_places(std::size_t m) {
    for (GrowingSpring<Real>& spring : growing_) {
      spring.point.extend(m);
      if (m == 0) continue;
      const int sign = spring.point.corner.upward;
      put(spring.depth, m, -sign * spring.point.place[m].x());
      put(spring.slip, m, sign * spring.point.place[m].y());
    }
    for (GrowingSpring<Real>& spring : growing_)
      for (std::size_t end = 0; end < spring.ends.size(); ++end) {
        GrowingPoint<Real>& point = spring.ends[end].point;
        point.extend(m);
        if (m > 0) put(spring.bed.depth[end], m, -point.corner.upward * point.place[m].x());
      }
  }

  /// Coefficient n of forces, which it adds to those of interfaces.
  void extend_forces(std::size_t n, ShortVector<ForceSeries<Real>>& forces) {
    for (GrowingSpring<Real>& spring : growing_) {
      const PointLaw<Real>& law = spring.law;
      const Real normal = spring.start.is_bed() ? extend_bed(spring, n) : pressure(law, spring.depth, n);
      Real tangential = 0;
      if (spring.start.slide != 0) {
        tangential = -spring.start.slide * law.friction * normal;
        extend_sliding(spring, n, normal);
      } else {
        if (n > 0) put(spring.stretch, n, spring.slip[n]);
        if (law.friction > 0)
          tangential =
              -(law.tangential_stiffness * spring.stretch[n] + law.tangential_damping * rate(spring.slip, n));
      }
      put(spring.force.normal, n, unit_ * normal);
      put(spring.force.tangential, n, unit_ * tangential);
      spring.point.extend_force(spring.force, n + 1, n);
      ForceSeries<Real>& sum = forces[spring.start.interface];
      sum.normal[n] += unit_ * normal;
      sum.tangential[n] += unit_ * tangential;
    }
  }

  void add_forces(std::size_t n, ChainVector<Real>& result) const {
    for (const GrowingSpring<Real>& spring : growing_) {
      spring.point.add_force(spring.force, n + 1, n, result);
      if (!spring.start.is_bed()) continue;
      for (const BedEndSeries<Real>& end : spring.ends) end.point.add_force(end.force, n + 1, n, result);
    }
  }

  /// The largest coefficient m of a stretch that goes by a law of its own, m.
  Real size_of(std::size_t m) const {
    Real size = 0;
    for (const GrowingSpring<Real>& spring : growing_)
      if (spring.start.slide != 0) size = std::max<Real>(size, abs(coefficient(spring.stretch, m - 1)));
    return size;
  }

  /// Orders through which a force may be zero that then grows: that of a bed at whose surface a block starts
  /// at rest, as depth and the length that presses both go with the square of time.
  std::size_t silent_orders() const {
    const auto silent = [](const GrowingSpring<Real>& spring) {
      return spring.start.is_bed() && spring.force.normal[0] == 0;
    };
    return std::any_of(growing_.begin(), growing_.end(), silent) ? 4 : 0;
  }

  /// Makes the step `ratio` times as long.
  void rescale_by(const Real& ratio) {
    length_ *= ratio;
    for (GrowingSpring<Real>& spring : growing_)
      for (Polynomial<Real>* part :
           {&spring.depth, &spring.slip, &spring.stretch, &spring.force.normal, &spring.force.tangential,
            &spring.bed.depth[0], &spring.bed.depth[1], &spring.bed.normal, &spring.bed.couple})
        rescale(*part, ratio);
  }

  const std::vector<GrowingSpring<Real>>& springs() const { return growing_; }
  const Real& length() const { return length_; }
  const Real& unit() const { return unit_; }  ///< one over that of forces, s²

 private:
  template <class BodyOf>
  void begin_bed(const BodyOf& body_of, const SpringPoint<Real>& point, GrowingSpring<Real>& spring) const {
    spring.bed.stretch = stretch_of(point.bed);
    const auto corners = bed_corners(stack_, point);
    for (std::size_t end = 0; end < 2; ++end) {
      const CornerOnFace<Real>& corner = corners[end];
      spring.ends.push_back(
          {GrowingPoint<Real>(stack_, corner, body_of(corner.face), body_of(corner.body)), {}});
      const Real gap = kinematics_of(stack_, bodies_, corner).gap;
      put(spring.bed.depth[end], 0, point.bed.ends[end].at_face ? Real(0) : Real(-gap));
    }
  }

  /// Coefficient n of a bed's normal force.
  Real extend_bed(GrowingSpring<Real>& spring, std::size_t n) const {
    GrowingBed<Real>& bed = spring.bed;
    for (std::size_t end = 0; end < 2; ++end)
      put(bed.pressure[end], n, pressure(spring.law, bed.depth[end], n));
    bed.extend(n);
    for (std::size_t end = 0; end < 2; ++end) {
      BedEndSeries<Real>& series = spring.ends[end];
      put(series.force.normal, n, (end == 0 ? -unit_ : unit_) * bed.couple[n]);
      put(series.force.tangential, n, 0);
      series.point.extend_force(series.force, n + 1, n);
    }
    return bed.normal[n];
  }

  /// Coefficient n of kδ + cδ̇, N.
  Real pressure(const PointLaw<Real>& law, const Polynomial<Real>& depth, std::size_t n) const {
    return law.stiffness * depth[n] + law.damping * rate(depth, n);
  }

  /// Coefficient n of a rate, 1/s.
  Real rate(const Polynomial<Real>& series, std::size_t n) const {
    return Real(n + 1) * series[n + 1] / length_;
  }

  /// While the slider moves, k_t τ + c_t τ̇ = ±μN.
  void extend_sliding(GrowingSpring<Real>& spring, std::size_t n, const Real& normal) const {
    const PointLaw<Real>& law = spring.law;
    const Real limit = spring.start.slide * law.friction * normal;
    if (law.tangential_damping > 0) {
      put(spring.stretch, n + 1,
          length_ * (limit - law.tangential_stiffness * spring.stretch[n]) /
              (law.tangential_damping * Real(n + 1)));
    } else {
      put(spring.stretch, n, limit / law.tangential_stiffness);
    }
  }

  const ContactModel<Real>& stack_;
  const SpringPoints<Real>& points_;
  const Bodies<Real>& bodies_;
  Real length_ = 0;
  Real unit_ = 0;
  std::vector<GrowingSpring<Real>> growing_;
};

}  // namespace rockstack
