#pragma once

#include <memory>
#include <vector>

#include "engines/engine.hpp"

namespace rockstack {

/// Chipmunk2D with its only solver, "sequential-impulse" (cpSpaceStep).
std::vector<std::unique_ptr<Engine>> make_chipmunk();

}  // namespace rockstack
