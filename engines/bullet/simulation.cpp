#include "engines/bullet/simulation.hpp"

#include <btBulletDynamicsCommon.h>

#include <BulletDynamics/ConstraintSolver/btNNCGConstraintSolver.h>
#include <BulletDynamics/MLCPSolvers/btDantzigSolver.h>
#include <BulletDynamics/MLCPSolvers/btLemkeSolver.h>
#include <BulletDynamics/MLCPSolvers/btMLCPSolver.h>
#include <BulletDynamics/MLCPSolvers/btSolveProjectedGaussSeidel.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "engines/placement.hpp"

namespace rockstack {
namespace {

btScalar scalar(double value) {
  return static_cast<btScalar>(value);
}

btVector3 vector(double x, double y, double z) {
  return {scalar(x), scalar(y), scalar(z)};
}

/// A box that carries its own contact breaking threshold, so that no global of the library has to be written.
class Box : public btBoxShape {
 public:
  Box(const btVector3& half_extents, double breaking_factor)
      : btBoxShape(half_extents), breaking_factor_(breaking_factor) {}
  btScalar getContactBreakingThreshold(btScalar /*library_factor*/) const override {
    return scalar(breaking_factor_) * getAngularMotionDisc();
  }

 private:
  double breaking_factor_;
};

void apply(const Parameters& parameters, btContactSolverInfo& info) {
  info.m_numIterations = static_cast<int>(parameters.at("numIterations"));
  info.m_erp2 = scalar(parameters.at("erp2"));
  info.m_globalCfm = scalar(parameters.at("globalCfm"));
  info.m_sor = scalar(parameters.at("sor"));
  info.m_splitImpulse = static_cast<int>(parameters.at("splitImpulse"));
  info.m_splitImpulsePenetrationThreshold = scalar(parameters.at("splitImpulsePenetrationThreshold"));
  info.m_splitImpulseTurnErp = scalar(parameters.at("splitImpulseTurnErp"));
  info.m_linearSlop = scalar(parameters.at("linearSlop"));
  info.m_warmstartingFactor = scalar(parameters.at("warmstartingFactor"));
  info.m_solverMode = static_cast<int>(parameters.at("solverMode"));
  info.m_leastSquaresResidualThreshold = scalar(parameters.at("leastSquaresResidualThreshold"));
}

/// A constraint solver and, where it is one, the solver of the linear complementarity problem inside it.
struct ChosenSolver {
  std::unique_ptr<btMLCPSolverInterface> inner;
  std::unique_ptr<btSequentialImpulseConstraintSolver> constraints;
  btMLCPSolver* complementarity = nullptr;

  /// How often Bullet gave a problem up and took sequential impulse in its place.
  std::size_t fallbacks() const {
    return complementarity == nullptr ? 0 : static_cast<std::size_t>(complementarity->getNumFallbacks());
  }
};

std::unique_ptr<btMLCPSolverInterface> make_inner(BulletSolver solver, const Parameters& parameters) {
  if (solver == BulletSolver::mlcp_dantzig) return std::make_unique<btDantzigSolver>();
  if (solver == BulletSolver::mlcp_lemke) {
    auto lemke = std::make_unique<btLemkeSolver>();
    lemke->m_maxLoops = static_cast<int>(parameters.at("maxLoops"));
    lemke->m_maxValue = scalar(parameters.at("maxValue"));
    return lemke;
  }
  auto projected = std::make_unique<btSolveProjectedGaussSeidel>();
  projected->m_leastSquaresResidualThreshold = scalar(parameters.at("leastSquaresResidualThreshold"));
  return projected;
}

std::unique_ptr<ChosenSolver> make_solver(BulletSolver solver, const Parameters& parameters) {
  auto chosen = std::make_unique<ChosenSolver>();
  if (solver == BulletSolver::sequential_impulse) {
    chosen->constraints = std::make_unique<btSequentialImpulseConstraintSolver>();
  } else if (solver == BulletSolver::nncg) {
    chosen->constraints = std::make_unique<btNNCGConstraintSolver>();
  } else {
    chosen->inner = make_inner(solver, parameters);
    auto complementarity = std::make_unique<btMLCPSolver>(chosen->inner.get());
    chosen->complementarity = complementarity.get();
    chosen->constraints = std::move(complementarity);
  }
  return chosen;
}

double angle_of(const btRigidBody& body) {
  const btMatrix3x3& turn = body.getWorldTransform().getBasis();
  return std::atan2(-turn[1][0], turn[0][0]);
}

class BulletSimulation : public Simulation {
 public:
  BulletSimulation(BulletSolver solver, Scene scene, double dt, const Parameters& parameters)
      : scene_(std::move(scene)),
        dt_(dt),
        mass_factor_(parameters.at("unitMass") != 0 ? 1 / scene_.blocks.front().mass : 1),
        dispatcher_(&configuration_),
        solver_(make_solver(solver, parameters)) {
    apply(parameters, world_.getSolverInfo());
    set_gravity({0, -scene_.gravity});
    const double breaking_factor = scalar(parameters.at("contactBreakingThreshold"));
    add_ground(breaking_factor);
    for (const Placement& placement : place(scene_)) add_block(placement, breaking_factor);
  }

