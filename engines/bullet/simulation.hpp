#pragma once

#include "engines/engine.hpp"

class btMLCPSolverInterface;
class btSequentialImpulseConstraintSolver;

namespace rockstack {

enum class BulletSolver { sequential_impulse, nncg, mlcp_dantzig, mlcp_lemke, mlcp_pgs };

/// A constraint solver and, where it is one for complementarity problems, the algorithm inside it.
struct ChosenSolver {
  ChosenSolver(BulletSolver solver, const Parameters& parameters);
  ~ChosenSolver();

  std::unique_ptr<btMLCPSolverInterface> algorithm;
  std::unique_ptr<btSequentialImpulseConstraintSolver> constraints;
};

/// The library clamps a pair's coefficient of friction here (btManifoldResult.cpp).
inline constexpr double friction_clamp = 10;

/// A scene inside Bullet. Precondition: `parameters` are checked.
std::unique_ptr<Simulation> start_bullet(BulletSolver solver, const Setup& setup,
                                         const Parameters& parameters);

}  // namespace rockstack
