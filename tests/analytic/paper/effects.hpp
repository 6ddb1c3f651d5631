#pragma once

#include <string>
#include <vector>

#include "tests/analytic/paper/geometry.hpp"

namespace rockstack::paper {

/// The paper's example (Section 5): B1 = H1 = 1.25 m, B2 = 1 m, H2 = 2.5 m, 2500 kg/m³.
Geometry example();

/// What a misprint does to the paper's example: a number as the print gives it and the right one. Infinite
/// where the event never happens.
struct Effect {
  std::string subject;
  double printed, right;
};

/// In the order of the equations.
std::vector<Effect> effects();

/// Free rocking of the example as one block, released at rest at ±0.15 rad in pattern 3: the first time at
/// which an inequality of Section 2.4 holds, s, in steps of 0.1 ms; infinite where the base hits the ground
/// before.
double time_to_opening(double release, double (*inequality)(const Geometry&, const Motion&, Reading),
                       Reading reading);

}  // namespace rockstack::paper