  void step() override {
    if (is_shaken(scene_)) {
      const double start = static_cast<double>(steps_) * dt_;
      set_gravity(body_acceleration(scene_, start, static_cast<double>(steps_ + 1) * dt_));
    }
    world_.stepSimulation(scalar(dt_), 0);
    ++steps_;
    for (std::size_t k = 0; k < angles_.size(); ++k) angles_[k] = unwrap(angle_of(block(k)), angles_[k]);
  }

  void read(std::span<double> angles, std::span<double> velocities) const override {
    std::copy(angles_.begin(), angles_.end(), angles.begin());
    for (std::size_t k = 0; k < angles_.size(); ++k) velocities[k] = -block(k).getAngularVelocity().z();
  }

  std::size_t warnings() const override { return solver_->fallbacks(); }

 private:
  const btRigidBody& block(std::size_t k) const { return *bodies_[k + 1]; }

  void set_gravity(const BodyAcceleration& acceleration) {
    world_.setGravity(vector(acceleration.x, acceleration.y, 0));
  }

  /// A box rather than a plane: against a plane Bullet finds one corner a step.
  void add_ground(double breaking_factor) {
    double reach = scene_.engine.depth;
    for (const Block& block : scene_.blocks) reach += 2 * (block.half_width + block.half_height);
    reach *= 10;
    shapes_.push_back(std::make_unique<Box>(vector(reach, reach, reach), breaking_factor));
    btRigidBody::btRigidBodyConstructionInfo info(0, nullptr, shapes_.back().get());
    info.m_startWorldTransform = btTransform(btQuaternion::getIdentity(), vector(0, -reach, 0));
    add(info);
  }

  void add_block(const Placement& placement, double breaking_factor) {
    const btVector3 half = vector(0.5 * placement.width, 0.5 * placement.height, 0.5 * placement.depth);
    shapes_.push_back(std::make_unique<Box>(half, breaking_factor));
    btRigidBody::btRigidBodyConstructionInfo info(
        scalar(mass_factor_ * placement.mass), nullptr, shapes_.back().get(),
        mass_factor_ * vector(placement.inertia_about_x, placement.inertia_about_y, placement.inertia));
    info.m_startWorldTransform = btTransform(btQuaternion(btVector3(0, 0, 1), scalar(-placement.angle)),
                                             vector(placement.x, placement.y, 0));
    btRigidBody& body = add(info);
    body.setLinearFactor({1, 1, 0});
    body.setAngularFactor({0, 0, 1});
    body.setActivationState(DISABLE_DEACTIVATION);
    body.setLinearVelocity(vector(placement.velocity_x, placement.velocity_y, 0));
    body.setAngularVelocity(vector(0, 0, -placement.angular_velocity));
    angles_.push_back(placement.angle);
  }

  btRigidBody& add(btRigidBody::btRigidBodyConstructionInfo& info) {
    // Bullet multiplies the coefficients of the two bodies that touch.
    info.m_friction = scalar(std::sqrt(scene_.engine.friction));
    info.m_restitution = 0;
    bodies_.push_back(std::make_unique<btRigidBody>(info));
    world_.addRigidBody(bodies_.back().get());
    return *bodies_.back();
  }

  Scene scene_;
  double dt_;
  double mass_factor_;  ///< of every mass; no angle depends on it
  std::size_t steps_ = 0;
  std::vector<double> angles_;
  // The world comes last: it is the first to go and still needs the others then.
  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_;
  btDbvtBroadphase broadphase_;
  std::unique_ptr<ChosenSolver> solver_;
  std::vector<std::unique_ptr<btCollisionShape>> shapes_;
  std::vector<std::unique_ptr<btRigidBody>> bodies_;  ///< ground first, then bottom to top
  btDiscreteDynamicsWorld world_{&dispatcher_, &broadphase_, solver_->constraints.get(), &configuration_};
};

}  // namespace

std::unique_ptr<Simulation> start_bullet(BulletSolver solver, const Scene& scene, double dt,
                                         const Parameters& parameters) {
  return std::make_unique<BulletSimulation>(solver, scene, dt, parameters);
}

}  // namespace rockstack
