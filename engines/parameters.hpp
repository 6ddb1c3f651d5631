#pragma once

#include <span>
#include <string>

#include "engines/engine.hpp"

namespace rockstack {

/// One setting of an engine: its own name for it, what the engine starts with, what suits rocking blocks
/// best, and the range an adapter takes.
struct Setting {
  const char* name;
  double standard;
  double tuned;
  double least;
  double most;
  bool whole = false;  ///< only whole numbers
};

Parameters standard_values(std::span<const Setting> settings);
Parameters tuned_values(std::span<const Setting> settings);

/// Checks what Engine::start was given.
/// @throws std::invalid_argument naming the engine, the setting, its value and what is allowed: unknown,
/// missing or out of range; dt not finite or ≤ 0.
void check(const std::string& engine, std::span<const Setting> settings, const Parameters& given, double dt);

}  // namespace rockstack
