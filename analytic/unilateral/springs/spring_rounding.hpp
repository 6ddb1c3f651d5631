#pragma once

#include "analytic/polynomials/crossing.hpp"
#include "analytic/unilateral/springs/spring_point.hpp"

namespace rockstack {

// What a contact does that presses by roundings alone, and how long a slider may stick and slip.
//
// Places round to ρ = 9 ε H and velocities to ν = 9 ε v, with H the height of the stack and v the fastest
// velocity in it. So a depth rounds to ρ, a normal force kδ + cδ̇ to N₀ = kρ + cν, the force along the face
// likewise to T₀, and what parts standing still from sliding, F = μN − |k_t τ + c_t τ̇|, to μN₀ + T₀. Where
// springs bear nothing yet, or no longer, all of these are roundings: each has a sign, which says nothing.
// Blocks that are set down unloaded come to press one after another: in a column N of interface k goes with
// tᵏ behind dashpots, and with t²ᵏ without them.
//
// The rule: what is within its rounding of zero has no sign. A point goes on with what it does until one of
// its quantities has left that range, to either side.
//
// It also ends what would stick and slip without end. Where a slider starts or stops, the force along the
// face and the rate of its stretch are continuous in places, velocities and stretches: behind a dashpot as
// the force is clamped to ±μN, without one as the stretch is (a sweeping process). So accelerations are, and
// F has one rate on both sides of F = 0. Filippov's sliding, where either side drives F back to zero, does
// not occur. A slider at F = 0 for a while, as where N and T vanish together, creeps: it sticks or slips,
// whichever it did, while F is within its rounding. Between two changes F goes through twice that.

/// What roundings make of places and velocities, and so of the quantities of points. SI units.
template <class Real>
struct SpringRounding {
  Real place = 0;  ///< ρ, m
  Real speed = 0;  ///< ν, m/s

  SpringRounding(const ContactModel<Real>& stack, const Bodies<Real>& bodies) {
    const Real height = stack.height();
    Real fastest = 0;
    for (const Pose<Real>& rate : bodies.velocity)
      fastest = std::max<Real>(fastest, abs(rate.x) + abs(rate.y) + height * abs(rate.angle));
    place = tolerance<Real>(2e-15) * height;
    speed = tolerance<Real>(2e-15) * fastest;
  }

  /// Rounding of a normal force, N.
  Real normal(const SpringLaw<Real>& law) const { return law.stiffness * place + law.damping * speed; }

  /// Rounding of what a point's friction has left, N.
  Real strength(const SpringLaw<Real>& law) const {
    return law.friction * normal(law) + law.tangential_stiffness * place + law.tangential_damping * speed;
  }

