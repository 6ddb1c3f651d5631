// What sweeps cost: two threads over one, and batches of each instruction set over one scene after the other,
// as ratios within one run; and the time of a run.

#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>

#include "analytic/scene/ground/synthetic.hpp"
#include "analytic/solve_batch.hpp"
#include "comparisons/measures/metrics/run_outcome.hpp"
#include "comparisons/studies/sweep/sweep.hpp"
#include "tests/benchmarks/ensemble_scenes.hpp"

namespace rockstack {
namespace {

/// Computes all runs of an ensemble by so many threads, s.
double seconds(const Ensemble& ensemble, MotionLibrary& library, std::size_t threads) {
  const std::size_t runs = run_count(ensemble);
  std::vector<std::size_t> blocks((runs + block_size(runs) - 1) / block_size(runs));
  std::iota(blocks.begin(), blocks.end(), std::size_t{0});
  const auto start = std::chrono::steady_clock::now();
  make_threads(threads)->run(
      blocks, {[&](std::size_t block) { return journal_part(ensemble, block, library, RunsFormat::csv); },
               [](std::size_t, const std::string& lines) { benchmark::DoNotOptimize(lines.size()); },
               [] { return false; }});
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// One thread and two by turns, so that a busy machine slows both; the least time of each counts. To a
/// tolerance of 10^−range(0); for 0 to rounding. With demands where range(1) is 1.
void sweep_of_two_blocks(benchmark::State& state) {
  MotionLibrary library;
  const std::filesystem::path file = ROCKSTACK_ENSEMBLES "/ida-two-blocks.toml";
  Ensemble ensemble = read_ensemble(file, {"duration=20"}, library);
  if (state.range(0) > 0) ensemble.tolerance = std::pow(10, -static_cast<double>(state.range(0)));
  ensemble.demands = state.range(1) > 0;
  ensemble.samples = 4;  // the same again: of a few blocks of runs, one thread has the last
  double one = std::numeric_limits<double>::infinity();
  double two = one;
  for ([[maybe_unused]] auto round : state) {
    one = std::min(one, seconds(ensemble, library, 1));
    two = std::min(two, seconds(ensemble, library, 2));
  }
  state.counters["speedup_of_two_threads"] = one / two;
  state.counters["ms_per_run_of_one_thread"] = 1e3 * one / static_cast<double>(run_count(ensemble));
}
BENCHMARK(sweep_of_two_blocks)
    ->ArgsProduct({{0, 9, 6}, {1, 0}})
    ->Iterations(5)
    ->Unit(benchmark::kMillisecond);

/// What a run pays besides where it has a synthetic motion of its own.
void making_a_motion(benchmark::State& state) {
  SyntheticMotion motion{.peak = 1};
  for ([[maybe_unused]] auto round : state) {
    ++motion.seed;
    benchmark::DoNotOptimize(make_synthetic(motion).samples.data());
  }
}
BENCHMARK(making_a_motion)->Unit(benchmark::kMillisecond);

/// Solves scenes on one core, s.
double seconds(const std::vector<Scene>& scenes, const SolveOptions& options, InstructionSet set) {
  std::size_t given = 0;
  const auto start = std::chrono::steady_clock::now();
  solve_batch([&] { return given < scenes.size() ? std::optional(scenes[given++]) : std::nullopt; }, options,
              [](const Solved& solved) { benchmark::DoNotOptimize(solved.history.events.data()); }, set);
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// The instruction sets by turns; the least time of each counts. Tolerances as above.
void batch_over_scalar(benchmark::State& state, const std::string& ensemble_file) {
  const std::vector<Scene> scenes = benchmarks::ensemble_scenes(ensemble_file);
  const SolveOptions options =
      run_options(state.range(0) > 0 ? std::pow(10, -static_cast<double>(state.range(0))) : 0);
  std::map<InstructionSet, double> least;
  for ([[maybe_unused]] auto round : state) {
    for (const InstructionSet set : instruction_sets()) {
      const double time = seconds(scenes, options, set);
      const auto known = least.try_emplace(set, time).first;
      known->second = std::min(known->second, time);
    }
  }
  const double scalar = least.at(InstructionSet::scalar);
  for (const auto& [set, time] : least) {
    if (set != InstructionSet::scalar) state.counters[name(set) + "_over_scalar"] = scalar / time;
  }
  state.counters["ms_per_run_of_scalar"] = 1e3 * scalar / static_cast<double>(scenes.size());
}
BENCHMARK_CAPTURE(batch_over_scalar, ida_two_blocks, "ida-two-blocks")
    ->Arg(0)
    ->Arg(9)
    ->Arg(6)
    ->Iterations(5)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(batch_over_scalar, fragility_block, "fragility-block")
    ->Arg(0)
    ->Arg(9)
    ->Arg(6)
    ->Iterations(5)
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace rockstack
