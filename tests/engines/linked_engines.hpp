#pragma once

#include <memory>
#include <vector>

#include "engines/engine.hpp"

namespace rockstack {

/// Every engine with every solver that is linked into this test program.
const std::vector<std::unique_ptr<Engine>>& linked_engines();

}  // namespace rockstack
