#pragma once

#include <string>

#include "analytic/scene/scene.hpp"

namespace rockstack {

/// What a motion under law `consistent` asks of the worst of its interfaces.
struct ContactNeed {
  double least_normal = 0;                          ///< N; negative: it would have to pull
  double force_friction = 0, impulse_friction = 0;  ///< infinite where nothing pushes
  double friction = 0;                              ///< that the scene has, at its smoothest interface
  // First times, infinite where it never comes to that, s.
  double first_pull = 0, first_force_slip = 0, first_impulse_slip = 0;
};

/// Solves the scene under `consistent`.
ContactNeed contact_need(Scene scene);

/// `consistent` where interfaces push and hold throughout, else `unilateral`.
Law law_for(const ContactNeed& need);

/// What comes first of what the law of pivots cannot do, in words, with its time; "nothing".
std::string first_failure(const ContactNeed& need);

}  // namespace rockstack
