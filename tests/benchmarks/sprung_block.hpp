#pragma once

#include <vector>

#include "analytic/scene/scene.hpp"

namespace rockstack::benchmarks {

/// Where CVODE comes to, and in how many steps.
struct SprungMotion {
  std::vector<double> angles;  ///< at the samples, rad
  long steps = 0;
};

/// A block on two corner springs, as somebody would write it who has SUNDIALS: eight equations for CVODE's
/// BDF of order 1 … 5 with Newton's method, a dense Jacobian from differences, and CVODE's own root finding
/// for corners that touch, part, push again, slip and stick. Precondition: one block under law `compliant`
/// with damping, friction and unloaded springs, released at rest at an angle > 0 on ground that is still.
/// @param tolerance relative, and absolute in m and rad
/// @throws std::runtime_error where CVODE fails, or finds more than 10,000 events
SprungMotion sprung_by_bdf(const Scene& scene, double tolerance, const std::vector<double>& samples);

}  // namespace rockstack::benchmarks
