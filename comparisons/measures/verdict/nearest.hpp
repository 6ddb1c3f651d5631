#pragma once

#include <string>
#include <vector>

#include "comparisons/measures/statistics/ranking.hpp"

namespace rockstack {

/// Which sets are nearest to the exact motion, in a sentence that says in which scenes, and calls one nearer
/// than another only where replicates tell them apart. Up to three scenes are told one by one, more by the
/// ranking over all. Empty where nothing can be ranked. `scenes`: in the order to be told.
std::string nearest_sentence(const std::vector<ReplicatedRow>& rows, const std::vector<std::string>& scenes);

}  // namespace rockstack
