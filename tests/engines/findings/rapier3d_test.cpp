// What is said of Rapier 3D (engines/web/rapier3d/page.md), by bare programs that share no code with its
// worker. No set was tuned on these scenes.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "tests/engines/bare.hpp"
#include "tests/engines/findings/draws.hpp"
#include "tests/engines/findings/web_engines.hpp"

namespace rockstack {
namespace {

/// Which motions out of the plane are held back, as the bare program knows them.
constexpr int locked_turns = 2, all_locked = 3;

/// What a landing leaves of 1 rad/s, for a block of height over width r without weight.
double left_in_rapier3d(const WorkerEngine& engine, double r, double friction, int locks) {
  constexpr double dt = 1e-4;
  Scene scene;
  scene.gravity = 1e-9;
  scene.duration = 60.5 * dt;
  scene.blocks = {make_block(1, r, 500)};
  scene.initial = {{1e-9}, {-1}};
  scene.friction = {friction};
  const std::vector<double> angles = bare_angles(
      engine.name,
      moving_question(engine, scene, dt, engine.default_parameters(), fmt::format("locks {}", locks)));
  return (angles.at(40) - angles.at(60)) / (20 * dt);
}

/// Two directions of friction share a matrix of two by two. A body that neither moves nor turns out of the
/// plane has nothing in the second, the matrix has no inverse, and there is no friction in the plane either.
/// With turns alone held back friction is that of Rapier in two dimensions: N₀(1 + 2q), where q = 3μr/(4 +
/// r²).
TEST(WebEngines, Rapier3DHasNoFrictionWithAllThatLeavesThePlaneLocked) {
  const WorkerEngine* engine = there("rapier3d:sequential-impulse");
  if (engine == nullptr) GTEST_SKIP() << "Rapier 3D is not there";
  for (const auto& [r, friction] : {std::pair{1.5, 0.2}, {2.0, 0.3}, {3.0, 0.1}}) {
    SCOPED_TRACE(r);
    const double q = 3 * friction * r / (4 + r * r);
    EXPECT_NEAR(left_in_rapier3d(*engine, r, friction, all_locked), (r * r - 2) / (4 + r * r), 1e-3);
    EXPECT_NEAR(left_in_rapier3d(*engine, r, friction, locked_turns),
                1 - 6 * (1 - friction * r) / (4 + r * r) * (1 + 2 * q), 1e-3);
  }
}

/// How far a flat block comes in 0.3 s from 0.5 m/s, m.
double slide_in_rapier3d(const WorkerEngine& engine, int locks) {
  Scene scene;
  scene.blocks = {make_block(2, 1, 2500)};
  scene.initial = {{0}, {0}};
  scene.friction = {0.4};
  scene.duration = 0.3;
  const std::string question = bare_question(engine, scene, 1e-3, engine.default_parameters()) +
                               fmt::format("moving 0.5 0 0\nalong 1 locks {}\n", locks);
  const std::vector<double> places = bare_angles(engine.name, question);
  return places.back() - places.front();
}

/// Coulomb's law stops it after v²/(2μg); half a step's way is lost.
TEST(WebEngines, Rapier3DSlidesOnWhereNothingLeavesThePlane) {
  const WorkerEngine* engine = there("rapier3d:sequential-impulse");
  if (engine == nullptr) GTEST_SKIP() << "Rapier 3D is not there";
  EXPECT_NEAR(slide_in_rapier3d(*engine, all_locked), 0.15, 1e-4);
  EXPECT_NEAR(slide_in_rapier3d(*engine, locked_turns), 0.25 / (2 * 0.4 * 9.81), 5e-4);
}

/// The impulses of a manifold's points are the step's, those of friction nought, though friction holds the
/// block: where all points of a face share it (contact_with_twist_friction.rs) it is kept for a warm start
/// alone.
TEST(WebEngines, Rapier3DTellsWhatPressesAndNotWhatRubs) {
  const WorkerEngine* engine = there("rapier3d:sequential-impulse");
  if (engine == nullptr) GTEST_SKIP() << "Rapier 3D is not there";
  const Scene scene = block_held_by_friction();
  const double weight = scene.blocks[0].mass * scene.gravity;
  EXPECT_NEAR(borne(*engine, scene, pressing).back(), weight, 1e-3 * weight);
  EXPECT_EQ(borne(*engine, scene, rubbing).back(), 0);
  const std::vector<double> places = bare_angles(
      engine->name, bare_question(*engine, scene, 1e-3, engine->default_parameters()) + "along 1\n");
  EXPECT_NEAR(places.back(), places.front(), 1e-3);
}

/// A block on a higher one, let go together.
Scene pair_let_go() {
  Scene scene;
  scene.duration = 1;
  scene.blocks = {make_block(1, 2, 2500), make_block(1, 1, 2500)};
  scene.initial = {{0.1, 0.1}, {0, 0}};
  scene.friction.assign(2, 1000);
  return scene;
}

/// The contacts of a pair are found anew once it has drifted by 5 cm, and else taken for those that it had:
/// of two blocks that rock together, a corner that closes is not seen. With hooks contacts are always found.
TEST(WebEngines, RapierMissesCornersThatCloseBetweenBlocks) {
  for (const char* name : {"rapier:sequential-impulse", "rapier3d:sequential-impulse"}) {
    const WorkerEngine* engine = there(name);
    if (engine == nullptr) continue;
    SCOPED_TRACE(name);
    const auto typical_error = [engine](double hooks) {
      const Parameters parameters = with(engine->default_parameters(), {{"activeHooks", hooks}});
      std::vector<double> list;
      for (const Draw& draw : replicates(pair_let_go(), 1e-3, 5))
        list.push_back(error_of(
            draw, bare_angles(engine->name, bare_question(*engine, draw.scene, draw.dt, parameters))));
      return quartiles(list).median;
    };
    EXPECT_GT(typical_error(0), 3 * typical_error(1));
  }
}

}  // namespace
}  // namespace rockstack
