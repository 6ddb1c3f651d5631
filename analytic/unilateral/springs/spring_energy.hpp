#pragma once

#include "analytic/scene/history.hpp"
#include "analytic/unilateral/springs/spring_series.hpp"

namespace rockstack {

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
