#include <ode/ode.h>

#include <array>
#include <chrono>

#include "engines/scene_setup.hpp"
#include "tests/benchmarks/bare_loops.hpp"
#include "tests/free_rocking.hpp"

namespace rockstack {
namespace {

struct Bare {
  dWorldID world;
  dJointGroupID group;
};

void touch(void* data, dGeomID one, dGeomID other) {
  const auto& bare = *static_cast<Bare*>(data);
  std::array<dContact, 8> contacts{};
  const int count = dCollide(one, other, 8, &contacts[0].geom, sizeof(dContact));
  for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
    contacts[i].surface.mode = dContactApprox1 | dContactFDir1 | dContactMu2;
    contacts[i].surface.mu = 1e3;
    contacts[i].fdir1[0] = contacts[i].geom.normal[1];
    contacts[i].fdir1[1] = -contacts[i].geom.normal[0];
    dJointAttach(dJointCreateContact(bare.world, bare.group, &contacts[i]), dGeomGetBody(one),
                 dGeomGetBody(other));
  }
}

void add_block(const Bare& bare, dSpaceID space, const Placement& placement) {
  const dBodyID body = dBodyCreate(bare.world);
  dMass mass;
  dMassSetParameters(&mass, placement.mass, 0, 0, 0, placement.inertia_about_x, placement.inertia_about_y,
                     placement.inertia, 0, 0, 0);
  dBodySetMass(body, &mass);
  dGeomSetBody(dCreateBox(space, placement.width, placement.height, placement.depth), body);
  dMatrix3 turn;
  dRFromAxisAndAngle(turn, 0, 0, 1, -placement.angle);
  dBodySetRotation(body, turn);
  dBodySetPosition(body, placement.x, placement.y, 0);
  dJointAttach(dJointCreatePlane2D(bare.world, nullptr), body, nullptr);
}

}  // namespace

double bare_ode_seconds(double dt, int steps) {
  dInitODE2(0);
  dAllocateODEDataForThread(dAllocateMaskAll);
  Bare bare{dWorldCreate(), dJointGroupCreate(0)};
  const dSpaceID space = dSimpleSpaceCreate(nullptr);
  dWorldSetERP(bare.world, 0.01);
  dWorldSetCFM(bare.world, 1e-10);
  dWorldSetGravity(bare.world, 0, -9.81, 0);
  dCreatePlane(space, 0, 1, 0, 0);
  for (const Placement& placement : place(free_rocking(2))) add_block(bare, space, placement);
  const auto start = std::chrono::steady_clock::now();
  for (int step = 0; step < steps; ++step) {
    dJointGroupEmpty(bare.group);
    dSpaceCollide(space, &bare, touch);
    dWorldStep(bare.world, dt);
  }
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  dJointGroupDestroy(bare.group);
  dSpaceDestroy(space);
  dWorldDestroy(bare.world);
  return seconds;
}

}  // namespace rockstack
