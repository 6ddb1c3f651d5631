#include "engines/worker/pace.hpp"

#include <algorithm>

namespace rockstack {

WorkerPace pace_of(const WorkerEngine& engine, const Parameters& parameters, const Limits& limits) {
  Scene scene;
  scene.duration = 0.1;
  scene.blocks = {make_block(1, 1, 2500)};
  scene.initial = {{0}, {0}};
  const WorkerRun run = run_in_worker(engine, scene, 1e-3, parameters, 1, limits, true);
  if (run.status != "done" || run.seconds.empty()) return {};
  const auto steps = static_cast<double>(run.run.history.size() - 1);
  return {std::max(0.0, run.processor_time - 2 * run.seconds.front()), run.seconds.front() / steps};
}

}  // namespace rockstack
