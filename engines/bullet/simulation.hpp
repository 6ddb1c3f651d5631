#pragma once

#include <memory>

#include "analytic/scene/scene.hpp"
#include "engines/bullet/solvers.hpp"
#include "engines/simulation.hpp"

namespace rockstack {

/// The library clamps a pair's coefficient of friction here (btManifoldResult.cpp).
inline constexpr double friction_clamp = 10;

/// A scene inside Bullet. Precondition: `parameters` are checked.
std::unique_ptr<Simulation> start_bullet(BulletSolver solver, const Setup& setup,
                                         const Parameters& parameters);

}  // namespace rockstack
