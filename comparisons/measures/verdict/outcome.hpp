#pragma once

#include <string>

#include "analytic/scene/scene.hpp"
#include "comparisons/measures/results/run_metrics.hpp"

namespace rockstack {

/// What a scene's rows are held against.
struct SceneScale {
  double least_height = 1;  ///< of its blocks, m
  double duration = 0;      ///< s
  double tolerance = 0.01;  ///< rad, and as a share of the least block height
};

SceneScale scale_of(const Scene& scene, double tolerance);

/// True for a run of an engine, not of the exact solver in another way.
bool is_engine(const RunMetrics& row);

/// "ode:step (tuned)".
std::string set_name(const std::string& engine, const std::string& solver, const std::string& settings);
std::string set_name(const RunMetrics& row);

/// Whether neither an angle nor a centre is off by more than the tolerance before the horizon.
bool agrees(const RunMetrics& row, const SceneScale& scale);

/// Until when neither is, s; the horizon where the row agrees.
double agreement_end(const RunMetrics& row, const SceneScale& scale);

/// What happens in a run that does not in the exact motion, as a verb with what it needs: "block 2 has fallen
/// off at 0.4 s", "sinks by 86 mm"; empty where nothing does.
std::string event_of(const RunMetrics& row, const SceneScale& scale);

/// What becomes of a run, in words: "agrees until 1.2 s", "rests, but sinks by 86 mm", "failed: …".
std::string outcome(const RunMetrics& row, const SceneScale& scale);

}  // namespace rockstack
