#pragma once

#include "comparisons/measures/results/run_metrics.hpp"

namespace rockstack {

/// What happens in runs of a row and not in the exact motion.
struct RowEvent {
  /// From the gravest on.
  enum class Kind {
    fails,   ///< a replicate; the row is done
    falls,   ///< or topples
    stands,  ///< where the exact motion falls
    ends,    ///< by a fall, where the exact motion leans past balance as the scene ends
    thrown,  ///< up, by m
    leaves,  ///< the plane, by m at its centre or its ends
    shifts,  ///< and rests, m off
    sinks,   ///< in, by m, to the end
    hovers,  ///< at rest, m high
    creeps,  ///< to the end, m/s
    turns,   ///< to the end, rad/s
    dips,    ///< sinks in for a moment, by m
    moves,   ///< for a while where the exact motion rests, by m
  };
  Kind kind{};
  std::string text = {};  ///< a verb with what it needs, and in how many replicates: "sinks in by 86 mm"
  double most = 0;        ///< of all runs in which it happens
};

/// A row of a comparison with what stands behind its median.
struct ReplicatedRow : RunMetrics {
  std::vector<double> errors = {};  ///< of the nominal run and each replicate; infinite where one is not done
  /// Largest angles over the whole scene, of those that are done and of the exact motions of their scenes,
  /// rad.
  std::vector<double> peaks = {}, exact_peaks = {};
  std::vector<RowEvent> events = {};  ///< from the gravest on
};

/// A solver with one set of its parameters among others, over scenes and steps.
struct RankedSet {
  std::string engine, solver, settings;
  int rank = 0;      ///< one more than there are sets that are nearer and told apart from it
  double score = 0;  ///< geometric mean, over scenes and steps, of its error over the least of all sets
  double worst = 0;  ///< the largest of those ratios
  int cells = 0;     ///< scenes and steps that count
  int failed = 0;    ///< of those, where its run is not done: each counts as a hundred times the least
};

/// An object with the names above; and back.
void to_json(Json& json, const RankedSet& set);
void from_json(const Json& json, RankedSet& set);

/// The level of the tests that tell sets apart: of replicates of two sets, by their ranks within each scene
/// and step that both have (mann_whitney()). It is that of all pairs together (adjust()): of sets that are
/// alike one is called nearer than another at most so often, however many there are.
inline constexpr double separation_level = 0.05;

/// Up to what extent of its exact motion a scene is at rest (RunMetrics::motion).
inline constexpr double rest_extent = 1e-6;

/// True for an engine's row of a scene that moves: of one at rest errors of angles are rounding.
bool can_be_ranked(const RunMetrics& row);

/// Rows without those of a single run where others have replicates: the error of one run is chance, and by it
/// nothing is told apart. A run that is not done stays.
std::vector<ReplicatedRow> rows_that_count(std::vector<ReplicatedRow> rows);

/// The least number of replicates, five or more, with which each pair of so many sets can be told apart: of n
/// replicates that lie apart at so many steps, at one by chance in 2 of (2n)!/n!² cases; and with which
/// another comparison like it can show a change of each set.
int replicates_that_tell_apart(std::size_t sets, std::size_t steps);

/// The chance that two comparisons of the same engines are told to differ in anything.
inline constexpr double change_level = 0.01;

/// The share of it for what counts most, such as the error; the other half is that of all other numbers.
inline constexpr double foremost_share = 0.5;

/// Sets, with so many replicates in each of their rows, of which two comparisons could show a change:
/// one of every replicate of a set, in its rows together or in one of them, at a level over all sets and
/// rows. A row of one run shows nothing.
std::vector<bool> sets_that_can_change(const std::vector<std::vector<int>>& sets, double level);

/// The least number of replicates in every row with which those are all sets that have so many rows each.
int replicates_that_show_changes(const std::vector<std::size_t>& rows_of_sets, double level);

/// The least number of replicates with which any of so many numbers of two comparisons is shown to have
/// changed where it lies apart, each tested by itself, at the share of the level that is not the foremost
/// one's.
int replicates_that_decide(std::size_t numbers, double level);

/// Ranks all sets of all solvers among the rows, best first: by their scores, over the scenes and steps where
/// one of them is done and the scene is not at rest, of rows_that_count(). Rows of failed runs count where
/// another of their scene moves.
std::vector<RankedSet> rank_all(const std::vector<ReplicatedRow>& rows);

/// Ranks sets within every solver that has several.
std::vector<RankedSet> rank_sets(const std::vector<ReplicatedRow>& rows);

/// engine,solver,rank,settings,score,worst,cells,failed.
std::string ranking_csv(const std::vector<RankedSet>& sets);

}  // namespace rockstack
