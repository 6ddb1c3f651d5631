#pragma once

#include <cmath>
#include <string>

namespace rockstack {

/// Acceleration pulses as exact functions. With A the amplitude, T the period and t the time since the start:
enum class PulseShape {
  sine,       ///< A sin(2πt/T), for as many periods as there are cycles
  cosine,     ///< A cos(2πt/T), likewise
  half_sine,  ///< A sin(2πt/T), half a period
  rectangle,  ///< A, for the time T
  ricker,     ///< A (1 − 2z²) exp(−z²), z = π(t − 2T)/T, for 4T: 6·10⁻¹⁶ A is cut off
  mavroeidis_papageorgiou,  ///< near-fault pulse of Mavroeidis & Papageorgiou 2003, see velocity below
};

/// One pulse. SI units. The pulse of Mavroeidis & Papageorgiou has the velocity
/// (AT/4π) (1 + cos(2πs/(γT))) cos(2πs/T + ν) with s = t − γT/2, for the time γT; its peak acceleration is
/// about A.
struct Pulse {
  PulseShape shape{};
  double amplitude = 0;  ///< A, m/s²
  double period = 0;     ///< T, s, > 0
  double start = 0;      ///< s, ≥ 0
  double cycles =
      1;  ///< of sine and cosine, > 0, may be infinite; γ of mavroeidis_papageorgiou, > 1, up to 10⁶
  double phase = 0;  ///< ν, rad, of mavroeidis_papageorgiou alone
};

/// π in any number type.
template <class Real>
inline const Real pi = [] {
  using std::acos;
  return acos(Real(-1));
}();

/// How long a pulse lasts, s; infinite for endless cycles.
double length(const Pulse& pulse);

/// The change of velocity from the start of a pulse to `t` s after it, 0 ≤ t ≤ length, m/s.
double velocity(const Pulse& pulse, double t);

/// Acceleration `t` s after the start of a pulse, 0 ≤ t ≤ length, m/s².
template <class Real>
Real acceleration(const Pulse& pulse, const Real& t) {
  using std::cos;
  using std::exp;
  using std::sin;
  const Real amplitude(pulse.amplitude);
  const Real period(pulse.period);
  const Real turn = 2 * pi<Real> / period;
  if (pulse.shape == PulseShape::sine || pulse.shape == PulseShape::half_sine)
    return amplitude * sin(turn * t);
  if (pulse.shape == PulseShape::cosine) return amplitude * cos(turn * t);
  if (pulse.shape == PulseShape::rectangle) return amplitude;
  if (pulse.shape == PulseShape::ricker) {
    const Real z = turn / 2 * (t - 2 * period);
    return amplitude * (1 - 2 * z * z) * exp(-z * z);
  }
  const Real cycles(pulse.cycles);
  const Real s = t - cycles * period / 2;
  const Real carrier = turn * s + Real(pulse.phase);
  const Real envelope = turn * s / cycles;
  return -amplitude / 2 * (sin(envelope) * cos(carrier) / cycles + (1 + cos(envelope)) * sin(carrier));
}

}  // namespace rockstack
