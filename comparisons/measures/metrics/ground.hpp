#pragma once

#include <cstddef>

#include "analytic/scene/scene.hpp"

namespace rockstack {

/// Standard gravity, m/s²: the unit of records and of the Arias intensity.
inline constexpr double standard_gravity = 9.80665;

/// A value, its sign kept, and when it is reached.
struct Peak {
  double value = 0;
  double time = 0;  ///< s
};

/// Velocity and displacement of the ground at the samples, from rest.
struct GroundIntegrals {
  std::vector<double> velocities;     ///< m/s
  std::vector<double> displacements;  ///< m
};

/// When the integral of the squared acceleration has reached a share of its final value. s
struct Span {
  double begin = 0, end = 0;
  double length() const { return end - begin; }
};

/// What engineers call a motion by. Accelerations are straight lines between samples, and everything here is
/// exact for them but for rounding. Each peak is the largest absolute value, also between samples.
struct GroundMeasures {
  std::size_t points = 0;
  double interval = 0;            ///< s
  double duration = 0;            ///< s
  Peak acceleration;              ///< m/s²
  Peak velocity;                  ///< m/s, from rest, the base line as it is
  Peak displacement;              ///< m, likewise
  double final_velocity = 0;      ///< m/s; far from zero, it tells of a base line that is not corrected
  double final_displacement = 0;  ///< m
  double arias_intensity = 0;     ///< π/(2g) ∫a² dt, m/s, g the standard gravity
  Span significant_5_95;          ///< from 5 % to 95 % of the Arias intensity
  Span significant_5_75;          ///< from 5 % to 75 %
};

/// Precondition for all of these: the motion has samples.
GroundMeasures measure_ground(const GroundMotion& motion);
GroundIntegrals ground_integrals(const GroundMotion& motion);

/// The share of the final ∫a² dt that is reached at each sample, 0 to 1 (Husid 1969); zeros where the ground
/// is still.
std::vector<double> husid(const GroundMotion& motion);

/// A line value + slope t under an accelerogram.
struct BaseLine {
  double value = 0;  ///< m/s²
  double slope = 0;  ///< m/s³
};

/// The line whose removal leaves the least mean square of the velocity, after Berg & Housner 1961 (Bulletin
/// of the Seismological Society of America 51, 175–189), who take a parabola.
BaseLine fitted_base_line(const GroundMotion& motion);

/// The motion with the line taken off every sample.
GroundMotion without(const GroundMotion& motion, const BaseLine& line);

/// Peak response of a damped oscillator that stands on the ground and starts from rest.
struct Response {
  double period = 0;               ///< s
  double pseudo_acceleration = 0;  ///< (2π/period)² times the largest displacement from the ground, m/s²
};

/// The oscillator of that period (s, > 0) and damping (a fraction of critical, 0 ≤ damping < 1) under
/// straight lines between samples, from step to step by the exact solution (Nigam & Jennings 1969, Bulletin
/// of the Seismological Society of America 59, 909–922), and for one period after the motion. Steps are no
/// longer than a fiftieth of the period; what a peak between them exceeds them by is below 0.2 %.
/// Precondition: the motion has samples.
Response response(const GroundMotion& motion, double period, double damping);

/// Responses at 201 periods from 0.02 s to 10 s, equally far apart on a logarithmic axis; of samples more
/// than 0.02 s apart, from their interval to 500 times that.
std::vector<Response> response_spectrum(const GroundMotion& motion, double damping);

/// How long the ground moves on after a scene has ended, s: by more than a thousandth of the largest
/// acceleration, to where the motion has an end; else 0.
double ground_left(const Scene& scene);

}  // namespace rockstack
