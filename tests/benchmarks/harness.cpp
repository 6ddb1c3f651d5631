// What the harness costs: stepping inside it over a bare loop on the engine's library, as a ratio within one
// run.

#include <benchmark/benchmark.h>

#include <algorithm>

#include "engines/scene_setup.hpp"
#include "engines/trajectory.hpp"
#include "tests/benchmarks/bare_loops.hpp"
#include "tests/engines/linked_engines.hpp"
#include "tests/free_rocking.hpp"

namespace rockstack {
namespace {

constexpr double step_size = 1e-3;  ///< s
constexpr int step_count = 2000;

/// Both by turns, so that a busy machine slows both; the least time of each counts.
void over_bare_loop(benchmark::State& state, const Engine& engine, double (*bare)(double, int)) {
  Parameters parameters = engine.tuned_parameters();
  // The bare loop leaves the rotation to itself.
  if (parameters.count("realign") != 0) parameters["realign"] = 0;
  const Setup setup = set_up(free_rocking(step_count * step_size), step_size, parameters);
  double harness = 1e9;
  double alone = 1e9;
  for ([[maybe_unused]] auto round : state) {
    alone = std::min(alone, bare(step_size, step_count));
    harness = std::min(harness, time_stepping(engine, setup, parameters, step_count, 1).front());
  }
  state.counters["ratio"] = harness / alone;
}

const bool harness_registered = [] {
  for (const auto& engine : linked_engines()) {
    double (*bare)(double, int) = nullptr;
#ifdef ROCKSTACK_WITH_BULLET
    if (engine->name == "bullet" && engine->solver == "sequential-impulse") bare = bare_bullet_seconds;
#endif
#ifdef ROCKSTACK_WITH_ODE
    if (engine->solver == "step") bare = bare_ode_seconds;
#endif
    if (bare == nullptr) continue;
    benchmark::RegisterBenchmark(("harness/" + engine->name).c_str(), over_bare_loop, std::cref(*engine),
                                 bare)
        ->Iterations(50)
        ->Unit(benchmark::kMillisecond);
  }
  return true;
}();

}  // namespace
}  // namespace rockstack
