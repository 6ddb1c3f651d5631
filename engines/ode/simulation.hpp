#pragma once

#include "engines/engine.hpp"

namespace rockstack {

enum class OdeSolver { step, quickstep };

/// Makes ODE ready on this thread: its errors throw std::runtime_error, its messages are counted.
/// @throws std::runtime_error where that fails.
void initialise_ode();

/// How many messages ODE has given on this thread.
std::size_t ode_messages();

/// A scene inside ODE. Precondition: `parameters` are checked.
/// @throws std::runtime_error where the library cannot be initialised, or with its own error.
std::unique_ptr<Simulation> start_ode(OdeSolver solver, const Setup& setup, const Parameters& parameters);

}  // namespace rockstack
