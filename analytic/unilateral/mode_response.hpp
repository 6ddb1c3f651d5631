#pragma once

#include "analytic/unilateral/contact_problem.hpp"

namespace rockstack {

/// What one interface does to the block above it: forces in N and N·m, or impulses; the moment is about its
/// held point, and that of a pivot is zero.
struct ContactForce {
  double normal = 0, tangential = 0, moment = 0;
};

/// What a mode leads to.
struct ModeResponse {
  FreeVector motion;
  std::vector<ContactForce> forces;
};

/// The motion that is left of a free one where joints hold as they say.
ModeResponse respond(const FrictionStack& stack, const std::vector<Joint>& joints, const Bodies& bodies,
                     const FreeVector& free, Sought sought);

}  // namespace rockstack
