#pragma once

#include <string>

#include "analytic/scene/history.hpp"
#include "analytic/scene/scene.hpp"

namespace rockstack {

/// "block 2 at 1.5 s" where a solver's history ends so, or nothing.
std::string reported_toppling(const History& history);

/// The same of an engine's history, which ends early only where a block has toppled: the block and the time
/// are those of its last sample.
std::string observed_toppling(const Scene& scene, const History& history);

/// Which of both topple: "neither", "both", "engine alone" or "exact alone".
std::string toppling_verdict(bool exact, bool engine);

}  // namespace rockstack
