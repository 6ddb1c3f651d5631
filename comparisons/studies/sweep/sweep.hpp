#pragma once

#include "comparisons/measures/statistics/sobol.hpp"
#include "comparisons/runs/execution/executor.hpp"
#include "comparisons/studies/sweep/run_columns.hpp"

namespace rockstack {

/// Writes the summaries that an ensemble asks for, from DIR/runs.csv or DIR/runs.npz alone, of which columns
/// of a few numbers a run are in memory. Runs that failed are counted and left out.
///
/// Where a sample is a row of Saltelli's design, its runs A and B alone are counted, which are independent of
/// each other.
///
/// By intensity:
/// - fragility.csv: the share of runs that topple at each intensity, its confidence bounds, and the fitted
///   lognormal curve, whose parameters are in fragility-fit.csv (no row where there is no fit);
/// - incremental.csv: peak angle over slenderness against intensity, a curve for each choice of all other
///   values; incremental-fractiles.csv: 16, 50 and 84 % of the curves at each intensity, a toppled block
///   counting as infinitely far. Only where some curve has two points.
/// By intensity and period:
/// - overturning.csv: how many runs stay at rest, rock, topple after an impact and topple without one.
/// By intensity and friction:
/// - modes.csv: how many runs begin in each mode of motion, as columns onset_*, and how many are all in all
///   of each.
/// Beside runs.npz the curves and both maps are .npz files too, and curves name a run's number in place of
/// its values.
///
/// By indices:
/// - indices.csv: of each outcome, at each intensity of a grid, the Sobol indices of the inputs that are
///   drawn.
///
/// Files of summaries that are not asked for are removed. @throws std::runtime_error where a file cannot be
/// written.
void write_summaries(const std::filesystem::path& folder, const SummaryKeys& keys);

/// What an input that is drawn has to do with an outcome, at one intensity of a grid.
struct InputIndices {
  std::optional<double> intensity;  ///< none: over all runs
  std::string outcome, key;         ///< a column of runs.csv; the input
  SobolIndices indices;
  double deviation = 0;      ///< of the outcome
  std::size_t samples = 0;   ///< that they are of
  std::size_t left_out = 0;  ///< samples with a run that failed or has no such outcome
};

/// From a folder's runs, in their order. Outcomes that are a block's number, toppled and falling, count as
/// whether there is one.
std::vector<InputIndices> input_indices(const std::filesystem::path& folder, const SummaryKeys& keys);

/// Writes indices.csv. @throws as write_summaries().
void write_indices(const std::filesystem::path& folder, const std::vector<InputIndices>& list);

/// As results have them; what is not a number is null.
Json json_of(const InputIndices& one);

/// Which input decides over an outcome, where that varies most; nothing of an outcome that never varies.
std::vector<std::string> index_sentences(const std::vector<InputIndices>& list, const std::string& axis);

/// The runs of a folder that stand as they end and whose ground moves on.
struct CutShort {
  std::size_t runs = 0;
  double most = 0;  ///< s that it does
};

CutShort cut_short(const std::filesystem::path& folder);

/// What the results in a folder come to, from its runs and their summaries, in sentences.
std::vector<std::string> sweep_headline(const std::filesystem::path& folder, const SummaryKeys& keys);

struct SweepOptions {
  std::filesystem::path folder;  ///< for results; must be there
  std::string command;           ///< the whole command line
  std::function<void(std::size_t done, std::size_t begun_with, std::size_t runs)> progress;  ///< of runs
  std::function<bool()> stopped;          ///< true: end after the blocks in progress
  std::optional<RunsFormat> format = {};  ///< else the usual one
};

struct SweepResult {
  std::size_t runs = 0;
  std::size_t done = 0;                    ///< before or now
  std::size_t computed = 0;                ///< now
  std::size_t failed = 0;                  ///< of all, once finished
  std::string reason = {};                 ///< of the first that failed
  double seconds = 0;                      ///< wall time of those
  std::vector<std::string> headline = {};  ///< once finished
  bool finished() const { return done == runs; }
};

/// Makes the runs of an ensemble that DIR/runs.journal does not have yet. Once all are there it writes
/// runs.csv, or runs.npz in the journal's place, sweep.json and summaries, whose bytes depend neither on the
/// executor nor on interruptions, and timing.json. Precondition: executor.leads().
/// @throws InputError where the folder holds another ensemble, or the other format.
SweepResult sweep(const Ensemble& ensemble, MotionLibrary& library, Executor& executor,
                  const SweepOptions& options);

}  // namespace rockstack
