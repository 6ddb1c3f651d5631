#pragma once

#include <nlohmann/json_fwd.hpp>

#include "analytic/scene/scene.hpp"

namespace rockstack {

/// What results say of a scene as it was run, overrides included: title, blocks, gravity, duration, what
/// moves the ground, the law, and the speed and time below which impacts are chatter. SI units.
nlohmann::ordered_json scene_json(const Scene& scene);

}  // namespace rockstack
