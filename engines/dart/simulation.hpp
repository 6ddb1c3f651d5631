#pragma once

#include <memory>
#include <string>

#include "engines/engine.hpp"

namespace rockstack {

enum class DartSolver { dantzig, pgs };

/// As DART's headers tell it.
std::string dart_version();

/// A scene inside DART. Precondition: `parameters` are checked.
std::unique_ptr<Simulation> start_dart(DartSolver solver, const Setup& setup, const Parameters& parameters);

}  // namespace rockstack
