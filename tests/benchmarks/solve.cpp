#include <benchmark/benchmark.h>

#include "analytic/solve.hpp"
#include "tests/engines/linked_engines.hpp"

namespace rockstack {
namespace {

/// The paper's free-rocking example, for two seconds.
Scene free_rocking() {
  Scene scene;
  scene.duration = 2;
  scene.blocks = {make_block(1.25, 1.25, 2500), make_block(1.0, 2.5, 2500)};
  scene.initial = {{0.15, 0.15}, {0, 0}};
  return scene;
}

/// Seconds of wall time a simulated second, for a longest step of range(0) microseconds.
void exact(benchmark::State& state) {
  const Scene scene = free_rocking();
  const SolveOptions options;
  for ([[maybe_unused]] auto round : state) benchmark::DoNotOptimize(solve(scene, options));
}
BENCHMARK(exact)->Arg(200)->Arg(1000)->Unit(benchmark::kMillisecond);

/// The same scene stepped by an engine, building aside.
void stepping(benchmark::State& state, const Engine& engine) {
  const Scene scene = free_rocking();
  const double dt = 1e-6 * static_cast<double>(state.range(0));
  const int steps = static_cast<int>(scene.duration / dt);
  for ([[maybe_unused]] auto round : state) {
    state.PauseTiming();
    const auto simulation = engine.start(scene, dt, engine.tuned_parameters());
    state.ResumeTiming();
    for (int step = 0; step < steps; ++step) simulation->step();
  }
}

const bool registered = [] {
  for (const auto& engine : linked_engines()) {
    benchmark::RegisterBenchmark((engine->name() + ":" + engine->solver()).c_str(), stepping,
                                 std::cref(*engine))
        ->Arg(1000)
        ->Unit(benchmark::kMillisecond);
  }
  return true;
}();

}  // namespace
}  // namespace rockstack
