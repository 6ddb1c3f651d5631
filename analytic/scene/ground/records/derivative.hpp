#pragma once

#include <vector>

namespace rockstack::records {

/// Samples of an acceleration, straight lines between them.
struct Accelerations {
  double interval = 0;  ///< s
  std::vector<double> samples;
};

/// The acceleration, linear in pieces, whose integral from v[0] on passes through every sample of a velocity:
/// its knots lie at the middles between samples (a quadratic spline, Subbotin 1967), and so it is given at
/// half the interval. Exact where the acceleration is a straight line; else it differs by O(interval²). An
/// error δ of the samples makes one of up to 4δ/interval. What is lost is what samples do not show: motion
/// above half the sampling rate. Beyond its ends the acceleration is mirrored. Precondition: two samples.
Accelerations acceleration_of_velocity(double interval, const std::vector<double>& velocities);

/// The same of a displacement: the second derivative of the cubic spline through its samples, at rest at the
/// first and the last. An error δ of the samples makes one of up to 12δ/interval²: a displacement that is
/// known to 0.01 mm each 10 ms gives an acceleration to 1.2 m/s². Precondition: two samples.
Accelerations acceleration_of_displacement(double interval, const std::vector<double>& displacements);

}  // namespace rockstack::records
