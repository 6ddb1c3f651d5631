// What is said of Jolt (engines/web/jolt/page.md), by bare programs that share no code with its worker. No
// set was tuned on these scenes.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include "tests/engines/bare.hpp"
#include "tests/engines/findings/draws.hpp"
#include "tests/engines/findings/web_engines.hpp"

namespace rockstack {
namespace {

/// Jolt turns a body by no less than 1e-6 rad in a step: what is slower stays as it is.
TEST(WebEngines, JoltTurnsNothingByLessThanAMicroradianInAStep) {
  const WorkerEngine* engine = there("jolt:sequential-impulse");
  if (engine == nullptr) GTEST_SKIP() << "Jolt is not there";
  for (const double dt : {1e-2, 1e-3, 1e-4}) {
    for (const double share : {0.97, 1.03}) {
      Scene scene = slender_block(100.5 * dt);
      scene.gravity = 1e-9;
      scene.initial.velocities = {share * 1e-6 / dt};
      const std::string question = moving_question(*engine, scene, dt, engine->default_parameters());
      // 100 roundings of an angle of 0.1 rad in single precision.
      EXPECT_NEAR(bare_angles(engine->name, question).at(100) - scene.initial.angles.at(0),
                  share > 1 ? 100 * share * 1e-6 : 0, 1e-6)
          << dt;
    }
  }
}

/// The largest error of a block that begins to fall at so many microradians a step, before it lands, rad.
double error_in_jolt(const WorkerEngine& engine, double dt, double microradians, const Parameters& set) {
  Scene scene = slender_block(0.4);
  scene.initial.velocities = {-1e-6 * microradians / dt};
  return error_of({scene, dt}, bare_angles(engine.name, moving_question(engine, scene, dt, set)));
}

/// From rest a block therefore waits, and lags by an angle that is inverse to the step's square. One that
/// turns fast enough at once does not.
TEST(WebEngines, JoltLetsABlockAtRestWait) {
  const WorkerEngine* engine = there("jolt:sequential-impulse");
  if (engine == nullptr) GTEST_SKIP() << "Jolt is not there";
  for (const Parameters& set : {engine->default_parameters(), engine->tuned_parameters()}) {
    const double waiting = error_in_jolt(*engine, 5e-5, 0, set),
                 turning = error_in_jolt(*engine, 5e-5, 1.1, set);
    EXPECT_NEAR(waiting / error_in_jolt(*engine, 1e-4, 0, set), 4, 0.4);
    EXPECT_GT(waiting, 5 * turning);
    EXPECT_GT(error_in_jolt(*engine, 5e-5, 0.5, set), 5 * turning);
  }
}

/// Without a convex radius a contact that begins at 2 cm holds a block on the edge that it stands on, though
/// its other edge is 4 cm high. One that begins at 0.01 mm lets it fall as it should.
TEST(WebEngines, JoltHoldsBackABlockOnASharpEdgeWhereContactsBeginEarly) {
  const WorkerEngine* engine = there("jolt:sequential-impulse");
  if (engine == nullptr) GTEST_SKIP() << "Jolt is not there";
  for (const double dt : {1e-3, 9.7e-4, 3e-4}) {
    Scene scene = slender_block(0.3);
    scene.blocks = {make_block(0.4, 2, 2500)};
    Parameters set = engine->tuned_parameters();
    // The exact block turns by 32 mrad; half a step of its speed then is 0.1 mrad at 1 ms, and the wait 0.03
    // mrad.
    const auto error = [&] {
      return error_of({scene, dt}, bare_angles(engine->name, moving_question(*engine, scene, dt, set)));
    };
    EXPECT_LT(error(), 3e-4) << dt;
    set["mSpeculativeContactDistance"] = 0.02;
    EXPECT_GT(error(), 1e-2) << dt;
  }
}

/// The largest turn of a drum of three within a step of a bare program, on a ground that goes so far to each
/// side, rad.
double largest_turn_in_jolt(const WorkerEngine& engine, double dt, double convex_radius,
                            std::string_view ground, double reach) {
  Scene scene;
  scene.duration = 0.4;
  scene.blocks.assign(3, make_block(1, 1, 2700));
  scene.initial = {{0.1, 0.1, 0.1}, {0, 0, 0}};
  Parameters set = engine.tuned_parameters();
  set["mConvexRadius"] = convex_radius;
  set["ground"] = ground == "cube" ? 1 : 0;
  const std::string question = bare_question(engine, scene, dt, set) + fmt::format("reach {}\n", reach);
  const std::vector<double> angles = bare_angles(engine.name, question);
  double most = 0;
  for (std::size_t i = 3; i < angles.size(); ++i) most = std::max(most, std::abs(angles[i] - angles[i - 3]));
  return most;
}

/// A drum that had all energy, that of three whose centre is 42 mm higher than where they stand, would turn
/// about its edge at 1.94 rad/s: ω² = 2 · 3 g · 0.0425 m/(2/3 m²). Without a convex radius, on a cube 140
/// times as wide as a drum, the normal of a contact is at times another one, and a drum is turned by a
/// quarter of a radian at once. A tenth of a millimetre prevents it, and so does a smaller ground or a thin
/// one.
TEST(WebEngines, JoltWithoutAConvexRadiusTurnsADrumOnALargeCube) {
  const WorkerEngine* engine = there("jolt:sequential-impulse");
  if (engine == nullptr) GTEST_SKIP() << "Jolt is not there";
  for (const double dt : {1e-3, 2.5e-4}) {
    EXPECT_GT(largest_turn_in_jolt(*engine, dt, 0, "cube", 70), 0.2) << dt;
    EXPECT_LT(largest_turn_in_jolt(*engine, dt, 1e-4, "cube", 70), 1.94 * dt) << dt;
    EXPECT_LT(largest_turn_in_jolt(*engine, dt, 0, "cube", 10), 1.94 * dt) << dt;
    EXPECT_LT(largest_turn_in_jolt(*engine, dt, 0, "slab", 70), 1.94 * dt) << dt;
  }
}

}  // namespace
}  // namespace rockstack
