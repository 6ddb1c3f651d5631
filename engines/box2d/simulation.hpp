#pragma once

#include <memory>

#include "engines/engine.hpp"

namespace rockstack {

/// A scene inside Box2D. Precondition: `parameters` are checked.
std::unique_ptr<Simulation> start_box2d(const Setup& setup, const Parameters& parameters);

}  // namespace rockstack
