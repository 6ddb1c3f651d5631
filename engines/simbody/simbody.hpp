#pragma once

#include <memory>
#include <vector>

#include "engines/engine.hpp"

namespace rockstack {

/// Simbody with its compliant contact: "compliant".
std::vector<std::unique_ptr<Engine>> make_simbody();

}  // namespace rockstack
