// What sweeps of two blocks under records cost: two threads over one, as a ratio within one run, and the time
// of a run.

#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <numeric>

#include "comparisons/ensemble/sweep.hpp"

namespace rockstack {
namespace {

/// Computes all runs of an ensemble by so many threads, s.
double seconds(const Ensemble& ensemble, MotionLibrary& library, std::size_t threads) {
  const std::size_t runs = run_count(ensemble);
  std::vector<std::size_t> blocks((runs + block_size(runs) - 1) / block_size(runs));
  std::iota(blocks.begin(), blocks.end(), std::size_t{0});
  const auto start = std::chrono::steady_clock::now();
  make_threads(threads)->run(
      blocks, {[&](std::size_t block) { return block_lines(ensemble, block, library); },
               [](std::size_t, const std::string& lines) { benchmark::DoNotOptimize(lines.size()); },
               [] { return false; }});
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// One thread and two by turns, so that a busy machine slows both; the least time of each counts. To a
/// tolerance of 10^−range(0); for 0 to rounding.
void sweep_of_two_blocks(benchmark::State& state) {
  MotionLibrary library;
  const std::filesystem::path file = ROCKSTACK_ENSEMBLES "/ida-two-blocks.toml";
  Ensemble ensemble = read_ensemble(file, {"duration=20"}, library);
  if (state.range(0) > 0) ensemble.tolerance = std::pow(10, -static_cast<double>(state.range(0)));
  double one = std::numeric_limits<double>::infinity();
  double two = one;
  for ([[maybe_unused]] auto round : state) {
    one = std::min(one, seconds(ensemble, library, 1));
    two = std::min(two, seconds(ensemble, library, 2));
  }
  state.counters["speedup_of_two_threads"] = one / two;
  state.counters["ms_per_run_of_one_thread"] = 1e3 * one / static_cast<double>(run_count(ensemble));
}
BENCHMARK(sweep_of_two_blocks)->Arg(0)->Arg(9)->Arg(6)->Iterations(5)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace rockstack
