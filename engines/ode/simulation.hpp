#pragma once

#include "engines/engine.hpp"

namespace rockstack {

enum class OdeSolver { step, quickstep };

/// A scene inside ODE. Precondition: `parameters` are checked.
/// @throws std::runtime_error where the library cannot be initialised, or with its own error.
std::unique_ptr<Simulation> start_ode(OdeSolver solver, const Setup& setup, const Parameters& parameters);

}  // namespace rockstack
