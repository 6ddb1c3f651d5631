#pragma once

#include <filesystem>
#include <string>

#include "comparisons/interfaces/program/arguments.hpp"
#include "comparisons/runs/execution/executor.hpp"
#include "engines/worker/registry.hpp"

namespace rockstack {

// Each returns the program's exit code: 0, or 1 where a run failed. Bad input is thrown as InputError.
// Scenes, suites and ensembles are files, or names that `list` shows.
int solve_command(const SolveArguments& arguments, const Common& common);
int simulate_command(const SimulateArguments& arguments, const Common& common);
int compare_command(const CompareArguments& arguments, const Common& common);
int plot_command(const PlotArguments& arguments, const Common& common);
int advise_command(const AdviseArguments& arguments, const Common& common);
int diff_command(const DiffArguments& arguments, const Common& common);  ///< 1 where something got worse
int record_command(const RecordArguments& arguments, const Common& common);
int sweep_command(const SweepArguments& arguments, const Common& common);
int teach_command(const TeachArguments& arguments, const Common& common);
int live_command(const LiveArguments& arguments, const Common& common);  ///< serves until it is ended
int list_command(const std::string& what, const Common& common);         ///< empty: all kinds
int check_engine_command(const CheckEngineArguments& arguments, const Common& common);
int canon_command(const CanonArguments& arguments, const Common& common);
int keys_command(const KeysArguments& arguments, const Common& common);
int new_command(const NewArguments& arguments, const Common& common);

/// Runs a study of stability, writes and draws its maps, and says how many runs have which verdict.
/// `draws`: as CompareArguments::draws.
int stability_command(const std::filesystem::path& file, const std::filesystem::path& out, Executor& executor,
                      int draws, const Common& common);

/// All solvers of an engine: of a worker program named by its path, or of a name that `list engines` shows;
/// or one, named with its solver. @throws InputError as find_engine().
std::vector<const WorkerEngine*> engines_named(const std::string& name);

/// The same of several names; where there is none, those of `otherwise`.
std::vector<const WorkerEngine*> engines_named(const std::vector<std::string>& names,
                                               EngineList (*otherwise)());

/// Those given, or "default" and "tuned" where none is.
std::vector<std::string> both_if_empty(const std::vector<std::string>& settings);

/// @throws InputError also where the input names a suite.
NamedScene read_one_scene(const std::string& input, const Common& common);

/// @throws InputError where the value is not finite and > 0.
void require_positive_option(const char* option, double value);

/// @throws InputError with the reason where there are overrides.
void refuse_overrides(const Common& common, const char* reason);

}  // namespace rockstack
