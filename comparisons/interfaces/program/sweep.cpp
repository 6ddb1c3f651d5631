#include <atomic>
#include <csignal>
#include <optional>

#include "comparisons/interfaces/program/commands.hpp"
#include "comparisons/measures/results/files.hpp"
#include "comparisons/studies/sweep/sweep.hpp"
#include "comparisons/suites/shipped.hpp"

namespace rockstack {
namespace {

std::atomic<bool> interrupted = false;
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler may set it");

extern "C" void interrupt(int /*signal*/) {
  interrupted = true;
}

Ensemble read_ensemble(const SweepArguments& arguments, const Common& common, MotionLibrary& library) {
  return read_ensemble(input_file(arguments.ensemble, {"ensembles"}), common.overrides, library);
}

/// What a process does that does not lead. It reads the ensemble only when it is given a block, so that of
/// bad input the leader alone speaks.
int serve(Executor& executor, const SweepArguments& arguments, const Common& common) {
  MotionLibrary library;
  std::optional<Ensemble> ensemble;
  executor.serve([&](std::size_t block) {
    if (!ensemble) ensemble = read_ensemble(arguments, common, library);
    return block_lines(*ensemble, block, library);
  });
  return 0;
}

}  // namespace

int sweep_command(const SweepArguments& arguments, const Common& common) {
  std::signal(SIGINT, interrupt);
  std::signal(SIGTERM, interrupt);
  const auto executor = make_executor(arguments.threads > 0 ? arguments.threads : all_cores());
  if (!executor->leads()) return serve(*executor, arguments, common);
  MotionLibrary library;
  const Ensemble ensemble = read_ensemble(arguments, common, library);
  const ResultsFolder folder(arguments.out, Results::sweep);
  const SweepResult result =
      sweep(ensemble, library, *executor,
            {arguments.out, common.command, sweep_progress(common), [] { return interrupted.load(); }});
  if (!result.finished()) {
    print_stopped(result, common);
    return 1;
  }
  print_sweep(result, arguments.out, common);
  show_report(arguments.out, common);
  return end_of_runs(result.failed, result.runs, "runs.csv");
}

}  // namespace rockstack
