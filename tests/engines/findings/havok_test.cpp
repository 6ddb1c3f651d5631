// What is said of Havok (engines/web/havok/page.md). No set was tuned on these scenes.

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "engines/scene_setup.hpp"
#include "tests/engines/findings/draws.hpp"
#include "tests/engines/findings/web_engines.hpp"

namespace rockstack {
namespace {

/// What a block lacks of the upward velocity that `pull` m/s² give it from `start` m/s on, in Havok, m/s, and
/// after how long, s.
struct Lack {
  double velocity, time;
};
Lack lack_in_havok(const WorkerEngine& engine, Scene scene, double start, double pull, double dt) {
  scene.vertical.interval = 10;
  scene.vertical.samples = {-scene.gravity - pull, -scene.gravity - pull};
  const Parameters parameters = engine.tuned_parameters();
  const std::vector<BodyState> bodies = run(engine, set_up(scene, dt, parameters), parameters, true).bodies;
  const double time = dt * static_cast<double>(bodies.size() - 1);
  return {start + pull * time - bodies.back().velocity_y, time};
}

/// Below 0.1 m/s Havok brakes a body by 1/32 of what pulls it. One that starts at rest lacks 0.1/31 m/s when
/// it gets there, whatever pulls it; one that comes to rest against the pull stops sooner.
TEST(WebEngines, HavokBrakesWhatIsSlow) {
  const WorkerEngine* engine = there("havok:own");
  if (engine == nullptr) GTEST_SKIP() << "Havok is not there";
  for (const double pull : {1.0, 2.0, 5.0}) {
    for (const double dt : {4e-3, 1e-3, 2.5e-4}) {
      SCOPED_TRACE(::testing::Message() << pull << " m/s², " << dt << " s");
      Scene starts = slender_block(0.3);
      starts.initial = {{0}, {0}};
      // The speed is read off motions, to a tenth; and a step's share.
      EXPECT_NEAR(lack_in_havok(*engine, starts, 0, pull, dt).velocity, 0.1 / 31, 0.01 / 31 + pull * dt / 32);
      Scene stops = starts;
      stops.law = Law::unilateral;
      stops.initial.gaps = {0.5};
      stops.initial.gap_velocities = {0.09};
      stops.duration = 0.08 / pull;
      const auto [velocity, time] = lack_in_havok(*engine, stops, 0.09, -pull, dt);
      EXPECT_NEAR(velocity, pull * time / 32, 0.1 * pull * time / 32 + pull * dt / 32);
    }
  }
}

/// Havok rounds corners, by 15 mm whatever the size: a block that starts tilted by θ drops by
/// r (cos θ + sin θ − 1) before it turns on its corner. So small blocks land late and large ones do not.
TEST(WebEngines, HavokRoundsCornersOfAnySizeByAsMuch) {
  const WorkerEngine* engine = there("havok:own");
  if (engine == nullptr) GTEST_SKIP() << "Havok is not there";
  for (const double width : {0.5, 1.0, 4.0}) {
    SCOPED_TRACE(width);
    Scene scene;
    scene.blocks = {make_block(width, 2 * width, 2500)};
    scene.initial = {{0.3}, {0}};
    scene.friction.assign(scene.blocks.size(), 5);
    scene.duration = 0.1;
    const Parameters parameters = engine->tuned_parameters();
    const Trajectory motion = run(*engine, set_up(scene, 1e-3, parameters), parameters, true);
    const double angle = motion.angles.back();
    const double drop = width * std::cos(angle) + width / 2 * std::sin(angle) - motion.bodies.back().y;
    EXPECT_NEAR(drop / (std::cos(angle) + std::sin(angle) - 1), 0.015, 0.0015);
  }
}

}  // namespace
}  // namespace rockstack
