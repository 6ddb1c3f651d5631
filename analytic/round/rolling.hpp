#pragma once

#include <optional>

#include "analytic/polynomials/jet.hpp"

namespace rockstack {

// A uniform right circular cylinder that rolls on the rim of its base, without slip, on level ground, twice.
//
// Frame: k up, d along the axis, θ the tilt between them, p the horizontal direction of tilt, q = k × p, and
// b = cos θ p − sin θ k from the centre of the base to the contact point. ψ turns p about k. ω = ω₁b + θ̇q +
// ω₃d with ω₁ = −ψ̇ sin θ and ω₃ = φ̇ + ψ̇ cos θ; ρ = r b − h d leads from the centre of mass to the contact
// point. No slip: v = ρ × ω. All is for a unit of mass.

/// A cylinder's numbers. SI units.
struct Cylinder {
  double radius, half_height;  ///< r, h, m
  double gravity;              ///< m/s²
  double C = radius * radius / 2,
         A = C / 2 + half_height * half_height / 3;                  ///< about and across the axis, m²
  double contact = A + radius * radius + half_height * half_height;  ///< I_O, across, about the rim, m²

  double slenderness() const { return std::atan2(radius, half_height); }
};

/// What the ground makes a body feel: the ground's acceleration along it, and g more than that upwards, m/s².
template <class T>
struct Felt {
  T x, y, up;
};

/// Along p, q and up, where p is turned by ψ from the direction (east, north).
template <class T>
Felt<T> turned(const Felt<T>& felt, const SineCosine<T>& psi, double east, double north) {
  const T along = east * felt.x + north * felt.y, across = east * felt.y - north * felt.x;
  return {psi.cosine * along + psi.sine * across, psi.cosine * across - psi.sine * along, felt.up};
}

/// The state by angles. Near θ = 0 the numbers keep their digits: θ → 0 as ω₁ → ∞.
template <class T>
struct Rolling {
  T tilt, tilt_rate, omega1, omega3, azimuth;
};

/// Rates of the state, with a the ground's acceleration in its frame, and γ = −a − g k on b, q and d:
///   I_O θ̈ = −ω₁(AΩ₃ − Cω₃) − (hω₁ + rω₃)(hΩ₃ − rω₁) + hγ₁ + rγ₃,  Ω₃ = ψ̇ cos θ,
///   ω̇₁ = [(C + r²)R₁ + (hC/r)R₂]/D,  ω̇₃ = [A R₂ − r h R₁]/D,  D = A(C + r²) + h²C,
///   R₁ = θ̇(AΩ₃ − Cω₃),  R₂ = r[θ̇(hΩ₃ − rω₁) − γ₂]:
/// moments about the axes of the frame, with the contact force taken out by a = d/dt(ρ × ω).
template <class T>
Rolling<T> rates(const Cylinder& body, const Rolling<T>& state, const Felt<T>& felt, double east,
                 double north) {
  const auto& [radius, height, gravity, C, A, contact] = body;
  const auto [sine, cosine] = sine_cosine(state.tilt);
  const Felt<T> own = turned(felt, sine_cosine(state.azimuth), east, north);
  const T turn = -state.omega1 / sine, frame = turn * cosine;
  const T speed = height * state.omega1 + radius * state.omega3;
  const T gyro = A * frame - C * state.omega3, sweep = height * frame - radius * state.omega1;
  const T force1 = own.up * sine - own.x * cosine, force3 = -(own.up * cosine) - own.x * sine;
  const T first = state.tilt_rate * gyro, second = radius * (state.tilt_rate * sweep + own.y);
  const double determinant = A * (C + radius * radius) + height * height * C;
  return {state.tilt_rate,
          (1 / contact) * (height * force1 + radius * force3 - state.omega1 * gyro - speed * sweep),
          (1 / determinant) * ((C + radius * radius) * first + (height * C / radius) * second),
          (1 / determinant) * (A * second - radius * height * first), turn};
}

/// What the contact carries: its force across the ground over the weight, and what rolling needs of friction,
/// the force along the ground over that across it. Of a column that stands, of its base.
struct Support {
  double normal, friction;
};

/// The force f = a_G − γ on b, q and d, with ψ from x.
inline Support support(const Cylinder& body, const Rolling<double>& state, const Felt<double>& felt) {
  if (state.tilt == 0) return {felt.up / body.gravity, std::hypot(felt.x, felt.y) / felt.up};
  const double r = body.radius, h = body.half_height;
  const Rolling<double> rate = rates<double>(body, state, felt, 1, 0);
  const auto [sine, cosine] = sine_cosine(state.tilt);
  const Felt<double> own = turned(felt, sine_cosine(state.azimuth), 1, 0);
  const double frame = rate.azimuth * cosine, speed = h * state.omega1 + r * state.omega3;
  const double square = state.tilt_rate * state.tilt_rate;
  const double b = h * rate.tilt_rate + r * square + frame * speed - own.up * sine + own.x * cosine;
  const double q =
      state.tilt_rate * (h * frame - r * state.omega1) - h * rate.omega1 - r * rate.omega3 + own.y;
  const double d = r * rate.tilt_rate - state.omega1 * speed - h * square + own.up * cosine + own.x * sine;
  const double normal = d * cosine - b * sine;
  return {normal / body.gravity, std::hypot(b * cosine + d * sine, q) / normal};
}

/// Kinetic and potential energy over the mass, J/kg.
inline double energy(const Cylinder& body, const Rolling<double>& state) {
  const double r = body.radius, h = body.half_height, speed = h * state.omega1 + r * state.omega3;
  const double tilting = state.tilt_rate * state.tilt_rate;
  return ((r * r + h * h) * tilting + speed * speed + body.A * (state.omega1 * state.omega1 + tilting) +
          body.C * state.omega3 * state.omega3) /
             2 +
         body.gravity * (h * std::cos(state.tilt) + r * std::sin(state.tilt));
}

/// ψ̇ of steady precession with the centre of mass at rest, rω₃ = −hω₁; none where it is not real.
inline std::optional<double> steady_precession(const Cylinder& body, double tilt) {
  const double r = body.radius, h = body.half_height, sine = std::sin(tilt), cosine = std::cos(tilt);
  const double square =
      body.gravity * (r * cosine - h * sine) / (sine * (body.A * cosine - body.C * h / r * sine));
  return square > 0 ? std::optional(std::sqrt(square)) : std::nullopt;
}

}  // namespace rockstack
