#pragma once

#include <optional>
#include <vector>

#include "analytic/scene/history.hpp"
#include "analytic/scene/scene.hpp"
#include "comparisons/measures/metrics/impacts.hpp"

namespace rockstack {

/// When interfaces settle: an interface that has moved comes to stay within open_angle of closed, and slower
/// than chatter_speed(scene), for at least settling_duration(scene). All chatter of an interface is one
/// settling. In order of time.
std::vector<ImpactTime> settlings(const Scene& scene, const History& history);

/// Root of the mean square angular velocity of all blocks of `engine` over the last tenth of its time, rad/s;
/// nothing where `exact` is not at rest all that time. Precondition: the same times; `exact` knows its
/// patterns.
std::optional<double> residual_motion(const History& exact, const History& engine);

}  // namespace rockstack
