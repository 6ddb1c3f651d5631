#pragma once

#include <vector>

#include "comparisons/measures/metrics/impacts.hpp"

namespace rockstack {

/// How many impacts match that have nothing to do with the exact motion: medians over draws.
struct ChanceMatches {
  int random = 0;   ///< the engine's impacts, each at a time drawn anew from the whole duration
  int shifted = 0;  ///< the engine's impacts, all of them later by the same time, drawn from a tenth of the
                    ///< duration to nine tenths; those that pass the end start over
};

/// Precondition: as many windows as exact impacts.
ChanceMatches chance_matches(const std::vector<ImpactTime>& exact, const std::vector<ImpactTime>& engine,
                             const std::vector<double>& windows, double duration);

}  // namespace rockstack
