#pragma once

#include <memory>
#include <vector>

#include "analytic/scene/scene.hpp"
#include "engines/body_record.hpp"
#include "engines/engine.hpp"

namespace rockstack {

/// Every engine with every solver that is linked into this test program.
const std::vector<const Engine*>& linked_engines();

/// A scene inside an engine of this process; dt in s.
std::unique_ptr<Simulation> start(const Engine& engine, const Scene& scene, double dt,
                                  const Parameters& parameters);

/// Runs a scene for its duration in this process; `bodies`: keeps a BodyRecord.
/// @throws as set_up() and run().
EngineRun simulate(const Engine& engine, const Scene& scene, double dt, const Parameters& parameters,
                   bool bodies = false);

}  // namespace rockstack
