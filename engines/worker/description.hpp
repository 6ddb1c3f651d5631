#pragma once

#include <vector>

#include "engines/worker/request.hpp"

namespace rockstack {

/// Checks what a worker says of its engines, which goes into file names, tables and pages.
/// @throws std::runtime_error naming what is wrong, with its value and what is allowed.
void check_descriptions(const std::vector<EngineDescription>& engines);

}  // namespace rockstack
