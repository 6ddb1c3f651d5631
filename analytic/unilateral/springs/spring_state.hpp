#pragma once

#include "analytic/scene/history.hpp"

namespace rockstack {

/// What the springs of an interface do at one time; of a rigid interface nothing.
template <class Real>
struct BasicSpringState {
  BasicReaction<Real> reaction;
  BasicSpringEnergy<Real> energy;
};

}  // namespace rockstack
