#pragma once

#include <string>
#include <vector>

namespace rockstack {

/// Ground acceleration along one axis: samples from t = 0 at a constant interval, linear between them, zero after
/// the last. No samples: no motion. SI units.
struct GroundMotion {
  double interval = 0;          ///< s, > 0 where there are samples
  std::vector<double> samples;  ///< m/s²
  std::string source;           ///< where the samples come from, for reports

  bool empty() const { return samples.empty(); }
  double end() const { return samples.empty() ? 0 : interval * static_cast<double>(samples.size() - 1); }
};

/// Acceleration in m/s² at time t ≥ 0.
double acceleration(const GroundMotion& motion, double t);

/// Mean acceleration in m/s² over [from, to], 0 ≤ from < to, exact for the samples' straight lines: the constant
/// that gives a time-stepping engine the right impulse over its step.
double mean_acceleration(const GroundMotion& motion, double from, double to);

/// Largest absolute sample in m/s², 0 without motion.
double peak(const GroundMotion& motion);

}  // namespace rockstack
