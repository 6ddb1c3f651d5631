#pragma once

#include <string>
#include <vector>

#include "comparisons/measures/verdict/agreement.hpp"

namespace rockstack {

/// What the rows of one scene come to: the exact motion, until when it can be predicted, who is nearest and
/// by how much, until when engines agree, what happens otherwise, the first impact, slips, sequences of
/// impacts, what distributions tell beyond the horizon, and what failed. A sentence each.
std::vector<std::string> scene_sentences(const std::vector<ReplicatedRow>& rows, const JudgedScene& scene);

}  // namespace rockstack
