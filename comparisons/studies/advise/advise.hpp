#pragma once

#include "comparisons/measures/statistics/distributions.hpp"
#include "comparisons/suites/suite.hpp"

namespace rockstack {

/// What is wanted of an engine.
struct AdviceRequest {
  /// Largest difference from the exact motion: of any angle, rad, and of any centre, as a share of the least
  /// block height; > 0.
  double error = 1e-3;
  double within = 60;                             ///< for the whole search, s of wall time, > 0
  std::vector<const WorkerEngine*> engines = {};  ///< that are tried, with their tuned sets
  Limits limits = {};                             ///< of each run
  int repeats = 3;                                ///< timed runs
  /// What must come within the error, nine replicates of ten each: at steps up to a quarter longer and
  /// shorter, and again about the step itself, so that none is taken for the luck of being tried often.
  Replicates replicates = {.runs = 21, .steps = 0.25};
  Replicates confirming = {.runs = 21, .seed = 2};
};

/// The share of replicates that must come within the error.
inline constexpr double passing_share = 0.9;

/// A solver at a step.
struct Trial {
  RunMetrics row;  ///< medians, where replicates were made
  int within = 0;  ///< replicates within the error; of one, the nominal run, where that misses it
  int replicates = 1;
  int confirmed = 0;   ///< confirming replicates within the error
  int confirming = 0;  ///< made where those before pass

  bool passes() const {
    return within >= passing_share * replicates && confirmed >= passing_share * confirming;
  }
};

/// A solver whose finer steps were not tried: they would have taken longer than was left.
struct SkippedTrial {
  const WorkerEngine* engine = nullptr;
  double below = 0;  ///< the finest step that was tried, s
};

/// The answer: all trials, in their order, and the one to take.
struct Advice {
  std::vector<Trial> trials;
  int pick = -1;  ///< of trials; −1: none passes
  std::vector<SkippedTrial> untried;
  /// Until when histories can be compared at all, s (job.hpp). Trials end there.
  double predictable_time = 0;
  /// Distances of the pick's replicates over the whole scene, where it lasts longer than it can be predicted
  /// and there is time for them; else empty.
  std::vector<DistributionDistance> beyond;
};

/// What is told of a search while it goes on.
struct AdviceListener {
  /// A trial that is begun: of which series, at which step, s, and how long the search has taken, s.
  std::function<void(const EngineSeries&, double dt, double elapsed)> begin = [](auto&&...) {};
  std::function<void(const Trial&)> trial = [](auto&&...) {};  ///< that is done
};

/// True where a run is done, topples as the exact solution does, and stays within the error by angles and
/// centres.
bool meets(const RunMetrics& row, double error);

/// The trial that passes with the least time of stepping; −1 where there is none.
int cheapest(const std::vector<Trial>& trials);

/// Tries every solver with its tuned parameters from large to small steps until it passes, takes longer than
/// the cheapest that did, or would take longer than the time that is left: a step of half the length twice as
/// long as the one before, replicates as long as the run before them. All are tried at the largest step; then
/// always the one goes on that would take least time at the error, if that fell in proportion to the step.
/// Writes FOLDER/runs/, FOLDER/advice.json and, of its trials, FOLDER/advice.csv: the columns of
/// comparison.csv and how many replicates came within the error.
/// @throws std::runtime_error where a file cannot be written or
/// the scene has no exact solution.
Advice advise(const NamedScene& scene, const AdviceRequest& request, const std::filesystem::path& folder,
              const std::string& command, const AdviceListener& listener = {});

/// In words: what to take, how sure it is, which cheaper trial cannot be told from it, until when it holds of
/// a scene that lasts `duration` s, and what was not tried.
std::vector<std::string> advice_sentences(const AdviceRequest& request, const Advice& advice,
                                          double duration);

/// All of it: its words, what was asked for, the pick, what was not tried and the trials.
Json advice_json(const NamedScene& scene, const AdviceRequest& request, const Advice& advice,
                 const std::string& command);

}  // namespace rockstack
