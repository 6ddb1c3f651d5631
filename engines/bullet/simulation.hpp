#pragma once

#include <memory>

#include "engines/engine.hpp"

namespace rockstack {

enum class BulletSolver { sequential_impulse, nncg, mlcp_dantzig, mlcp_lemke, mlcp_pgs };

/// A scene inside Bullet. Precondition: `parameters` are checked.
std::unique_ptr<Simulation> start_bullet(BulletSolver solver, const Scene& scene, double dt,
                                         const Parameters& parameters);

}  // namespace rockstack
