#include "analytic/scene/ground/pulse.hpp"

namespace rockstack {

double length(const Pulse& pulse) {
  if (pulse.shape == PulseShape::half_sine) return pulse.period / 2;
  if (pulse.shape == PulseShape::rectangle) return pulse.period;
  if (pulse.shape == PulseShape::ricker) return 4 * pulse.period;
  return pulse.cycles * pulse.period;
}

double velocity(const Pulse& pulse, double t) {
  const double turn = 2 * pi<double> / pulse.period;
  if (pulse.shape == PulseShape::sine || pulse.shape == PulseShape::half_sine) {
    // 1 − cos without cancellation
    const double half = std::sin(turn * t / 2);
    return 2 * pulse.amplitude / turn * half * half;
  }
  if (pulse.shape == PulseShape::cosine) return pulse.amplitude / turn * std::sin(turn * t);
  if (pulse.shape == PulseShape::rectangle) return pulse.amplitude * t;
  if (pulse.shape == PulseShape::ricker) {
    const double s = t - 2 * pulse.period;
    const double z = turn / 2 * s;
    return pulse.amplitude * s * std::exp(-z * z);
  }
  const double s = t - pulse.cycles * pulse.period / 2;
  const double envelope = 1 + std::cos(turn * s / pulse.cycles);
  return pulse.amplitude / (2 * turn) * envelope * std::cos(turn * s + pulse.phase);
}

}  // namespace rockstack
