#pragma once

#include <memory>

#include "engines/engine.hpp"
#include "engines/simulation.hpp"

namespace rockstack {

/// A scene inside Siconos. Precondition: `parameters` are checked. This header is read by sources of C++17 as
/// well: Siconos's headers are no C++20.
std::unique_ptr<Simulation> start_siconos(const Setup& setup, const Parameters& parameters);

}  // namespace rockstack