  /// Rounding of a slider's rate, m/s: (k_t τ + c_t τ̇ − μN)/c_t of the slip, or without dashpots τ̇ − μkδ̇/k_t.
  Real slider_rate(const SpringLaw<Real>& law) const {
    if (law.tangential_damping > 0) return strength(law) / law.tangential_damping;
    return speed * (1 + law.friction * law.stiffness / law.tangential_stiffness);
  }
};

/// Where a series becomes negative. From a start within its rounding of zero it does so where it first leaves
/// that range downwards, or, once it has left it upwards, where it is zero.
template <class Real>
std::optional<Real> told_crossing(Polynomial<Real> series, const Real& rounding) {
  if (series.terms == 0 || !(abs(series[0]) <= rounding)) return first_crossing(series);
  series[0] = std::max<Real>(series[0], 0);
  const std::optional<Real> crossing = first_crossing(series);
  if (!crossing) return crossing;
  const std::optional<Real> leaves = first_crossing(line(rounding, -1, series));
  if (leaves && *leaves < *crossing) return crossing;
  return first_crossing(line(rounding, 1, series));
}

// Where one corner takes over from another, and what goes over with it.
//
// At an end of an interface two corners may push: A of the block above on the face below, and B of the block
// below under the face above. With A a distance a inside the end of its face, at which B is, and δ deep, and
// the upper block turned by φ against the lower one to the side of that end, B is
//
//     a′ = δ sin φ − a cos φ  inside the end of its face,  δ′ = δ cos φ + a sin φ  deep.
//
// While a slider moves outward, the corner pushes that is farther inside its face. Both are as far inside
// where a = δ tan(φ/2), and there they are as deep, δ′ = δ. So the springs across both faces hold the same;
// and as the stretch τ goes over, so do those along them, and |k_t τ| stays to μN: the law is continuous.
//
// A slider that stands still may be left behind by its corner, as by that of a block of equal width, which
// starts at a = 0. As it comes to move outward, the corner may be beyond that place, and the depth changes at
// once. What the springs hold together goes over: k_t τ′² = k_t τ² + k (δ² − δ′²). For k_t = k that is one
// spring between the corner and its slider, which the turn of the face leaves as it is. To first order in φ,
// k_t τ changes by N φ for any k_t, as the turn of the force has it. Three cases remain:
//
//   - B is not in its face, δ′ ≤ 0: nothing pushes, and what springs held is lost.
//   - Without a dashpot, a stretch beyond μN slips back to it at once, and is rubbed; one below it sticks.
//   - Springs hold less than the depth of B stands for, k_t τ² + k δ² < k δ′². Then τ′ = 0, and the law
//   itself
//     jumps: the motion gains the difference. δ′ > δ for φ < 0 alone, where both ends press and φ is small.
//     With the slider at the end, τ = −a, the gain ½k (δ′² − δ²) − ½k_t a² is largest for one a: it is at
//     most ½k δ² sin²φ (1 − r)/(r − sin²φ), r = k_t/k > sin²φ. It counts as damped, with its sign.

/// Puts a point that pushes on the corner of the other block at its end; `bodies` are where they are.
template <class Real>
void pass_to_other_corner(const ContactModel<Real>& stack, const Bodies<Real>& bodies,
                          SpringPoint<Real>& point) {
  const ContactKinematics<Real> before = kinematics_of(stack, bodies, point);
  const Real stretch = before.slip - point.slider;
  point.corner_below = !point.corner_below;
  const ContactKinematics<Real> after = kinematics_of(stack, bodies, point);
  point.slider = after.slip;
  if (!(after.gap < 0)) {
    point.press = Press::off;
    point.slide = 0;
    return;
  }
  const SpringLaw<Real>& law = stack.springs[point.interface];
  if (law.friction == 0) return;
  const Real freed = (before.gap - after.gap) * (before.gap + after.gap);
  const Real square = stretch * stretch + law.stiffness / law.tangential_stiffness * freed;
  point.slider -= copysign(sqrt(std::max<Real>(square, 0)), stretch);
}

/// Without a dashpot along the face, which would let it take time, a slider moves at once to where friction
/// holds it, or stands still where it holds already. Returns what that rubs, J.
template <class Real>
Real slip_at_once(const ContactModel<Real>& stack, const Bodies<Real>& bodies, SpringPoint<Real>& point) {
  const SpringLaw<Real>& law = stack.springs[point.interface];
  if (!point.pushes() || point.slide == 0 || law.tangential_damping > 0) return 0;
  const ContactKinematics<Real> rows = kinematics_of(stack, bodies, point);
  const Real stretch = rows.slip - point.slider;
  const Real most = law.friction * law.stiffness * -rows.gap / law.tangential_stiffness;
  const Real beyond = point.slide * stretch - most;
  if (law.tangential_stiffness * beyond < -SpringRounding<Real>(stack, bodies).strength(law)) {
    point.slide = 0;
    return 0;
  }
  point.slider = rows.slip - point.slide * most;
  return law.tangential_stiffness * beyond * (point.slide * stretch + most) / 2;
}

}  // namespace rockstack
