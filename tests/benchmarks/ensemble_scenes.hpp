#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "comparisons/studies/sweep/ensemble.hpp"

namespace rockstack::benchmarks {

/// The runs of a shipped ensemble over 20 s, the first 512 at most.
inline std::vector<Scene> ensemble_scenes(const std::string& name) {
  MotionLibrary library;
  const Ensemble ensemble = read_ensemble(ROCKSTACK_ENSEMBLES "/" + name + ".toml", {"duration=20"}, library);
  std::vector<Scene> scenes;
  SceneDocument document = ensemble.base;
  for (std::size_t run = 0; run < std::min<std::size_t>(run_count(ensemble), 512); ++run) {
    const auto values = values_of(ensemble, run);
    for (std::size_t v = 0; v < values.size(); ++v) set_values(document, ensemble.variations[v], values[v]);
    scenes.push_back(make_scene(document, library));
  }
  return scenes;
}

}  // namespace rockstack::benchmarks
