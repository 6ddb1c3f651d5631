#pragma once

#include "comparisons/measures/results/files.hpp"
#include "comparisons/studies/sweep/ensemble.hpp"

namespace rockstack {

/// How a sweep's runs are kept: as lines of runs.csv, or as columns in runs.npz, whose numbers are the same
/// to the bit, with the reasons of runs that failed in failures.csv.
enum class RunsFormat { csv, npz };
inline constexpr std::array<const char*, 2> runs_formats{"csv", "npz"};

/// The most runs that are lines unless a sweep is told otherwise.
inline constexpr std::size_t most_csv_runs = 100000;

RunsFormat usual_format(std::size_t runs);

/// A column of a sweep's runs.
struct RunColumn {
  std::string name, meaning;
  bool is_text = false;  ///< else of numbers, as a run has one
};

/// The column of why runs failed, which columns in runs.npz are without.
inline const std::string reason_column = "reason";

/// All of them in their order: the run's number, one a variation, then what came out.
std::vector<RunColumn> run_columns(const Ensemble& ensemble);

/// Consecutive runs are computed and kept in blocks of this size.
std::size_t block_size(std::size_t runs);

/// How many runs a block has.
std::size_t length_of(std::size_t block, std::size_t runs);

/// A block of runs as a part of the journal: a line each, or columns that are compressed. A run whose scene
/// is out of range or that the solver cannot finish says so. May be called from several threads at once.
std::string journal_part(const Ensemble& ensemble, std::size_t block, MotionLibrary& library,
                         RunsFormat format);

/// Writes runs.csv, or runs.npz and failures.csv, from a journal that has all blocks; `job` is the archive's
/// comment. A few blocks are in memory at a time.
void write_runs(const Ensemble& ensemble, const Journal& journal, const std::filesystem::path& folder,
                RunsFormat format, const std::string& job);

/// The file that says why runs of a folder failed, in its column `reason`.
std::filesystem::path failures_file(const std::filesystem::path& folder);

}  // namespace rockstack
