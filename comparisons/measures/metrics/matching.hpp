#pragma once

#include <vector>

#include "comparisons/measures/metrics/difference.hpp"
#include "comparisons/measures/metrics/impacts.hpp"

namespace rockstack {

/// How far apart in time an exact impact and an engine's may be and still be the same one, s, for each exact
/// impact: three steps, and the drift. A flight of duration T that ends at speed v is v τ (1 − τ/T) open the
/// time τ before, thus v τ/2 at least in its second half: where the angles of an interface that closes at v
/// differ by δ, its impacts are at most 2 δ/v apart. The drift takes the largest difference over the window
/// itself before the impact, so that it covers an engine that has impacted already. It never goes further
/// than half way to the next exact impact of the interface on either side. `apart`: of the engine from the
/// exact solution, at steps of `dt` s.
std::vector<double> matching_windows(const std::vector<ImpactTime>& exact, const Difference& apart,
                                     double dt);

/// The windows of an answer that does not drift: three steps each.
std::vector<double> still_windows(const std::vector<ImpactTime>& exact, double dt);

}  // namespace rockstack
