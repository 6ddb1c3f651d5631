#pragma once

#include <string>
#include <vector>

#include "comparisons/measures/verdict/agreement.hpp"

namespace rockstack {

/// What the rows of one scene come to beside what a headline says: the exact motion, what happens otherwise,
/// errors, the first impact, slips, sequences of impacts, what distributions tell beyond the horizon, and
/// what failed. A sentence each, empty where there is nothing to say.
std::vector<std::string> scene_sentences(const std::vector<ReplicatedRow>& rows, const JudgedScene& scene);

}  // namespace rockstack
