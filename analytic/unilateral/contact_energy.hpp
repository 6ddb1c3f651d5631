#pragma once

#include "analytic/unilateral/contact/bodies.hpp"

namespace rockstack {

/// Kinetic energy and that of weight, J, in the frame of the ground, from the middle of its interface.
double energy(const Scene& scene, const Bodies& bodies);

}  // namespace rockstack
