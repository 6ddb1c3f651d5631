#include <fmt/format.h>

#include <atomic>
#include <csignal>
#include <thread>

#include "comparisons/build.hpp"
#include "comparisons/ensemble/sweep.hpp"
#include "comparisons/files.hpp"
#include "comparisons/program/commands.hpp"
#include "comparisons/program/output.hpp"
#ifdef ROCKSTACK_WITH_PLOTS
#include "plots/sweep.hpp"
#endif

namespace rockstack {
namespace {

std::atomic<bool> interrupted = false;
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler may set it");

extern "C" void interrupt(int /*signal*/) {
  interrupted = true;
}

std::size_t thread_count(std::size_t asked) {
  if (asked > 0) return asked;
  return std::max(1U, std::thread::hardware_concurrency());
}

}  // namespace

int sweep_command(const SweepArguments& arguments, const Common& common) {
  MotionLibrary library;
  const Ensemble ensemble =
      read_ensemble(find_file(arguments.ensemble, build::ensembles), common.overrides, library);
  prepare_folder(arguments.out);
  std::signal(SIGINT, interrupt);
  std::signal(SIGTERM, interrupt);
  const auto workers = make_threads(thread_count(arguments.threads));
  const SweepResult result =
      sweep(ensemble, library, *workers,
            {arguments.out, common.command, sweep_progress(common), [] { return interrupted.load(); }});
  if (!result.finished()) {
    fmt::print(stderr, "rockstack: stopped after {} of {} runs; the same command goes on from there\n",
               result.done, result.runs);
    return 1;
  }
#ifdef ROCKSTACK_WITH_PLOTS
  draw_sweep(arguments.out);
#endif
  print_sweep(result, arguments.out, common);
  return 0;
}

}  // namespace rockstack
