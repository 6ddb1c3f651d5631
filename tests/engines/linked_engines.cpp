#include "tests/engines/linked_engines.hpp"

#include <utility>

#include "engines/scene_setup.hpp"
#ifdef ROCKSTACK_WITH_BULLET
#include "engines/bullet/bullet.hpp"
#endif
#ifdef ROCKSTACK_WITH_DART
#include "engines/dart/dart.hpp"
#endif
#ifdef ROCKSTACK_WITH_MUJOCO
#include "engines/mujoco/mujoco.hpp"
#endif
#ifdef ROCKSTACK_WITH_ODE
#include "engines/ode/ode.hpp"
#endif
#ifdef ROCKSTACK_WITH_BOX2D
#include "engines/box2d/box2d.hpp"
#endif
#ifdef ROCKSTACK_WITH_CHIPMUNK
#include "engines/chipmunk/chipmunk.hpp"
#endif
#ifdef ROCKSTACK_WITH_SICONOS
#include "engines/siconos/siconos.hpp"
#endif
#ifdef ROCKSTACK_WITH_SIMBODY
#include "engines/simbody/simbody.hpp"
#endif

namespace rockstack {
namespace {

std::vector<std::unique_ptr<Engine>> make_engines() {
  std::vector<std::unique_ptr<Engine>> list;
#ifdef ROCKSTACK_WITH_BULLET
  for (auto& engine : make_bullet()) list.push_back(std::move(engine));
#endif
#ifdef ROCKSTACK_WITH_DART
  for (auto& engine : make_dart()) list.push_back(std::move(engine));
#endif
#ifdef ROCKSTACK_WITH_MUJOCO
  for (auto& engine : make_mujoco()) list.push_back(std::move(engine));
#endif
#ifdef ROCKSTACK_WITH_ODE
  for (auto& engine : make_ode()) list.push_back(std::move(engine));
#endif
#ifdef ROCKSTACK_WITH_BOX2D
  for (auto& engine : make_box2d()) list.push_back(std::move(engine));
#endif
#ifdef ROCKSTACK_WITH_CHIPMUNK
  for (auto& engine : make_chipmunk()) list.push_back(std::move(engine));
#endif
#ifdef ROCKSTACK_WITH_SICONOS
  for (auto& engine : make_siconos()) list.push_back(std::move(engine));
#endif
#ifdef ROCKSTACK_WITH_SIMBODY
  for (auto& engine : make_simbody()) list.push_back(std::move(engine));
#endif
  return list;
}

}  // namespace

const std::vector<std::unique_ptr<Engine>>& linked_engines() {
  static const std::vector<std::unique_ptr<Engine>> list = make_engines();
  return list;
}

std::unique_ptr<Simulation> start(const Engine& engine, const Scene& scene, double dt,
                                  const Parameters& parameters) {
  return engine.start(set_up(scene, dt, parameters), parameters);
}

}  // namespace rockstack
