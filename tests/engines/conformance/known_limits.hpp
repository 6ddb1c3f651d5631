#pragma once

#include <string>

#include "engines/engine.hpp"

namespace rockstack {

/// Why an engine with a parameter set cannot pass a check, or an empty text.
std::string known_limit(const Engine& engine, const std::string& settings, const std::string& check);

}  // namespace rockstack
