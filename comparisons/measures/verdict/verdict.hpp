#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "comparisons/measures/statistics/distributions.hpp"
#include "comparisons/measures/statistics/fits.hpp"
#include "comparisons/measures/verdict/outcome.hpp"

namespace rockstack {

/// What a comparison comes to, in sentences: the only place where they are made.
struct ComparisonVerdict {
  /// Two at most: until when engines agree, with what happens otherwise than exactly, and which sets are
  /// nearest in which scenes.
  std::vector<std::string> headline;
  /// One scene each, in their order.
  std::vector<std::vector<std::string>> scenes;
  std::vector<RankedSet> ranking;  ///< over all scenes that move
};

/// What a comparison is judged by.
struct ComparisonEvidence {
  std::vector<ReplicatedRow> rows;
  std::vector<SeriesFit> fits;
  std::vector<DistributionDistance> distances;
};

/// Of all rows, with the scenes that they are of. Nothing is said of histories beyond a scene's horizon;
/// there distributions over replicates are compared. No row is called nearer than another that replicates do
/// not tell from it, and scenes at rest are not ranked.
ComparisonVerdict verdict_of(const ComparisonEvidence& evidence, const std::vector<JudgedScene>& scenes);

/// How rows are ranked and told apart.
std::string ranking_definition();

/// The verdict that verdict_json() has told, scenes in the order of the list.
ComparisonVerdict verdict_from(const nlohmann::ordered_json& json);

nlohmann::ordered_json verdict_json(const ComparisonVerdict& verdict, const std::vector<JudgedScene>& scenes);

}  // namespace rockstack
