#include "engines/bullet/solvers.hpp"

#include <btBulletDynamicsCommon.h>

#include <BulletDynamics/ConstraintSolver/btNNCGConstraintSolver.h>
#include <BulletDynamics/MLCPSolvers/btDantzigSolver.h>
#include <BulletDynamics/MLCPSolvers/btLemkeSolver.h>
#include <BulletDynamics/MLCPSolvers/btMLCPSolver.h>
#include <BulletDynamics/MLCPSolvers/btSolveProjectedGaussSeidel.h>

#include <utility>

namespace rockstack {
namespace {

std::unique_ptr<btMLCPSolverInterface> make_algorithm(BulletSolver solver, const Parameters& parameters) {
  if (solver == BulletSolver::mlcp_dantzig) return std::make_unique<btDantzigSolver>();
  if (solver == BulletSolver::mlcp_lemke) {
    auto lemke = std::make_unique<btLemkeSolver>();
    lemke->m_maxLoops = static_cast<int>(parameters.at("maxLoops"));
    lemke->m_maxValue = static_cast<btScalar>(parameters.at("maxValue"));
    return lemke;
  }
  auto projected = std::make_unique<btSolveProjectedGaussSeidel>();
  projected->m_leastSquaresResidualThreshold =
      static_cast<btScalar>(parameters.at("leastSquaresResidualThreshold"));
  return projected;
}

}  // namespace

ChosenSolver::ChosenSolver(BulletSolver solver, const Parameters& parameters) {
  if (solver == BulletSolver::sequential_impulse) {
    constraints_ = std::make_unique<btSequentialImpulseConstraintSolver>();
  } else if (solver == BulletSolver::nncg) {
    constraints_ = std::make_unique<btNNCGConstraintSolver>();
  } else {
    algorithm_ = make_algorithm(solver, parameters);
    auto complementarity = std::make_unique<btMLCPSolver>(algorithm_.get());
    complementarity_ = complementarity.get();
    constraints_ = std::move(complementarity);
  }
}

ChosenSolver::~ChosenSolver() = default;

std::size_t ChosenSolver::fallbacks() const {
  return complementarity_ == nullptr ? 0 : static_cast<std::size_t>(complementarity_->getNumFallbacks());
}

}  // namespace rockstack
