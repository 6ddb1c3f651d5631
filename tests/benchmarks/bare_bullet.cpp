#include <btBulletDynamicsCommon.h>

#include <chrono>
#include <memory>
#include <vector>

#include "engines/scene_setup.hpp"
#include "tests/benchmarks/bare_loops.hpp"
#include "tests/free_rocking.hpp"

namespace rockstack {
namespace {

/// A body with its shape; friction is what Bullet's clamp leaves of the scene's.
struct Body {
  std::unique_ptr<btBoxShape> shape;
  std::unique_ptr<btRigidBody> body;
};

Body make_body(const btVector3& half, double mass, const btVector3& inertia, const btTransform& place) {
  Body made{std::make_unique<btBoxShape>(half), nullptr};
  btRigidBody::btRigidBodyConstructionInfo info(mass, nullptr, made.shape.get(), inertia);
  info.m_startWorldTransform = place;
  info.m_friction = 31.6;
  made.body = std::make_unique<btRigidBody>(info);
  return made;
}

Body make_block_body(const Placement& block) {
  Body made = make_body({0.5 * block.width, 0.5 * block.height, 0.5 * block.depth}, block.mass,
                        {block.inertia_about_x, block.inertia_about_y, block.inertia},
                        btTransform(btQuaternion(btVector3(0, 0, 1), -block.angle), {block.x, block.y, 0}));
  made.body->setLinearFactor({1, 1, 0});
  made.body->setAngularFactor({0, 0, 1});
  made.body->setActivationState(DISABLE_DEACTIVATION);
  return made;
}

}  // namespace

double bare_bullet_seconds(double dt, int steps) {
  btDefaultCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher(&configuration);
  btDbvtBroadphase broadphase;
  btSequentialImpulseConstraintSolver solver;
  std::vector<Body> bodies;
  btDiscreteDynamicsWorld world(&dispatcher, &broadphase, &solver, &configuration);
  world.setGravity({0, -9.81, 0});
  world.getSolverInfo().m_numIterations = 50;
  world.getSolverInfo().m_splitImpulsePenetrationThreshold = 0;
  bodies.push_back(
      make_body({60, 60, 60}, 0, {0, 0, 0}, btTransform(btQuaternion::getIdentity(), {0, -60, 0})));
  for (const Placement& placement : place(free_rocking(2))) bodies.push_back(make_block_body(placement));
  for (const Body& body : bodies) world.addRigidBody(body.body.get());
  const auto start = std::chrono::steady_clock::now();
  for (int step = 0; step < steps; ++step) world.stepSimulation(dt, 0);
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace rockstack
