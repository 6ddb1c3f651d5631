#pragma once

#include <optional>

#include "analytic/scene/history.hpp"
#include "analytic/scene/scene.hpp"

namespace rockstack {

/// A block, from 1, that topples or falls off, and when, s.
struct Toppling {
  int block = 0;
  double time = 0;
};

/// The end of a motion, as its last event or else its last sample tells it.
std::optional<Toppling> toppling_of(const Scene& scene, const History& history);

/// "block 2 at 1.5 s" where a solver's history ends so, or nothing.
std::string reported_toppling(const History& history);

/// Toppling of an engine's history, which ends early only where a block has toppled: the block and the time
/// are those of its last sample.
std::string observed_toppling(const Scene& scene, const History& history);

/// Which of both topple.
enum class TopplingVerdict { unknown, neither, both, exact_alone, engine_alone };

TopplingVerdict toppling_verdict(bool exact, bool engine);

/// "neither", "both", "exact alone", "engine alone"; empty where it is unknown.
std::string name(TopplingVerdict verdict);

/// The verdict of that name, unknown where there is none.
TopplingVerdict named_verdict(const std::string& name);

/// True where one of both topples and the other does not.
bool differ(TopplingVerdict verdict);

}  // namespace rockstack
