#include "tests/engines/linked_engines.hpp"

#include <utility>

#include "engines/scene_setup.hpp"

namespace rockstack {

#define ENGINE(name) std::vector<Engine> make_##name();
ROCKSTACK_LINKED_ENGINES
#undef ENGINE

namespace {

std::vector<Engine> make_engines() {
  std::vector<Engine> list;
#define ENGINE(name) \
  for (Engine & engine : make_##name()) list.push_back(std::move(engine));
  ROCKSTACK_LINKED_ENGINES
#undef ENGINE
  return list;
}

}  // namespace

const std::vector<const Engine*>& linked_engines() {
  static const std::vector<Engine> engines = make_engines();
  static const std::vector<const Engine*> list = [] {
    std::vector<const Engine*> pointers;
    for (const Engine& engine : engines) pointers.push_back(&engine);
    return pointers;
  }();
  return list;
}

std::unique_ptr<Simulation> start(const Engine& engine, const Scene& scene, double dt,
                                  const Parameters& parameters) {
  return engine.start(set_up(scene, dt, parameters), parameters);
}

EngineRun simulate(const Engine& engine, const Scene& scene, double dt, const Parameters& parameters,
                   bool bodies) {
  const Setup setup = set_up(scene, dt, parameters);
  return engine_run_of(scene, setup, run(engine, setup, parameters, needs_bodies(scene, bodies)), bodies);
}

}  // namespace rockstack
