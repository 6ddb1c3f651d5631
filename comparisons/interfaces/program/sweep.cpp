#include "comparisons/studies/sweep/sweep.hpp"

#include <fmt/format.h>

#include <atomic>
#include <csignal>
#include <cstdio>

#include "comparisons/interfaces/program/commands.hpp"
#include "comparisons/measures/results/files.hpp"
#include "comparisons/suites/shipped.hpp"

namespace rockstack {
namespace {

struct SweepArguments {
  std::string ensemble;
  std::filesystem::path out;
  std::size_t threads = 0;  ///< 0: as many as the machine runs at once; without effect under mpirun
  std::string format;       ///< of runs_formats; empty: the usual one
};

std::atomic<int> interruption = 0;  ///< the signal that asked for it
static_assert(std::atomic<int>::is_always_lock_free, "a signal handler may set it");

extern "C" void interrupt(int signal) {
  interruption = signal;
}

/// For as long as it lives, a signal that would end the program asks runs to stop.
class Interruptible {
 public:
  Interruptible() = default;
  ~Interruptible() {
    std::signal(SIGINT, of_sigint_);
    std::signal(SIGTERM, of_sigterm_);
  }
  Interruptible(const Interruptible&) = delete;
  Interruptible& operator=(const Interruptible&) = delete;

 private:
  void (*of_sigint_)(int) = std::signal(SIGINT, interrupt);
  void (*of_sigterm_)(int) = std::signal(SIGTERM, interrupt);
};

Ensemble read_ensemble(const SweepArguments& arguments, const Common& common, MotionLibrary& library) {
  return read_ensemble(input_file(arguments.ensemble, {"ensembles"}), common.overrides, library);
}

RunsFormat format_of(const Ensemble& ensemble, const SweepArguments& arguments) {
  if (arguments.format.empty()) return usual_format(run_count(ensemble));
  return static_cast<RunsFormat>(std::ranges::find(runs_formats, arguments.format) - runs_formats.begin());
}

/// What a process does that does not lead. It reads the ensemble only when it is given a block, so that of
/// bad input the leader alone speaks.
int serve(Executor& executor, const SweepArguments& arguments, const Common& common) {
  MotionLibrary library;
  std::optional<Ensemble> ensemble;
  executor.serve([&](std::size_t block) {
    if (!ensemble) ensemble = read_ensemble(arguments, common, library);
    return journal_part(*ensemble, block, library, format_of(*ensemble, arguments));
  });
  return 0;
}

/// A line that counts runs done and says how long the rest will take.
std::function<void(std::size_t, std::size_t, std::size_t)> sweep_progress(const Common& common) {
  if (!shows_progress(common)) return [](std::size_t, std::size_t, std::size_t) {};
  using Clock = std::chrono::steady_clock;
  return [start = Clock::now(), last = Clock::time_point{}](std::size_t done, std::size_t begun_with,
                                                            std::size_t runs) mutable {
    const auto now = Clock::now();
    const bool end = done == runs;
    if (!end && now - last < std::chrono::milliseconds(100)) return;
    last = now;
    const double seconds = std::chrono::duration<double>(now - start).count();
    const double rest = seconds * static_cast<double>(runs - done) / static_cast<double>(done - begun_with);
    const std::string remaining =
        end || done == begun_with ? "" : fmt::format(", {} to go", waiting_time(rest));
    fmt::print(stderr, "\r\033[K{} of {} runs{}{}", done, runs, remaining, end ? "\n" : "");
    std::fflush(stderr);
  };
}

/// Runs done, what they come to, and where the results are.
void print_sweep(const SweepResult& result, const std::filesystem::path& folder, const Common& common) {
  if (!print_json({{"runs", result.runs},
                   {"done", result.done},
                   {"computed", result.computed},
                   {"failed", result.failed},
                   {"seconds", result.seconds},
                   {"headline", result.headline},
                   {"folder", folder.string()}},
                  common))
    return;
  fmt::print("runs: {}, {} of them now in {:.3g} s\n", result.runs, result.computed, result.seconds);
  for (const std::string& sentence : result.headline) fmt::print("{}\n", sentence);
  fmt::print("results: {}\n", one_line(folder.string()));
}

int run_sweep(const SweepArguments& arguments, const Common& common) {
  std::optional<Interruptible> signals(std::in_place);
  const auto executor = make_executor(arguments.threads > 0 ? arguments.threads : all_cores());
  if (!executor->leads()) return serve(*executor, arguments, common);
  MotionLibrary library;
  const Ensemble ensemble = read_ensemble(arguments, common, library);
  warn_of_sizes(make_scene(typical_document(ensemble), library), common);
  const ResultsFolder folder(arguments.out, Results::sweep, subject_of(arguments.ensemble), common.replace);
  const SweepResult result = sweep(ensemble, library, *executor,
                                   {arguments.out, common.command, sweep_progress(common),
                                    [] { return interruption.load() != 0; }, format_of(ensemble, arguments)});
  if (!result.finished()) {
    fmt::print(stderr, "{}rockstack: stopped after {} of {} runs; the same command goes on from there\n",
               shows_progress(common) ? "\n" : "", result.done, result.runs);
    return 1;
  }
  signals.reset();
  if (interruption != 0) std::raise(interruption);
  print_sweep(result, arguments.out, common);
  show_report(arguments.out, common);
  return exit_code(result.failed, result.runs, failures_file(arguments.out).filename().c_str(),
                   result.reason);
}

void add_sweep(CLI::App& command, SweepArguments& arguments) {
  command
      .add_option("ensemble", arguments.ensemble, "ensemble file, or a name from `rockstack list ensembles`")
      ->required();
  command
      .add_option("--threads", arguments.threads,
                  "threads, as many as the machine has if left out; under mpirun, one a rank")
      ->check(CLI::Range(1, 1024));
  command
      .add_option(
          "--format", arguments.format,
          fmt::format(
              "csv: a line a run; npz: columns for numpy, less than half as large; left out: csv up to {} runs",
              most_csv_runs))
      ->check(one_of({runs_formats.begin(), runs_formats.end()}));
  add_results(
      command, arguments.out, [&] { return arguments.ensemble; }, ", where a sweep that was stopped goes on");
}

}  // namespace

Command sweep_command() {
  return make_command("sweep", "solve a scene many times with values varied", add_sweep, run_sweep);
}

}  // namespace rockstack
