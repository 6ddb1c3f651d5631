#include "comparisons/measures/metrics/ground/response_spectrum.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rockstack {
namespace {

struct State {
  double displacement = 0, velocity = 0;  ///< from the ground, m and m/s
};

/// An oscillator u'' + 2ζωu' + ω²u = −a and its free motion over one step.
class Oscillator {
 public:
  Oscillator(double period, double damping, double step)
      : omega_(2 * std::numbers::pi / period), damping_(damping), step_(step) {
    const double damped = omega_ * std::sqrt(1 - damping * damping);
    const double decay = std::exp(-damping * omega_ * step);
    cosine_ = decay * std::cos(damped * step);
    sine_ = decay * std::sin(damped * step) / damped;
  }

  /// The state one step on, the ground's acceleration being from + slope t: free motion about the solution
  /// that is itself a straight line.
  State after(const State& state, double from, double slope) const {
    const double square = omega_ * omega_;
    const double line_velocity = -slope / square;
    const double line = (2 * damping_ * slope / omega_ - from) / square;
    const double u = state.displacement - line;
    const double v = state.velocity - line_velocity;
    const double rate = damping_ * omega_;
    return {u * cosine_ + (v + rate * u) * sine_ + line + line_velocity * step_,
            v * cosine_ - (rate * v + square * u) * sine_ + line_velocity};
  }

 private:
  double omega_, damping_, step_, cosine_ = 0, sine_ = 0;
};

}  // namespace

Response response(const GroundMotion& motion, double period, double damping) {
  constexpr int steps_in_period = 50;
  const int parts = std::max(1, static_cast<int>(std::ceil(motion.interval * steps_in_period / period)));
  const double step = motion.interval / parts;
  const Oscillator oscillator(period, damping, step);
  State state;
  double largest = 0;
  for (std::size_t i = 0; i + 1 < motion.samples.size(); ++i) {
    const double slope = (motion.samples[i + 1] - motion.samples[i]) / motion.interval;
    for (int part = 0; part < parts; ++part) {
      state = oscillator.after(state, motion.samples[i] + slope * (part * step), slope);
      largest = std::max(largest, std::abs(state.displacement));
    }
  }
  const Oscillator free(period, damping, period / steps_in_period);
  for (int i = 0; i < steps_in_period; ++i) {
    state = free.after(state, 0, 0);
    largest = std::max(largest, std::abs(state.displacement));
  }
  const double omega = 2 * std::numbers::pi / period;
  return {period, omega * omega * largest};
}

std::vector<Response> response_spectrum(const GroundMotion& motion, double damping) {
  constexpr int count = 201;
  const double shortest = std::max(0.02, motion.interval);
  const double longest = 500 * shortest;
  std::vector<Response> spectrum;
  for (int i = 0; i < count; ++i) {
    const double period = shortest * std::pow(longest / shortest, i / (count - 1.0));
    spectrum.push_back(response(motion, period, damping));
  }
  return spectrum;
}

}  // namespace rockstack
