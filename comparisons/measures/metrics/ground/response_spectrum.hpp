#pragma once

#include <vector>

#include "analytic/scene/ground/ground_motion.hpp"

namespace rockstack {

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

}  // namespace rockstack
