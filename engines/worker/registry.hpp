#pragma once

#include "engines/worker/worker_engine.hpp"

namespace rockstack {

/// A folder of worker programs, or several with a ':' between them: an environment variable, also set by the
/// option --workers. A worker there is an executable file whose name begins with "rockstack-".
inline constexpr const char* workers_variable = "ROCKSTACK_WORKERS";

/// @throws InputError where one of these folders cannot be read; `name` is of the option or variable.
void require_folders(const std::string& name, const std::string& given);

/// Engines where they are kept.
using EngineList = std::vector<std::reference_wrapper<const WorkerEngine>>;

/// Every engine with every solver that this program was built with, then those of workers in the folders of
/// workers_variable, but for broken_workers(). It asks each worker once, a tenth of a second where it is a
/// script.
const EngineList& engines();

/// All solvers of the engine of a name, as "ode"; empty where there is none. Asks the worker of that name and
/// those in folders. @throws std::runtime_error where the worker of that name does not say which it has.
EngineList engines_called(const std::string& name);

/// Engines compared where nobody names any, Bullet and ODE, if there. @throws std::runtime_error likewise.
EngineList usual_engines();

/// Finds "bullet", "ode" or "bullet:nncg"; without a solver, the engine's first. A name with a '/' is the
/// path of a worker program, as "./my_engine.py" or "./my_engine.py:solver".
/// @throws InputError naming what was asked for, what is there and what is left out, or why a worker is none.
const WorkerEngine& find_engine(const std::string& name);

/// What a name on a command line stands for: all engines of a program that is named by its path alone, or the
/// one of find_engine(). @throws InputError likewise.
std::vector<const WorkerEngine*> chosen_engines(const std::string& name);

/// A worker program's engine by name, name and solver, or solver; empty: its first. @throws as find_engine().
const WorkerEngine& find_engine_at(const std::filesystem::path& program, const std::string& name);

/// Names of engines that were left out when this program was built and that no worker in a folder provides.
std::vector<std::string> engines_left_out();
/// Those among the usual engines.
std::vector<std::string> usual_engines_left_out();

/// A program that should be a worker and does not answer as one: its interpreter is missing, say.
struct BrokenWorker {
  std::string program, reason;
};
const std::vector<BrokenWorker>& broken_workers();
}  // namespace rockstack
