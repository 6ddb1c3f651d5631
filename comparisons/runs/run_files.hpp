#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>

#include "comparisons/runs/job.hpp"

namespace rockstack {

/// The files of one run by their names, before they are written: so a run can be made in another process, or
/// on another machine, than the one that keeps the results.
using RunFiles = std::map<std::string, std::string>;

/// The one that is written last: a run with it is whole.
inline constexpr const char* summary_name = "summary.json";

/// All of a file; empty where it cannot be read.
std::string bytes_of(const std::filesystem::path& file);

/// Makes the folder anew and writes all files. @throws std::runtime_error where one cannot be written.
void write_files(const RunFiles& files, const std::filesystem::path& folder);

/// Leaves out samples of history.csv, difference.csv, energy.csv, reactions.csv and parts.csv that are nearer
/// than an interval, s, to the one kept before; the first and the last stay. 0: all stay.
void thin_histories(RunFiles& files, double interval);

/// Between files and one text, for a message. unpack() throws std::runtime_error for anything else than what
/// pack() gave.
std::string pack(const RunFiles& files);
RunFiles unpack(const std::string& message);

/// A number, in hexadecimal, that two runs share which give the same results: made from all of the scene's
/// numbers, the engine's parameters, what is wanted, and the bytes of this program and of the worker's.
std::string identity(const Job& job);

/// The same of a run's draws.
std::string draws_identity(const Job& job);

/// Names and checksums of files, in hexadecimal.
using Checksums = std::map<std::string, std::string>;

/// Of all files of a run but its summary, which keeps them.
Checksums checksums(const RunFiles& files);

/// The row of a run that is done, of that identity, and whose files are all there as they were written; or
/// nothing. Files beside those, such as its draws, do not count.
std::optional<RunMetrics> finished_run(const std::filesystem::path& run_folder, const std::string& identity);

}  // namespace rockstack
