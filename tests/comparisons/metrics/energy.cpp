#include "comparisons/metrics/energy.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "analytic/solve.hpp"
#include "engines/worker/registry.hpp"
#include "tests/free_rocking.hpp"

namespace rockstack {
namespace {

TEST(Energy, OfTheExactMotionIsConstantBetweenImpactsAndNeverRises) {
  const Scene scene = free_rocking(3);
  const History history = solve(scene, {.sample_times = regular_times(1e-3, scene.duration)});
  const auto energy = energies(scene, history);
  const double rounding = 1e-12 * energy_scale(scene);
  for (std::size_t i = 0; i < history.size() && history.times[i] < 0.6; ++i) {
    EXPECT_NEAR(energy[i], energy[0], rounding) << history.times[i];
  }
  EXPECT_LT(largest_gain(energy, std::vector<double>(energy.size())), rounding);
  EXPECT_LT(energy.back(), 0.9 * energy.front());
}

TEST(Energy, IsZeroAtRestUpright) {
  Scene scene = free_rocking(3);
  scene.initial.angles = {0, 0};
  scene.duration = 0.1;
  const History history = solve(scene, {.sample_times = {0, 0.1}});
  for (const double energy : energies(scene, history)) EXPECT_NEAR(energy, 0, 1e-12 * energy_scale(scene));
}

// Both sides count from the same zero: an engine starts with the exact solution's energy.
TEST(Energy, EnginesStartWithThatOfTheExactSolution) {
  const Scene scene = free_rocking(3);
  const History start = solve(scene, {.sample_times = {0}});
  for (const WorkerEngine& engine : engines()) {
    Scene brief = scene;
    brief.duration = 0.01;
    const WorkerRun made = run_in_worker(engine, brief, 1e-3, engine.tuned_parameters(), 0, {}, true);
    ASSERT_EQ(made.status, "done") << made.reason;
    // Single precision holds places of a few metres to 2e-7 m.
    EXPECT_NEAR(made.run.bodies.value().energy[0], energies(scene, start)[0], 1e-6 * energy_scale(scene))
        << engine.name() << ":" << engine.solver();
  }
}

TEST(EnergyGain, IsTheLargestRiseAboveTheLeastBeforeLessTheInput) {
  EXPECT_EQ(largest_gain({5, 3, 4, 2, 3.5, 1}, {0, 0, 0, 0, 0, 0}), 1.5);
  EXPECT_EQ(largest_gain({0, 1, 2, 3}, {0, 1, 2, 3}), 0);
  EXPECT_EQ(largest_gain({3, 2, 1}, {0, 0, 0}), 0);
}

}  // namespace
}  // namespace rockstack
