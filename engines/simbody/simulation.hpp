#pragma once

#include <memory>

#include "engines/engine.hpp"
#include "engines/simulation.hpp"

namespace rockstack {

/// A stack inside Simbody. Precondition: `parameters` are checked. Its headers are C++17: as C++20 their
/// comparisons are ambiguous. So this header is C++17 as well.
/// @throws std::exception with the library's own error, as all functions of the simulation do.
std::unique_ptr<Simulation> start_simbody(const Setup& setup, const Parameters& parameters);

}  // namespace rockstack
