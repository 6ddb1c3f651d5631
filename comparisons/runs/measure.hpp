#pragma once

#include <filesystem>
#include <string>

#include "analytic/scene/solve_options.hpp"
#include "comparisons/runs/job.hpp"

namespace rockstack {

/// Of histories that have no step of their own, s.
inline constexpr double sample_interval = 1e-3;

/// Makes one run of a comparison anew and writes FOLDER/runs/<run>/: for the exact solution its history and
/// events, for others what compare_with_exact() writes, and at last summary.json. A failure ends up in the
/// row. `runs_at_a_time`: how many share the machine with it, itself included.
/// @throws std::runtime_error where a file cannot be written.
RunMetrics measure(const Job& job, const std::filesystem::path& folder, const std::string& command,
                   std::size_t runs_at_a_time);

/// Solves a scene and writes history.csv, events.csv and summary.json into a folder. Where the motion could
/// not be followed to its end, the files hold it up to there, and the summary's status is "failed".
/// @throws as solve(), with the files written.
History solve_into(const NamedScene& scene, const SolveOptions& options, const std::filesystem::path& folder,
                   const std::string& command);

/// Runs one engine and writes the same files, with patterns as its angles tell them (contact_patterns.hpp);
/// an engine reports no events, so events.csv has its header alone.
History simulate_into(const NamedScene& scene, const EngineSeries& series, double dt,
                      const std::filesystem::path& folder, const std::string& command);

}  // namespace rockstack
