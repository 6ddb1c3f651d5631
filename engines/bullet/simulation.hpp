#pragma once

#include "engines/engine.hpp"

namespace rockstack {

enum class BulletSolver { sequential_impulse, nncg, mlcp_dantzig, mlcp_lemke, mlcp_pgs };

/// The library clamps a pair's coefficient of friction here (btManifoldResult.cpp).
inline constexpr double friction_clamp = 10;

/// A scene inside Bullet. Precondition: `parameters` are checked.
std::unique_ptr<Simulation> start_bullet(BulletSolver solver, const Setup& setup,
                                         const Parameters& parameters);

}  // namespace rockstack
