#pragma once

#include "analytic/scene/history.hpp"
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
  SpringLaw<Real> law;
  GrowingPoint<Real> point;
  ForceSeries<Real> force = {};               ///< in the unit of the step's series
  Polynomial<Real> depth = {}, slip = {};     ///< m
  Polynomial<Real> stretch = {};              ///< of the tangential spring, m
  std::vector<BedEndSeries<Real>> ends = {};  ///< of a bed alone
  GrowingBed<Real> bed = {};
};

/// The forces of springs along a step: coefficient n is that of kδ + cδ̇, by those of places up to n + 1.
template <class Real>
class SpringSeries {
 public:
  /// Keeps references to all but `bodies`.
  SpringSeries(const ContactModel<Real>& stack, const SpringPoints<Real>& points, const Bodies<Real>& bodies)
      : stack_(stack), points_(points), bodies_(bodies) {}

  void begin(const ModeSeries<Real>& motion) {
    length_ = motion.length;
    unit_ = length_ * length_;
    growing_.clear();
    growing_.reserve(points_.size());
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const SpringPoint<Real>& point = points_[i];
      if (!point.pushes()) continue;
      const CornerOnFace<Real> corner = corner_of(stack_, point);
      GrowingSpring<Real>& spring = growing_.emplace_back(GrowingSpring<Real>{
          i, point, stack_.springs[point.interface], GrowingPoint<Real>(stack_, motion, corner)});
      const ContactKinematics<Real> rows = kinematics_of(stack_, bodies_, corner);
      put(spring.depth, 0, point.at_face ? Real(0) : Real(-rows.gap));
      put(spring.slip, 0, rows.slip);
      put(spring.stretch, 0, rows.slip - point.slider);
      if (point.is_bed()) begin_bed(motion, point, spring);
    }
    extend_places(0);
    extend_places(1);
  }

  void extend_places(std::size_t m) {
    for (GrowingSpring<Real>& spring : growing_) {
      spring.point.extend(m);
      for (BedEndSeries<Real>& end : spring.ends) end.point.extend(m);
      if (m == 0) continue;
      const int sign = spring.point.corner.upward;
      put(spring.depth, m, -sign * spring.point.place[m].x());
      put(spring.slip, m, sign * spring.point.place[m].y());
      for (std::size_t end = 0; end < spring.ends.size(); ++end)
        put(spring.bed.depth[end], m, -sign * spring.ends[end].point.place[m].x());
    }
  }

  /// Coefficient n of forces, which it adds to those of interfaces.
  void extend_forces(std::size_t n, ShortVector<ForceSeries<Real>>& forces) {
    for (GrowingSpring<Real>& spring : growing_) {
      const SpringLaw<Real>& law = spring.law;
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
  void begin_bed(const ModeSeries<Real>& motion, const SpringPoint<Real>& point,
                 GrowingSpring<Real>& spring) const {
    spring.bed.stretch = stretch_of(point.bed);
    for (std::size_t end = 0; end < 2; ++end) {
      const CornerOnFace<Real> corner = bed_corner(stack_, point, end);
      spring.ends.push_back({GrowingPoint<Real>(stack_, motion, corner), {}});
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
  Real pressure(const SpringLaw<Real>& law, const Polynomial<Real>& depth, std::size_t n) const {
    return law.stiffness * depth[n] + law.damping * rate(depth, n);
  }

  /// Coefficient n of a rate, 1/s.
  Real rate(const Polynomial<Real>& series, std::size_t n) const {
    return Real(n + 1) * series[n + 1] / length_;
  }

  /// While the slider moves, k_t τ + c_t τ̇ = ±μN.
  void extend_sliding(GrowingSpring<Real>& spring, std::size_t n, const Real& normal) const {
    const SpringLaw<Real>& law = spring.law;
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
  Real length_ = 0, unit_ = 0;
  std::vector<GrowingSpring<Real>> growing_;
};

/// What the springs of an interface do at one time; of a rigid interface nothing.
template <class Real>
struct SpringState {
  BasicReaction<Real> reaction;
  BasicSpringEnergy<Real> energy;
};

/// ∫ first · second ds from 0 to s, without loss of terms.
template <class Real>
Real integral_of_product(const Polynomial<Real>& first, const Polynomial<Real>& second, const Real& s) {
  std::array<Real, 2 * max_terms<Real>> weights;
  Real power = s;
  for (std::size_t m = 0; m < weights.size(); ++m, power *= s) weights[m] = power / Real(m + 1);
  Real sum = 0;
  for (std::size_t i = first.terms; i-- > 0;) {
    Real inner = 0;
    for (std::size_t j = second.terms; j-- > 0;) inner += second[j] * weights[i + j];
    sum += first[i] * inner;
  }
  return sum;
}

template <class Real>
Real elastic_energy_of_bed(const ContactModel<Real>& stack, const SpringPoint<Real>& point,
                           const Bodies<Real>& bodies) {
  const auto rows = bed_rows(stack, point, bodies);
  return elastic_energy_of_bed<Real>(stack.springs[point.interface].stiffness, {-rows[0].gap, -rows[1].gap});
}

/// What a point's springs hold, J; one that is left behind by its depth, until its corner has backed away.
template <class Real>
Real elastic_energy(const ContactModel<Real>& stack, const SpringPoint<Real>& point,
                    const Bodies<Real>& bodies) {
  if (point.press == Press::off && !point.is_bed()) return 0;
  const SpringLaw<Real>& law = stack.springs[point.interface];
  const ContactKinematics<Real> rows = kinematics_of(stack, bodies, point);
  Real energy = point.is_bed() ? elastic_energy_of_bed(stack, point, bodies)
                               : Real(law.stiffness * rows.gap * rows.gap / 2);
  if (point.pushes() && law.friction > 0) {
    const Real stretch = rows.slip - point.slider;
    energy += law.tangential_stiffness * stretch * stretch / 2;
  }
  return energy;
}

/// Adds what a point that pushes loses up to s of a step; of a bed the work done on it, with what it holds.
template <class Real>
void add_losses(const GrowingSpring<Real>& spring, const SpringSeries<Real>& series, const Real& s,
                BasicSpringEnergy<Real>& lost) {
  const SpringLaw<Real>& law = spring.law;
  const auto dissipated = [&](const Real& damping, const Polynomial<Real>& place) -> Real {
    if (damping == 0) return 0;
    const Polynomial<Real> rate = derivative(place);
    return damping / series.length() * integral_of_product(rate, rate, s);
  };
  if (spring.start.is_bed()) {
    const GrowingBed<Real>& bed = spring.bed;
    const Polynomial<Real> turning = combined(1, bed.depth[1], -1, bed.depth[0]);
    lost.damped += integral_of_product(bed.normal, derivative(spring.depth), s) +
                   integral_of_product(bed.couple, derivative(turning), s);
  } else {
    lost.damped += dissipated(law.damping, spring.depth);
  }
  if (law.friction == 0) return;
  lost.damped += dissipated(law.tangential_damping, spring.stretch);
  if (spring.start.slide == 0) return;
  const Polynomial<Real> slider = combined(1, spring.slip, -1, spring.stretch);
  lost.rubbed -= integral_of_product(spring.force.tangential, derivative(slider), s) / series.unit();
}

}  // namespace rockstack
