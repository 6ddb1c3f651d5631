#pragma once

#include <optional>
#include <vector>

#include "analytic/scene/ground/pulse.hpp"

namespace rockstack {

/// A step of the velocity at an instant.
struct VelocityStep {
  double time = 0;  ///< s, ≥ 0
  double size = 0;  ///< m/s
};

/// Ground acceleration along one axis: either samples from t = 0 at a constant interval, linear between them,
/// or a pulse; zero before and after; and steps of the velocity. Nothing of it: no motion. SI units. The
/// force of a push has the same form, in N for m/s², and impulses in N·s for steps.
struct GroundMotion {
  double interval = 0;          ///< s, > 0 where there are samples
  std::vector<double> samples;  ///< m/s²
  std::string source = {};      ///< where the samples come from, for reports
  bool made_up = false;         ///< a synthetic motion, no real record
  std::optional<Pulse> pulse = {};
  std::vector<VelocityStep> steps = {};  ///< in order of time

  /// Whether it has accelerations, besides steps of the velocity.
  bool accelerates() const { return !samples.empty() || pulse; }
  bool empty() const { return samples.empty() && !pulse && steps.empty(); }
  /// The time after which the ground is still, s.
  double end() const;
};

/// Acceleration in m/s² at time t ≥ 0, without steps of the velocity.
double acceleration(const GroundMotion& motion, double t);

/// Mean acceleration in m/s² over [from, to), 0 ≤ from < to, exact for straight lines, pulses and steps: the
/// constant that gives a time-stepping engine the right impulse over its step.
double mean_acceleration(const GroundMotion& motion, double from, double to);

/// Largest absolute sample in m/s², 0 without motion.
double peak(const GroundMotion& motion);

}  // namespace rockstack
