#pragma once

#include <cstddef>
#include <memory>

#include "engines/parameters.hpp"

class btMLCPSolver;
class btMLCPSolverInterface;
class btSequentialImpulseConstraintSolver;

namespace rockstack {

enum class BulletSolver { sequential_impulse, nncg, mlcp_dantzig, mlcp_lemke, mlcp_pgs };

/// A constraint solver and, where it is one for complementarity problems, the algorithm inside it.
class ChosenSolver {
 public:
  ChosenSolver(BulletSolver solver, const Parameters& parameters);
  ~ChosenSolver();
  ChosenSolver(const ChosenSolver&) = delete;
  ChosenSolver& operator=(const ChosenSolver&) = delete;

  btSequentialImpulseConstraintSolver* constraints() const { return constraints_.get(); }

  bool is_complementarity() const { return algorithm_ != nullptr; }

  /// How often Bullet gave a problem up and took sequential impulse in its place.
  std::size_t fallbacks() const;

 private:
  std::unique_ptr<btMLCPSolverInterface> algorithm_;
  std::unique_ptr<btSequentialImpulseConstraintSolver> constraints_;
  btMLCPSolver* complementarity_ = nullptr;
};

}  // namespace rockstack
