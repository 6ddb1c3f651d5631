#pragma once

#include "comparisons/measures/statistics/distributions.hpp"
#include "comparisons/measures/statistics/fits.hpp"
#include "comparisons/measures/statistics/ranking.hpp"

namespace rockstack {

/// A scene that rows are of, and what they are held against.
struct JudgedScene {
  std::string name = {};
  double least_height = 1;  ///< of its blocks, m
  double duration = 0;      ///< s
  double tolerance = 0.01;  ///< rad, and as a share of the least block height
};

/// "block 2 at 0.4 s", as rows tell a fall, with the verb between.
std::string with_verb(const std::string& block_and_time, const std::string& verb);

/// The time in that, s.
double end_time(const std::string& block_and_time);

/// True for a run of an engine, not of the exact solver in another way.
bool is_engine(const RunMetrics& row);

/// "ode:step (tuned)".
std::string set_name(const std::string& engine, const std::string& solver, const std::string& settings);

/// Name of a row's set, or of what else has these members.
template <class Set>
std::string set_name(const Set& set) {
  return set_name(set.engine, set.solver, set.settings);
}

/// Whether neither an angle nor a centre is off by more than the tolerance before the horizon.
bool agrees(const RunMetrics& row, const JudgedScene& scene);

/// Until when neither is, s; the horizon where the row agrees.
double agreement_end(const RunMetrics& row, const JudgedScene& scene);

/// What happens in a row's runs, the nominal one first, that does not in the exact motion: "block 2 has
/// fallen off at 0.4 s", "is thrown up by 250 mm to 1 m in 4 of 5 replicates"; from the gravest on.
std::vector<RowEvent> events_of(const std::vector<RunMetrics>& runs, const JudgedScene& scene);

/// What becomes of a row's runs, the nominal one first, in words: "agrees until 1.2 s; creeps at 2 mm/s to
/// the end", "rests, but sinks in by 86 mm", "failed: …".
std::string outcome(const std::vector<RunMetrics>& runs, const JudgedScene& scene);

std::vector<ReplicatedRow> rows_of(std::vector<ReplicatedRow> rows, const JudgedScene& scene);

/// Until when engines agree with the exact motion, from coarse steps to fine ones, in a sentence; empty where
/// no row moves. At most three steps are told.
std::string agreement_sentence(const std::vector<ReplicatedRow>& rows,
                               const std::vector<JudgedScene>& scenes);

/// What happens in engines and not in the exact motion, in a sentence, one set once at the step at which it
/// errs most; of more than `most` sets how many they are. Empty where nothing happens.
std::string event_sentence(const std::vector<ReplicatedRow>& rows, std::size_t most);

/// Which sets are nearest to the exact motion, in a sentence that says in which scenes, and calls one nearer
/// than another only where replicates tell them apart. Up to three scenes are told one by one, more by the
/// ranking over all. Empty where nothing can be ranked. `scenes`: in the order to be told.
std::string nearest_sentence(const std::vector<ReplicatedRow>& rows, const std::vector<JudgedScene>& scenes);

/// "7 impacts and 3 in chatter, too slow to be compared, the first at 0.319 s and 3.13 m/s" of an exact row.
std::string impacts_text(const RunMetrics& exact);

/// What a comparison comes to, in sentences: the only place where they are made.
struct ComparisonVerdict {
  /// Three at most: until when engines agree, what happens in them that does not exactly, and which sets are
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

/// Verdict on all rows, with the scenes that they are of. Nothing is said of histories beyond a scene's
/// horizon; there distributions over replicates are compared. No row is called nearer than another that
/// replicates do not tell from it, and scenes at rest are not ranked.
ComparisonVerdict verdict_of(const ComparisonEvidence& evidence, const std::vector<JudgedScene>& scenes);

/// The verdict that verdict_json() has told, scenes in the order of the list.
ComparisonVerdict verdict_from(const Json& json);

Json verdict_json(const ComparisonVerdict& verdict, const std::vector<JudgedScene>& scenes);

}  // namespace rockstack
