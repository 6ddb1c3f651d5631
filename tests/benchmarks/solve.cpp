#include <benchmark/benchmark.h>

#include <algorithm>

#include "analytic/solve.hpp"
#include "tests/engines/linked_engines.hpp"
#include "tests/free_rocking.hpp"

namespace rockstack {
namespace {

/// Two seconds of free rocking: by rk4 at steps of range(0) microseconds, for none by the Taylor series.
void exact(benchmark::State& state) {
  const Scene scene = free_rocking(2);
  const SolveOptions options{.integrator = state.range(0) > 0 ? Integrator::rk4 : Integrator::taylor,
                             .step = 1e-6 * static_cast<double>(std::max<std::int64_t>(state.range(0), 1))};
  for ([[maybe_unused]] auto round : state) benchmark::DoNotOptimize(solve(scene, options));
}
BENCHMARK(exact)->Arg(0)->Arg(200)->Arg(1000)->Unit(benchmark::kMillisecond);

/// Steps the scene by an engine, building aside.
void stepping(benchmark::State& state, const Engine& engine) {
  const Scene scene = free_rocking(2);
  const double dt = 1e-6 * static_cast<double>(state.range(0));
  const int steps = static_cast<int>(scene.duration / dt);
  for ([[maybe_unused]] auto round : state) {
    state.PauseTiming();
    const auto simulation = start(engine, scene, dt, engine.tuned_parameters());
    state.ResumeTiming();
    for (int step = 0; step < steps; ++step) simulation->step();
  }
}

const bool registered = [] {
  for (const auto& engine : linked_engines()) {
    benchmark::RegisterBenchmark((engine->full_name()).c_str(), stepping, std::cref(*engine))
        ->Arg(1000)
        ->Unit(benchmark::kMillisecond);
  }
  return true;
}();

}  // namespace
}  // namespace rockstack
