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

}  // namespace rockstack
