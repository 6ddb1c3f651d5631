// Impacts that engines' contacts tell, beside those of the exact motion and those read from angles.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "analytic/solve.hpp"
#include "comparisons/measures/metrics/impacts.hpp"
#include "comparisons/runs/measure.hpp"
#include "engines/worker/registry.hpp"
#include "tests/native_engines.hpp"

namespace rockstack {
namespace {

constexpr double interval = 1e-4;  ///< between an engine's samples, s

Scene rocking_block() {
  Scene scene;
  scene.duration = 3;
  scene.blocks = {make_block(0.5, 2.5, 2500)};
  scene.initial = {{0.1}, {0}};
  return scene;
}

EngineRun run_of(const WorkerEngine& engine, const Scene& scene) {
  // Next to rigid: soft contacts come late.
  Parameters parameters = engine.tuned_parameters();
  for (auto& [name, value] : parameters)
    if (name == "globalCfm") value = std::min(value, 1e-6);
  WorkerRun made = run_in_worker(engine, scene, interval, parameters, 0, {}, true);
  EXPECT_EQ(made.status, "done") << made.reason;
  return std::move(made.run);
}

RunMetrics compared(const Scene& scene, const EngineRun& run) {
  Suite suite;
  suite.wanted.histories = false;
  RunMetrics row;
  RunFiles files;
  compare_with_exact(
      scene, suite,
      {run.history, interval, observed_impacts(scene, run.history, chatter_speed(scene)), false, run.bodies},
      scene.duration, row, files);
  return row;
}

// Steps from rest run ahead by the engine's lead; a step's impulse falls within the step. Soft contacts
// take several.
TEST(ContactImpacts, OfARockingBlockAreThoseOfTheExactMotionButForTheLead) {
  const Scene scene = rocking_block();
  const History exact = solve(scene, {});
  const Event& event = exact.events.at(0);
  const int expected = static_cast<int>(reported_impacts(scene, exact, chatter_speed(scene)).size());
  ASSERT_GE(expected, 3);
  // What gravity may change of an angular velocity within a step.
  const double pull = interval * scene.gravity / (2 * scene.blocks[0].half_height);
  for (const WorkerEngine& engine : native_engines()) {
    // Its pivots are ahead by an eighth of a step, as Jacobians are those of the step's start.
    if (engine.name == "siconos") continue;
    if (engine.capabilities.single_precision) continue;
    if (engine.name == "mujoco" || engine.name == "simbody") continue;
    const EngineRun run = run_of(engine, scene);
    const RunMetrics row = compared(scene, run);
    EXPECT_EQ(row.contact_impacts_matched, expected) << engine.name << ":" << engine.solver;
    EXPECT_EQ(row.contact_impacts_extra, 0) << engine.name << ":" << engine.solver;
    EXPECT_EQ(row.impact_readings_differ, 0) << engine.name << ":" << engine.solver;
    const ContactImpact& first = run.bodies->contacts->impacts.at(0);
    EXPECT_NEAR((first.time - event.time) / interval, -engine.capabilities.lead, 0.02)
        << engine.name << ":" << engine.solver;
    EXPECT_EQ(first.interface, event.interface);
    EXPECT_NEAR(first.speed, std::abs(event.before[0]), pull) << engine.name << ":" << engine.solver;
    EXPECT_NEAR(first.after, event.after[0], pull) << engine.name << ":" << engine.solver;
  }
}

}  // namespace
}  // namespace rockstack
