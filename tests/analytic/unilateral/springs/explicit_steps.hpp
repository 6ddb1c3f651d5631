#pragma once

#include <complex>
#include <vector>

#include "analytic/scene/scene.hpp"

namespace rockstack::testing {

/// A block as a point of the complex plane, its middle, and an angle; and their rates. SI units.
struct PlaneBlock {
  std::complex<double> place, velocity;
  double angle = 0, rate = 0;
};

/// Follows a stack on corner springs, or on beds, from these states to `end` by the classical Runge–Kutta
/// method in equal steps of at most `step` s, blind to events: what a corner's state is, it learns after each
/// step, so that it converges with order one. Corners that touch at the start hold where they are, relaxed
/// along the face. Uniform blocks and still ground.
std::vector<PlaneBlock> explicit_motion(const Scene& scene, std::vector<PlaneBlock> blocks, double end,
                                        double step);

}  // namespace rockstack::testing
