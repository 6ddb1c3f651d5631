#pragma once

#include <memory>

#include "engines/engine.hpp"

namespace rockstack {

/// The Open Dynamics Engine with its direct solver, dWorldStep (Dantzig's algorithm).
std::unique_ptr<Engine> make_ode();

}  // namespace rockstack
