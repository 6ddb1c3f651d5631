#pragma once

#include <memory>

#include "engines/engine.hpp"

namespace rockstack {

/// A scene inside Chipmunk. Precondition: `parameters` are checked.
std::unique_ptr<Simulation> start_chipmunk(const Setup& setup, const Parameters& parameters);

}  // namespace rockstack
