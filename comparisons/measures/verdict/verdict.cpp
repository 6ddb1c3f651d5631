#include "comparisons/measures/verdict/verdict.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <iterator>
#include <nlohmann/json.hpp>

#include "analytic/scene/messages/number_text.hpp"
#include "comparisons/measures/results/sentences.hpp"
#include "comparisons/measures/verdict/nearest.hpp"
#include "comparisons/measures/verdict/perturbed.hpp"
#include "comparisons/measures/verdict/scene_sentences.hpp"

namespace rockstack {
namespace {

using Json = nlohmann::ordered_json;

std::vector<std::string> names_of(const std::vector<JudgedScene>& scenes) {
  std::vector<std::string> names;
  names.reserve(scenes.size());
  for (const JudgedScene& scene : scenes) names.push_back(scene.name);
  return names;
}

std::vector<RunMetrics> row_list(const std::vector<ReplicatedRow>& rows) {
  std::vector<RunMetrics> list;
  list.reserve(rows.size());
  for (const ReplicatedRow& one : rows) list.push_back(one.row);
  return list;
}

/// Scenes in which nothing moves, where what happens in engines is all there is to tell.
std::string rest_sentence(const std::vector<ReplicatedRow>& rows, const std::vector<JudgedScene>& scenes) {
  std::vector<std::string> at_rest;
  for (const JudgedScene& scene : scenes) {
    const bool rests = std::any_of(rows.begin(), rows.end(), [&](const ReplicatedRow& one) {
      return one.row.scene == scene.name && one.row.motion && *one.row.motion <= rest_extent;
    });
    if (rests) at_rest.push_back(scene.name);
  }
  return at_rest.empty() ? "" : fmt::format("Nothing moves in {}, where no set is ranked.", joined(at_rest));
}

/// Two sentences as one.
std::string together(const std::string& first, std::string second) {
  if (first.empty() || second.empty()) return first + second;
  second.front() = static_cast<char>(std::tolower(static_cast<unsigned char>(second.front())));
  return first.substr(0, first.size() - 1) + "; " + second;
}

/// What was asked of perturbed scenes comes first.
std::vector<std::string> headline_of(const ComparisonEvidence& evidence,
                                     const std::vector<JudgedScene>& scenes) {
  constexpr std::size_t most_events = 2;
  const auto& rows = evidence.rows;
  std::vector<std::string> sentences;
  sentences.reserve(scenes.size() + 2);
  for (const JudgedScene& scene : scenes)
    sentences.push_back(toppling_sentence(evidence.distances, row_list(rows), scene.name));
  sentences.push_back(together(agreement_sentence(rows, scenes), event_sentence(rows, scenes, most_events)));
  sentences.push_back(together(nearest_sentence(rows, names_of(scenes)), rest_sentence(rows, scenes)));
  std::erase(sentences, "");
  sentences.resize(std::min<std::size_t>(sentences.size(), 2));
  return sentences;
}

/// Of a scene that is alone the headline has said what all scenes come to.
std::vector<std::string> sentences_of(const ComparisonEvidence& evidence, const JudgedScene& scene,
                                      bool alone) {
  std::vector<ReplicatedRow> own;
  std::copy_if(evidence.rows.begin(), evidence.rows.end(), std::back_inserter(own),
               [&](const ReplicatedRow& one) { return one.row.scene == scene.name; });
  std::vector<std::string> sentences = scene_sentences(own, scene);
  if (!alone)
    sentences.insert(sentences.begin() + 1,
                     {agreement_sentence(own, {scene}), nearest_sentence(own, {scene.name})});
  sentences.push_back(toppling_sentence(evidence.distances, row_list(own), scene.name));
  sentences.push_back(convergence_sentence(evidence.fits, scene.name));
  std::erase(sentences, "");
  return sentences;
}

}  // namespace

ComparisonVerdict verdict_of(const ComparisonEvidence& evidence, const std::vector<JudgedScene>& scenes) {
  ComparisonVerdict verdict{headline_of(evidence, scenes), {}, rank_all(evidence.rows)};
  for (const JudgedScene& scene : scenes)
    verdict.scenes.push_back(sentences_of(evidence, scene, scenes.size() == 1));
  return verdict;
}

std::string ranking_definition() {
  return fmt::format(
      "rows are ranked by `error`, up to the horizon of each scene: each over the least of its scene and step, "
      "then the geometric mean over scenes and steps; scenes at rest are left out. A set is called nearer than "
      "another only where Mann–Whitney tests of replicates, by ranks within each scene and step, show it at a "
      "level of {:g} % over all pairs (Holm). A rank is one more than the number of sets that are so",
      100 * separation_level);
}

ComparisonVerdict verdict_from(const Json& json) {
  ComparisonVerdict verdict{json.at("headline").get<std::vector<std::string>>(), {}, {}};
  for (const Json& scene : json.at("scenes"))
    verdict.scenes.push_back(scene.at("sentences").get<std::vector<std::string>>());
  for (const Json& set : json.at("ranking"))
    verdict.ranking.push_back({set.at("engine").get<std::string>(), set.at("solver").get<std::string>(),
                               set.at("settings").get<std::string>(), set.at("rank").get<int>(),
                               set.at("score").get<double>(), set.at("worst").get<double>(),
                               set.at("cells").get<int>(), set.at("failed").get<int>()});
  return verdict;
}

Json verdict_json(const ComparisonVerdict& verdict, const std::vector<JudgedScene>& scenes) {
  Json json{{"headline", verdict.headline}, {"scenes", Json::array()}, {"ranking", Json::array()}};
  for (std::size_t i = 0; i < scenes.size(); ++i)
    json["scenes"].push_back({{"name", scenes[i].name}, {"sentences", verdict.scenes[i]}});
  for (const RankedSet& set : verdict.ranking)
    json["ranking"].push_back({{"rank", set.rank},
                               {"engine", set.engine},
                               {"solver", set.solver},
                               {"settings", set.settings},
                               {"score", set.score},
                               {"worst", set.worst},
                               {"cells", set.cells},
                               {"failed", set.failed}});
  json["ranking_definition"] = ranking_definition();
  return json;
}

}  // namespace rockstack
