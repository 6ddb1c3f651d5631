#pragma once

#include "analytic/round/rolling.hpp"

namespace rockstack {

/// A vector of numbers or of jets.
template <class T>
struct Vector3 {
  T x, y, z;
};
template <class T>
Vector3<T> operator+(const Vector3<T>& a, const Vector3<T>& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class T>
Vector3<T> operator-(const Vector3<T>& a, const Vector3<T>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class Factor, class T>
Vector3<T> operator*(const Factor& factor, const Vector3<T>& a) {
  return {factor * a.x, factor * a.y, factor * a.z};
}
template <class T>
T dot(const Vector3<T>& a, const Vector3<T>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class T>
Vector3<T> cross(const Vector3<T>& a, const Vector3<T>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// The state without angles: the axis d and ω on the ground's axes, and ψ, which nothing else needs.
template <class T>
struct AxisState {
  Vector3<T> axis, omega;
  T azimuth;
};

/// Rates of that state, from moments about the contact point:
///   [A + ρ² + (C − A)ddᵀ − ρρᵀ]ω̇ = −(C − A)(ω × d)(d·ω) + ρ × (ρ̇ × ω − γ),  ḋ = ω × d.
template <class T>
AxisState<T> rates(const Cylinder& body, const AxisState<T>& state, const Felt<T>& felt) {
  const Vector3<T>&d = state.axis, &omega = state.omega;
  const T square = d.x * d.x + d.y * d.y, sine = sqrt(square);
  const Vector3<T> axis_rate = cross(omega, d);
  const auto along_rim = [&](const Vector3<T>& v) { return Vector3<T>{v.x / sine, v.y / sine, v.z / sine}; };
  // b = (cos θ d − k)/sin θ, whose upward part is −sin θ, and (sin θ)' = −cos θ (cos θ)'/sin θ.
  const Vector3<T> b{d.z * d.x / sine, d.z * d.y / sine, -sine};
  const T sine_rate = -(d.z * axis_rate.z) / sine;
  const Vector3<T> b_rate = along_rim(axis_rate.z * d + d.z * axis_rate - sine_rate * b);
  const Vector3<T> rho = body.radius * b - body.half_height * d;
  const Vector3<T> rho_rate = body.radius * b_rate - body.half_height * axis_rate;
  const Vector3<T> felt_force{felt.x, felt.y, felt.up};
  const Vector3<T> moment =
      (body.A - body.C) * (dot(d, omega) * axis_rate) + cross(rho, cross(rho_rate, omega) + felt_force);
  // ρ·ρ = r² + h² as b and d are at right angles, so that the diagonal is I_O.
  const auto row = [&](const T& of_d, const T& of_rho) {
    return (body.C - body.A) * (of_d * d) - of_rho * rho;
  };
  Vector3<T> first = row(d.x, rho.x), second = row(d.y, rho.y), third = row(d.z, rho.z);
  for (T* diagonal : {&first.x, &second.y, &third.z}) constant_part(*diagonal) += body.contact;
  const Vector3<T> cofactors = cross(second, third);
  const T determinant = dot(first, cofactors);
  const Vector3<T> sum =
      moment.x * cofactors + moment.y * cross(third, first) + moment.z * cross(first, second);
  return {axis_rate,
          {sum.x / determinant, sum.y / determinant, sum.z / determinant},
          (d.x * axis_rate.y - d.y * axis_rate.x) / square};
}

}  // namespace rockstack
