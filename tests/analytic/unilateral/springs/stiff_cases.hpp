#pragma once

#include <string>
#include <vector>

#include "analytic/scene/scene.hpp"

namespace rockstack::testing {

/// What one rocking impact leaves of a block's angular velocity, by its next peak: half-sizes of 0.25 m and
/// 0.5 m, 1000 kg, released at 0.02 rad without slip; k in N/m at each corner, and damping c = 2ζ√(k m'), of
/// a corner that meets m' with 1/m' = 1/m + b²/I about the other corner. 0.7 on rigid ground (Housner 1963).
double rocking_ratio(double stiffness, double damping_ratio);

/// Two blocks of which the upper one falls back on the lower one; laws of rigid contact differ in what
/// follows.
struct StiffCase {
  std::string name;
  Scene scene;
  double time = 0;  ///< after the impact, s, when angles are looked at
};

std::vector<StiffCase> stiff_cases();

/// The base's angle then, rad, on springs and under each rigid law, without slip.
struct StiffAnswer {
  double springs = 0;
  double paper = 0, consistent = 0, unilateral = 0;
};

/// With stiffness k in N/m at each corner, and damping c = 2ζ√(km), m the mass of the base, kg.
StiffAnswer answer_of(const StiffCase& one, double stiffness, double damping_ratio);

}  // namespace rockstack::testing
