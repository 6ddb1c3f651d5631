#pragma once

#include "plots/pages/player_data.hpp"

namespace rockstack::plots {

// What the player needs of a motion that has just been computed; player_data.hpp has what it needs of
// results.

/// The scene, with the patterns and events of a motion of it where that is exact.
nlohmann::ordered_json stage_of(const Scene& scene, const History& history);

/// What interfaces carry at the samples of an exact motion.
InterfaceForces forces_of(const Scene& scene, const History& history);

}  // namespace rockstack::plots
