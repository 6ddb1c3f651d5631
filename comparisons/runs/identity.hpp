#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>

#include "comparisons/runs/job.hpp"
#include "comparisons/runs/run_files.hpp"

namespace rockstack {

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
