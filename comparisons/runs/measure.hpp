#pragma once

#include <filesystem>
#include <string>

#include "analytic/scene/solve_options.hpp"
#include "comparisons/measures/metrics/motion_verdict.hpp"
#include "comparisons/runs/job.hpp"
#include "comparisons/runs/run_files.hpp"

namespace rockstack {

/// Makes one run of a comparison: for the exact solution its history and events, up to where it was
/// given up if it was; for others what compare_with_exact() adds; and its summary.json. A failure ends up in
/// the summary. `runs_at_a_time`: how many share the machine with it, itself included.
RunFiles measure(const Job& job, const std::string& command, std::size_t runs_at_a_time);

/// Runs an engine once for a job and sets it beside the exact solution; `repeats`: how often its stepping is
/// timed. The series' parameters and the suite's wishes are the job's, scene and step may be other ones.
/// @throws std::runtime_error where the scene cannot be solved or the worker not be started.
RunMetrics engine_metrics(const Job& job, const Scene& scene, double dt, int repeats, RunFiles& files);

/// The metrics in a summary. @throws nlohmann::json::exception where it is none.
RunMetrics metrics_in(const std::string& summary);

/// Solves a scene and writes history.csv, events.csv, those of `histories` (results/histories.hpp) and
/// summary.json into a folder. Where the motion could
/// not be followed to its end, the files hold it up to there, and the summary's status is "failed".
/// @throws as solve(), with the files written.
History solve_into(const NamedScene& scene, const SolveOptions& options,
                   const std::vector<std::string>& histories, const std::filesystem::path& folder,
                   const std::string& command);

/// An engine's motion, and how its blocks end on what they stand on.
struct SimulatedMotion {
  History history;
  Support support;
};

/// Runs one engine and writes the same files, with patterns as its angles tell them (sampled_patterns());
/// an engine reports no events, so events.csv has its header alone.
SimulatedMotion simulate_into(const NamedScene& scene, const EngineSeries& series, double dt,
                              const std::filesystem::path& folder, const std::string& command);

}  // namespace rockstack
