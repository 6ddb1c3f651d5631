#pragma once

#include <optional>
#include <vector>

#include "analytic/scene/ground/pulse.hpp"

namespace rockstack {

/// Ground acceleration along one axis: either samples from t = 0 at a constant interval, linear between them,
/// or a pulse; zero before and after. Neither: no motion. SI units.
struct GroundMotion {
  double interval = 0;          ///< s, > 0 where there are samples
  std::vector<double> samples;  ///< m/s²
  std::string source = {};      ///< where the samples come from, for reports
  bool made_up = false;         ///< a synthetic motion, no real record
  std::optional<Pulse> pulse = {};

  bool empty() const { return samples.empty() && !pulse; }
  /// The time after which the ground is still, s.
  double end() const;
};

/// Acceleration in m/s² at time t ≥ 0.
double acceleration(const GroundMotion& motion, double t);

/// Mean acceleration in m/s² over [from, to], 0 ≤ from < to, exact for straight lines and pulses: the
/// constant that gives a time-stepping engine the right impulse over its step.
double mean_acceleration(const GroundMotion& motion, double from, double to);

/// Largest absolute sample in m/s², 0 without motion.
double peak(const GroundMotion& motion);

}  // namespace rockstack
