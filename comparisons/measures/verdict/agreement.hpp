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

/// Until when engines agree with the exact motion, from coarse steps to fine ones, in a sentence; empty where
/// no row moves. At most three steps are told.
std::string agreement_sentence(const std::vector<ReplicatedRow>& rows,
                               const std::vector<JudgedScene>& scenes);

/// What happens in engines and not in the exact motion, in a sentence, one set once at the step at which it
/// errs most; of more than `most` sets how many they are. Empty where nothing happens.
std::string event_sentence(const std::vector<ReplicatedRow>& rows, const std::vector<JudgedScene>& scenes,
                           std::size_t most);

}  // namespace rockstack
