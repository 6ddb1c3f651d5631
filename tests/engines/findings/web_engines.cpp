#include "tests/engines/findings/web_engines.hpp"

#include <fmt/format.h>

#include "engines/scene_setup.hpp"
#include "engines/worker/registry.hpp"
#include "tests/engines/bare.hpp"

namespace rockstack {

const WorkerEngine* there(const std::string& name) {
  for (const WorkerEngine& engine : engines())
    if (engine.full_name() == name) return &engine;
  return nullptr;
}

std::string moving_question(const WorkerEngine& engine, const Scene& scene, double dt,
                            const Parameters& parameters, const std::string& more) {
  const Placement block = set_up(scene, dt, parameters).blocks.at(0);
  return bare_question(engine, scene, dt, parameters) + fmt::format("moving {} {} {}\n{}\n", block.velocity_x,
                                                                    block.velocity_y, block.angular_velocity,
                                                                    more);
}

Scene block_held_by_friction() {
  Scene scene;
  scene.blocks = {make_block(1, 1, 2500)};
  scene.initial = {{0}, {0}};
  scene.friction = {0.5};
  scene.duration = 0.5;
  scene.horizontal.interval = 10;
  scene.horizontal.samples = {0.2 * scene.gravity, 0.2 * scene.gravity};
  return scene;
}

std::vector<double> borne(const WorkerEngine& engine, const Scene& scene, int what) {
  return bare_angles(engine.name, bare_question(engine, scene, 1e-3, engine.default_parameters()) +
                                      fmt::format("borne {}\n", what));
}

}  // namespace rockstack
