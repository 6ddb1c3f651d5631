#pragma once

#include <memory>

#include "analytic/scene/scene.hpp"
#include "engines/bullet/solvers.hpp"
#include "engines/simulation.hpp"

namespace rockstack {

/// A scene inside Bullet. Precondition: `parameters` are checked.
std::unique_ptr<Simulation> start_bullet(BulletSolver solver, const Scene& scene, double dt,
                                         const Parameters& parameters);

}  // namespace rockstack
