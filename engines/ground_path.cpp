#include "engines/ground_path.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace rockstack {
namespace {

/// ∫ (end − t) a(t) dt over [from, to], on which the acceleration is smooth.
double smooth_moment(const GroundMotion& motion, double from, double to, double end) {
  // Gauss–Legendre on [−1, 1].
  static constexpr std::array<double, 3> points{0, 0.5384693101056831, 0.9061798459386640};
  static constexpr std::array<double, 3> weights{0.5688888888888889, 0.4786286704993665, 0.2369268850561891};
  const double middle = 0.5 * (from + to);
  const double half = 0.5 * (to - from);
  const auto value = [&](double t) { return (end - t) * acceleration(motion, t); };
  double sum = weights[0] * value(middle);
  for (std::size_t i = 1; i < points.size(); ++i) {
    sum += weights[i] * (value(middle - half * points[i]) + value(middle + half * points[i]));
  }
  return half * sum;
}

/// The next time after t at which the acceleration is not smooth.
double next_kink(const GroundMotion& motion, double t) {
  if (motion.pulse) return t < motion.pulse->start ? motion.pulse->start : motion.end();
  return motion.interval * (std::floor(t / motion.interval) + 1);
}

double moment(const GroundMotion& motion, double from, double to) {
  const double last = std::min(to, motion.end());
  double sum = 0;
  for (double t = from; t < last;) {
    double next = std::min(last, next_kink(motion, t));
    if (!(next > t)) next = last;  // a kink that rounding puts at t itself
    sum += smooth_moment(motion, t, next, to);
    t = next;
  }
  return sum;
}

}  // namespace

double GroundPath::Axis::advance(const GroundMotion& motion, double from, double to) {
  if (motion.empty()) return 0;
  const double length = to - from;
  const double mean = velocity + moment(motion, from, to) / length;
  displacement += mean * length;
  velocity += mean_acceleration(motion, from, to) * length;
  return mean;
}

GroundStep GroundPath::next() {
  const double from = static_cast<double>(steps_) * dt_;
  const double to = static_cast<double>(++steps_) * dt_;
  GroundStep step{x_.displacement, y_.displacement, 0, 0};
  step.velocity_x = x_.advance(horizontal_, from, to);
  step.velocity_y = y_.advance(vertical_, from, to);
  return step;
}

}  // namespace rockstack
