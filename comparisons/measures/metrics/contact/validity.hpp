#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "analytic/scene/history.hpp"
#include "analytic/scene/scene.hpp"

namespace rockstack {

/// What each interface has to bear, of a history that was solved with SolveOptions::validity: least normal
/// force (N) and impulse (N·s), largest ratio of tangential to normal, and when. Ratios that are infinite are
/// null.
nlohmann::ordered_json validity_json(const History& history);

/// One line for each interface and way in which real blocks would leave the model: it would have to pull, or
/// needs more friction than the scene has; and for what else makes an answer one of several: events in doubt,
/// openings to either side, impacts or modes that laws do not decide, springs that give way too far. Empty
/// where the model holds throughout.
std::vector<std::string> validity_warnings(const Scene& scene, const History& history);

}  // namespace rockstack
