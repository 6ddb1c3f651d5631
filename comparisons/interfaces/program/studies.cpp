#include <fmt/format.h>

#include <atomic>
#include <csignal>
#include <cstdio>

#include "comparisons/interfaces/program/commands.hpp"
#include "comparisons/measures/results/files.hpp"
#include "comparisons/studies/canon/canon.hpp"
#include "comparisons/studies/fit/fit.hpp"
#include "comparisons/studies/sweep/sweep.hpp"
#include "comparisons/suites/shipped.hpp"

namespace rockstack {
namespace {

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

void print(const CanonRow& row, const CanonAnswer& answer) {
  fmt::print("{:<28} {:<8} {:<16} {:<12} {}\n", row.engine->full_name(), row.settings, answer.scene,
             answer.verdict, answer.reason);
  std::fflush(stdout);
}

}  // namespace

int sweep_command(const SweepArguments& arguments, const Common& common) {
  std::optional<Interruptible> signals(std::in_place);
  const auto executor = make_executor(arguments.threads > 0 ? arguments.threads : all_cores());
  if (!executor->leads()) return serve(*executor, arguments, common);
  MotionLibrary library;
  const Ensemble ensemble = read_ensemble(arguments, common, library);
  warn_of_sizes(make_scene(typical_document(ensemble), library), common);
  const ResultsFolder folder(arguments.out, Results::sweep, subject_of(arguments.ensemble), common.replace);
  const SweepResult result =
      sweep(ensemble, library, *executor,
            {arguments.out, common.command, sweep_progress(common), [] { return interruption.load() != 0; }});
  if (!result.finished()) {
    fmt::print(stderr, "{}rockstack: stopped after {} of {} runs; the same command goes on from there\n",
               shows_progress(common) ? "\n" : "", result.done, result.runs);
    return 1;
  }
  signals.reset();
  if (interruption != 0) std::raise(interruption);
  print_sweep(result, arguments.out, common);
  show_report(arguments.out, common);
  return exit_code(result.failed, result.runs, "runs.csv", result.reason);
}

int fit_command(const FitArguments& arguments, const Common& common) {
  const std::vector<FitParameter> parameters = mapped(arguments.vary, fit_parameter);
  const SceneDocument document = read_document(input_file(arguments.scene, {"scenes"}), common.overrides);
  if (!document.measured) throw missing_key(document.root, "measured", "given, a table of what was measured");
  MotionLibrary library;
  const Scene scene = make_scene(document, library);
  const Measurement measured = read_measurement(document.measured.value(), document.folder, scene);
  const ResultsFolder folder(arguments.out, Results::fit, subject_of(arguments.scene), common.replace);
  warn_of_sizes(scene, common);
  const Fit found = fit(document, measured, parameters);
  write_fit(scene.title, measured, found, arguments.out, common.command);
  if (print_json(fit_json(scene.title, measured, found, common.command), common)) {
    std::string changes;
    for (const FittedParameter& one : found.parameters) {
      fmt::print("{:<32} {:.6g}  95 %: {:.6g} to {:.6g}\n", one.parameter.key, one.value, one.lower,
                 one.upper);
      if (!one.parameter.is_clock())
        changes += " --set " + shell_word(fmt::format("{}={}", one.parameter.key, one.value));
    }
    for (const std::string& sentence : meaning(found, measured)) fmt::print("{}\n", sentence);
    fmt::print("\nrockstack solve {}{}\n", shell_word(arguments.scene), changes);
  }
  show_report(arguments.out, common);
  return 0;
}

int canon_command(const CanonArguments& arguments, const Common& common) {
  Suite suite = read_suite(find_file("canon", "suites"), common.overrides);
  const std::vector<const WorkerEngine*> asked = engines_named(arguments.engines, [] { return engines(); });
  const ResultsFolder folder(arguments.out, Results::canon);
  if (common.prints_text())
    fmt::print("{:<28} {:<8} {:<16} {:<12} by a fit over steps of {:g} to {:g} ms\n", "engine", "set",
               "scene", "verdict", 1e3 * canon_steps.front(), 1e3 * canon_steps.back());
  const auto show = progress(common);
  const std::size_t total = asked.size() * arguments.settings.size() * suite.scenes.size();
  std::size_t done = 0, off = 0;
  std::vector<CanonRow> rows;
  for (const WorkerEngine* engine : asked) {
    for (const std::string& settings : arguments.settings) {
      CanonRow& row = rows.emplace_back(CanonRow{engine, settings, {}});
      for (const NamedScene& scene : suite.scenes) {
        const std::string what = fmt::format("{} {} {}", engine->full_name(), settings, scene.name);
        show({done++, total, "", what, {}});
        row.answers.push_back(kept_canon_answer(suite, scene, *engine, settings, arguments.out / "answers"));
        if (!follows_law(row.answers.back())) ++off;
        clear_progress(common);
        if (common.prints_text()) print(row, row.answers.back());
      }
    }
  }
  const std::string json = canon_json(suite, rows, common.command);
  write_file(arguments.out / "canon.csv", canon_csv(rows));
  write_file(arguments.out / "canon.json", json);
  if (common.json) fmt::print("{}", json);
  show_report(arguments.out, common);
  if (common.prints_text())
    fmt::print("{} of {} answers neither agree nor converge{}\n", off, total, off > 0 ? ": exit code 1" : "");
  return off == 0 ? 0 : 1;
}

}  // namespace rockstack
