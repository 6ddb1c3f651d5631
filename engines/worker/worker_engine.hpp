#pragma once

#include "engines/body_record.hpp"
#include "engines/worker/process.hpp"
#include "engines/worker/request.hpp"

namespace rockstack {

/// An engine with one of its solvers, run by a worker program: each run in a process of its own, so that
/// whatever the engine does ends that run and nothing else.
struct WorkerEngine : EngineDescription {
  std::filesystem::path program;
  Form form = Form::json;  ///< in which it described its engines and is asked for runs

  /// The coefficient of friction that acts where a scene asks for `asked`.
  double friction(double asked) const { return std::min(asked, capabilities.largest_friction); }
};

/// All engines of a worker program, in its order. @throws std::runtime_error naming the program where it does
/// not answer within `answering_time` s, or not as engines/worker/README.md asks for.
std::vector<WorkerEngine> engines_of(const std::filesystem::path& program, double answering_time = 30);

/// What became of a run in a worker.
struct WorkerRun {
  /// "done", "failed", "not finite", "time limit", "memory limit", "signal" or, of unwanted runs, "stopped".
  std::string status;
  std::string reason;           ///< why not done
  EngineRun run;                ///< where done
  std::vector<double> seconds;  ///< wall time of stepping alone, each timed run, s
  bool cold = false;            ///< these are of a runtime that had not taken the steps to be warm
  double processor_time = 0;    ///< of the whole process, user and system, s
  double peak_memory = 0;       ///< likewise, bytes; 0 where the process did not come to say it
};

/// Does what run() of an engine does in this process, then times `repeats` runs, whose times are only asked
/// for.
/// @throws std::runtime_error for whatever kept the run from being done.
Trajectory run(const WorkerEngine& engine, const Setup& setup, const Parameters& parameters, bool bodies,
               const Limits& limits = {}, std::size_t repeats = 0, bool reactions = false);

/// Runs a scene for its duration, then times stepping alone `repeats` times; `bodies`: keeps a BodyRecord of
/// the first; `reactions`: what its interfaces bear. No failure of the engine throws.
/// @throws std::runtime_error where the operating system will not start the worker.
WorkerRun run_in_worker(const WorkerEngine& engine, const Scene& scene, double dt,
                        const Parameters& parameters, int repeats, const Limits& limits, bool bodies = false,
                        bool reactions = false);

/// Runs a scene for its duration; `bodies`: keeps a BodyRecord; `reactions`: what its interfaces bear.
/// @throws std::runtime_error where not done.
EngineRun simulate(const WorkerEngine& engine, const Scene& scene, double dt, const Parameters& parameters,
                   const Limits& limits = {}, bool bodies = false, bool reactions = false);

}  // namespace rockstack
