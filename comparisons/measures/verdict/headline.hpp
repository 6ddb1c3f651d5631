#pragma once

#include <string>
#include <vector>

#include "comparisons/measures/statistics/ranking.hpp"
#include "comparisons/measures/verdict/outcome.hpp"

namespace rockstack {

/// A scene that rows are of.
struct JudgedScene {
  std::string name;
  SceneScale scale;
};

std::vector<ReplicatedRow> rows_of(const std::vector<ReplicatedRow>& rows, const JudgedScene& scene);

/// Until when engines agree with the exact motion, from coarse steps to fine ones, in a sentence; empty where
/// no row moves. At most three steps are told.
std::string agreement_sentence(const std::vector<ReplicatedRow>& rows,
                               const std::vector<JudgedScene>& scenes);

/// What happens in engines and not in the exact motion, in a sentence, one set once at the step at which it
/// errs most; of more than `most` sets how many they are. Empty where nothing happens.
std::string event_sentence(const std::vector<ReplicatedRow>& rows, const std::vector<JudgedScene>& scenes,
                           std::size_t most);

/// Which sets are nearest to the exact motion, in a sentence that says in which scenes, and calls one nearer
/// than another only where replicates tell them apart. Up to three scenes are told one by one, more by the
/// ranking over all. Empty where nothing can be ranked. `scenes`: in the order to be told.
std::string nearest_sentence(const std::vector<ReplicatedRow>& rows, const std::vector<JudgedScene>& scenes);

}  // namespace rockstack
