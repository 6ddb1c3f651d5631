#include "analytic/scene/ground/ground_motion.hpp"

#include <algorithm>

namespace rockstack {
namespace {

/// Integral over [from, to] inside one piece between samples; of a straight line the middle tells it exactly.
double piece_integral(const GroundMotion& motion, std::size_t piece, double from, double to) {
  const double start = motion.interval * static_cast<double>(piece);
  const double slope = (motion.samples[piece + 1] - motion.samples[piece]) / motion.interval;
  const double middle = 0.5 * (from + to) - start;
  return (to - from) * (motion.samples[piece] + slope * middle);
}

/// The steps of the velocity within [from, to), m/s.
double steps_within(const GroundMotion& motion, double from, double to) {
  double sum = 0;
  for (const VelocityStep& step : motion.steps)
    if (step.time >= from && step.time < to) sum += step.size;
  return sum;
}

}  // namespace

double GroundMotion::end() const {
  if (pulse) return pulse->start + length(*pulse);
  if (!steps.empty()) return steps.back().time;
  return samples.empty() ? 0 : interval * static_cast<double>(samples.size() - 1);
}

double acceleration(const GroundMotion& motion, double t) {
  if (motion.empty() || t > motion.end() || !motion.steps.empty()) return 0;
  if (motion.pulse) return t < motion.pulse->start ? 0 : acceleration(*motion.pulse, t - motion.pulse->start);
  const auto last = motion.samples.size() - 1;
  const auto piece = std::min(static_cast<std::size_t>(t / motion.interval), last);
  if (piece == last) return motion.samples[last];
  const double fraction = t / motion.interval - static_cast<double>(piece);
  return motion.samples[piece] + fraction * (motion.samples[piece + 1] - motion.samples[piece]);
}

double mean_acceleration(const GroundMotion& motion, double from, double to) {
  if (!motion.steps.empty()) return steps_within(motion, from, to) / (to - from);
  if (motion.pulse) {
    const auto gained = [&pulse = *motion.pulse](double t) {
      return velocity(pulse, std::clamp(t - pulse.start, 0.0, length(pulse)));
    };
    return (gained(to) - gained(from)) / (to - from);
  }
  const double end = std::min(to, motion.end());
  if (motion.empty() || end <= from) return 0;
  double sum = 0;
  double t = from;
  for (auto piece = static_cast<std::size_t>(from / motion.interval); t < end; ++piece) {
    if (piece + 1 >= motion.samples.size()) break;
    const double next = std::min(end, motion.interval * static_cast<double>(piece + 1));
    if (next > t) sum += piece_integral(motion, piece, t, next);
    t = std::max(t, next);
  }
  return sum / (to - from);
}

double peak(const GroundMotion& motion) {
  double largest = 0;
  for (const double sample : motion.samples) largest = std::max(largest, std::abs(sample));
  return largest;
}

}  // namespace rockstack
