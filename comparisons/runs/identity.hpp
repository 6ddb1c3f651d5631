#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "comparisons/runs/job.hpp"

namespace rockstack {

/// A number, in hexadecimal, that two runs share which give the same results: made from all of the scene's
/// numbers, the engine's parameters, what is wanted, and the bytes of this program and of the worker's.
std::string identity(const Job& job);

/// The row of a run that is done and whose results in its folder have that identity, or nothing.
std::optional<RunMetrics> finished_run(const std::filesystem::path& run_folder, const std::string& identity);

}  // namespace rockstack
