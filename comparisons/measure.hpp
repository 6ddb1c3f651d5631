#pragma once

#include <filesystem>
#include <string>

#include "analytic/solve_options.hpp"
#include "comparisons/compare.hpp"
#include "comparisons/row.hpp"
#include "comparisons/suite.hpp"

namespace rockstack {

/// One run to be made: of a series at one step, of a variant, or with neither the exact one that all others
/// are compared with.
struct Job {
  const Suite& suite;
  const NamedScene& scene;
  double dt;  ///< of a series or of the variant rk4, s
  const EngineSeries* series = nullptr;
  const Variant* variant = nullptr;
};

/// The row of a run before it is made: what is run, without results.
Row describe(const Job& job);

/// Makes one run of a comparison anew and writes FOLDER/runs/<run>/: for the exact solution its history and
/// events, for others what compare_with_exact() writes, and at last summary.json. A failure ends up in the
/// row.
/// @throws std::runtime_error where a file cannot be written.
Row measure(const Job& job, const std::filesystem::path& folder, const CompareOptions& options);

/// Solves a scene and writes history.csv, events.csv and summary.json into a folder.
History solve_into(const NamedScene& scene, const SolveOptions& options, const std::filesystem::path& folder,
                   const std::string& command);

/// Runs one engine and writes the same files, with patterns as its angles tell them (contact_patterns.hpp);
/// an engine reports no events, so events.csv has its header alone.
History simulate_into(const NamedScene& scene, const EngineSeries& series, double dt,
                      const std::filesystem::path& folder, const std::string& command);

}  // namespace rockstack
