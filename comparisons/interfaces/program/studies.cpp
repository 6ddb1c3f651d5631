#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <csignal>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>

#include "comparisons/interfaces/program/commands.hpp"
#include "comparisons/measures/results/files.hpp"
#include "comparisons/studies/stability/study.hpp"
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

void print_verdicts(const std::vector<StabilityRun>& rows, const std::filesystem::path& out,
                    const Common& common) {
  if (common.quiet) return;
  std::map<std::string, int> counts{{"sound", 0}, {"inexact", 0}, {"unstable", 0}, {"failed", 0}};
  for (const StabilityRun& row : rows) {
    if (row.row.dt) ++counts[name(row.verdict.soundness)];
  }
  if (common.json) {
    fmt::print("{}\n", nlohmann::ordered_json{{"verdicts", counts}, {"folder", out.string()}}.dump(2));
    return;
  }
  for (const auto& [verdict, count] : counts) fmt::print("{:>6} runs {}\n", count, verdict);
  fmt::print("{}\n{}\n", (out / "stability.csv").string(), (out / "steps.csv").string());
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

int stability_command(const std::filesystem::path& file, const std::filesystem::path& out, Executor& executor,
                      int replicates, const Common& common) {
  StabilityStudy study = read_stability_study(file, common.overrides);
  if (replicates > 0) set_runs(study.suite.replicates, replicates);
  require_comparable({study.suite});
  const ResultsFolder folder(out, Results::stability);
  const std::vector<StabilityRun> rows =
      run_stability(study, out, executor, {.command = common.command, .progress = progress(common)});
  print_verdicts(rows, out, common);
  show_report(out, common);
  const auto failed = std::count_if(
      rows.begin(), rows.end(), [](const StabilityRun& row) { return row.row.status != RunStatus::done; });
  return end_of_runs(static_cast<std::size_t>(failed), rows.size(), "stability.csv");
}

}  // namespace rockstack
