#pragma once

#include <future>

#include "comparisons/measures/results/run_metrics.hpp"
#include "comparisons/suites/suite.hpp"

namespace rockstack {

/// Between samples of histories that have no step of their own, s.
inline constexpr double sample_interval = 1e-3;

/// Until when a scene can be predicted, s: the first time at which the exact motion of one of its replicates,
/// which hardly differ, is further than `tolerance` rad from its own, seen every sample_interval, or that of
/// the flat landing by which they part; its duration where none ever is. Later only distributions can be
/// compared.
/// @throws as solve().
double predictable_time(const Scene& scene, const Replicates& replicates, double tolerance);

/// How many scenes that hardly differ tell the horizon of one, itself included: of a suite's size and seed,
/// but as many whatever its number of replicates, so that a scene has one horizon.
inline constexpr int horizon_scenes = 21;

/// One run to be made: of a series at one step, of a variant, or with neither the exact one that all others
/// are compared with.
struct Job {
  const Suite& suite;
  const NamedScene& scene;
  double dt;  ///< of a series or of the variant rk4, s
  const EngineSeries* series = nullptr;
  const Variant* variant = nullptr;
  std::shared_future<double> horizon =
      {};  ///< predictable_time(), one for all jobs of a scene; none: its duration
};

/// True for the variant of that choice: of rk4, which has a time step, or of what a test has measured.
bool has_choice(const Job& job, Variant::Choice choice);

/// True for runs that another program has made.
bool is_recorded(const Job& job);

/// Up to when the job's histories are compared, s; the duration where the exact motion cannot be found.
double horizon_of(const Job& job);

/// The replicates behind the job's numbers: as many of its suite's as may be made at its step.
Replicates replicates_of(const Job& job);

/// The row of a run before it is made: what is run, without results.
RunMetrics describe(const Job& job);

/// Every scene on the exact solver, on its variants and on every series at each step. Keeps references to the
/// suites.
std::vector<Job> jobs_of(const std::vector<Suite>& suites);

/// About how large the files of a comparison's runs are, bytes, by the mean lengths of what stands in them.
/// An upper bound where blocks topple.
double result_bytes(const std::vector<Suite>& suites);

/// The files of one run by their names, before they are written: so a run can be made in another process, or
/// on another machine, than the one that keeps the results.
using RunFiles = std::map<std::string, std::string>;

/// The one that is written last: a run with it is whole.
inline constexpr const char* summary_name = "summary.json";

/// All of a file; empty where it cannot be read.
std::string bytes_of(const std::filesystem::path& file);

/// Makes the folder anew and writes all files, that of the name `last` last.
/// @throws std::runtime_error where one cannot be written.
void write_files(const RunFiles& files, const std::filesystem::path& folder,
                 const std::string& last = summary_name);

/// Leaves out samples of history.csv, difference.csv, energy.csv, reactions.csv and parts.csv that are nearer
/// than an interval, s, to the one kept before; the first and the last stay. 0: all stay.
void thin_histories(RunFiles& files, double interval);

/// Thins the files of a run that are written, which then counts as unfinished.
void thin_run(const std::filesystem::path& folder, double interval);

/// Between files and one text, for a message. unpack() throws std::runtime_error for anything else than what
/// pack() gave.
std::string pack(const RunFiles& files);
RunFiles unpack(const std::string& message);

/// A number, in hexadecimal, that two runs share which give the same results: made from all of the scene's
/// numbers, the engine's parameters, what is wanted, and the bytes of this program and of the worker's.
std::string identity(const Job& job);

/// Identity of a run's replicates.
std::string replicates_identity(const Job& job);

/// Checksums, in hexadecimal, of all files of a run by their names, but of its summary, which keeps them.
std::map<std::string, std::string> checksums(const RunFiles& files);

/// The row of a run that is done, of that identity, and whose files are all there as they were written; or
/// nothing. Files beside those, such as its replicates, do not count.
std::optional<RunMetrics> finished_run(const std::filesystem::path& run_folder, const std::string& identity);

/// True for a job that has more runs behind its numbers than the nominal one.
bool is_replicated(const Job& job);

/// What the replicates of a job come to.
struct MadeReplicates {
  std::vector<RunMetrics> rows;
  /// band.csv: time,lower_1,upper_1,…: between what the middle half of their angles lie at 400 times, rad, up
  /// to where the first of them ends. Empty where the suite keeps no histories.
  std::string band = {};
};

/// Makes the replicates of a job but the nominal one, `threads` at a time: an engine's runs at nearby steps
/// of scenes that hardly differ, each held against the exact solution of its own scene; of what another
/// program has recorded its further runs. None is timed. A
/// replicate that fails has a row that says why; one that runs out of time or memory ends the set, and those
/// after it fail likewise.
MadeReplicates make_replicates(const Job& job, std::size_t threads);

/// Between replicates and the text that a message or a file holds. @throws nlohmann::json::exception
std::string pack_replicates(const MadeReplicates& replicates, const std::string& identity);

/// The replicates in such a text, where they are of that identity.
std::optional<std::vector<RunMetrics>> unpack_replicates(const std::string& text,
                                                         const std::string& identity);

/// Writes draws.json and, for readers, draws.csv and band.csv into a run's folder.
void write_replicates(const std::string& packed, const RunMetrics& nominal,
                      const std::filesystem::path& folder);

/// Puts medians over the nominal run and its replicates in the place of the nominal row's numbers, with
/// quartiles, and says how many there were.
void summarise(const std::vector<RunMetrics>& replicates, RunMetrics& nominal);

struct RunWithReplicates {
  RunMetrics nominal;
  std::vector<RunMetrics> replicates;
  std::optional<int> shown = {};  ///< the one whose history stands for all, as representative()
};

/// The replicate whose error is the median: of rank ⌈n/2⌉ among n that are done. 0 is the nominal run, which
/// comes before others of the same error, and stands for a row that has no errors.
int representative(const RunWithReplicates& row);

/// The files of that replicate's motion, as measure() makes those of the nominal run, without a summary; none
/// where it cannot be made again.
RunFiles replicate_files(const Job& job, int number);

/// A line a run and quantity: run,quantity,draws,least,lower_quartile,median,upper_quartile,greatest, of
/// rows with their replicates.
std::string spread_csv(const std::vector<RunWithReplicates>& rows);

}  // namespace rockstack
