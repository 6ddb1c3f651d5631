#pragma once

#include <memory>
#include <vector>

#include "engines/engine.hpp"

namespace rockstack {

/// Box2D with its only solver, "sequential-impulse" (b2World::Step).
std::vector<std::unique_ptr<Engine>> make_box2d();

}  // namespace rockstack
