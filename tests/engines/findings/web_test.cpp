// What is said of npm's engines (engines/web), by bare programs that share no code with their workers. A
// cause is one thing that is changed by itself. No set was tuned on these scenes.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "engines/scene_setup.hpp"
#include "engines/worker/registry.hpp"
#include "tests/engines/bare.hpp"
#include "tests/engines/findings/draws.hpp"
#include "tests/engines/findings/web_engines.hpp"

namespace rockstack {
namespace {

/// The largest error of any replicate at any of two steps, rad.
double largest_error(const WorkerEngine& engine, const Scene& scene, const Parameters& parameters) {
  double most = 0;
  for (const double dt : {2e-3, 1e-3})
    for (const Draw& draw : replicates(scene, dt, 3))
      most = std::max(
          most,
          error_of(draw, bare_angles(engine.name, bare_question(engine, draw.scene, draw.dt, parameters))));
  return most;
}

/// Whatever ran before in a process that takes several runs, a run has the bits that it has in its own.
TEST(WebEngines, GiveTheSameBitsWhateverTheirProcessHasRun) {
  std::vector<Scene> scenes(3, slender_block(0.3));
  scenes[1].initial.angles = {0.05};
  scenes[2].blocks.push_back(make_block(0.3, 1, 2500));
  scenes[2].initial = {{0.05, 0.05}, {0, 0}};
  for (const WorkerEngine& engine : engines()) {
    if (engine.runs_per_process == 1) continue;
    SCOPED_TRACE(engine.full_name());
    const auto angles = [&](const Scene& scene, std::size_t runs) {
      WorkerEngine asked = engine;
      asked.runs_per_process = runs;
      return simulate(asked, scene, 1e-3, engine.tuned_parameters()).history.angles;
    };
    std::vector<std::vector<double>> alone;
    for (const Scene& scene : scenes) alone.push_back(angles(scene, 1));
    for (std::size_t i = 0; i < 6; ++i) {
      const std::size_t number = i < 3 ? i : 5 - i;
      EXPECT_EQ(angles(scenes[number], 6), alone[number]) << i;
    }
  }
}

/// A setting that alone takes most of the error away, and in the tuned set brings it back.
struct Cause {
  const char* engine;
  Parameters cure, harm;
};

/// PhysX has friction at points that are 4 cm apart still, Planck a skin of 1 cm, and cannon-es springs that
/// are soft for tonnes.
TEST(WebEngines, OneSettingCarriesTheErrorOfARockingBlock) {
  for (const auto& [name, cure, harm] :
       std::vector<Cause>{{"physx:pgs",
                           {{"frictionOffsetThreshold", 1e-3}},
                           {{"frictionOffsetThreshold", 0.04}, {"frictionCorrelationDistance", 0.025}}},
                          {"physx:tgs",
                           {{"frictionOffsetThreshold", 1e-3}},
                           {{"frictionOffsetThreshold", 0.04}, {"frictionCorrelationDistance", 0.025}}},
                          {"planck:sequential-impulse", {{"polygonRadius", 0}}, {{"polygonRadius", 0.01}}},
                          {"cannon-es:gauss-seidel",
                           {{"unitMass", 1}},
                           {{"unitMass", 0}, {"contactEquationStiffness", 1e7}}}}) {
    const WorkerEngine* engine = there(name);
    if (engine == nullptr) continue;
    SCOPED_TRACE(name);
    const Scene scene = slender_block(0.7);
    const double bad = largest_error(*engine, scene, engine->default_parameters());
    EXPECT_GT(bad, 3 * largest_error(*engine, scene, with(engine->default_parameters(), cure)));
    EXPECT_GT(largest_error(*engine, scene, with(engine->tuned_parameters(), harm)),
              3 * largest_error(*engine, scene, engine->tuned_parameters()));
  }
}

/// The largest angle of a flat block on ground that accelerates by 0.3 g, in cannon-es with springs that are
/// stiff enough, rad. By Coulomb's law it slides under friction below 0.2, and rocks, by 0.027 rad here,
/// above that.
double turn_on_pushed_ground(const WorkerEngine& engine, double dt, double friction) {
  Scene scene = slender_block(0.3);
  scene.initial = {{0}, {0}};
  scene.friction.assign(scene.blocks.size(), friction);
  scene.horizontal.interval = 10;
  scene.horizontal.samples = {0.3 * scene.gravity, 0.3 * scene.gravity};
  const Parameters stiff = with(engine.default_parameters(), {{"unitMass", 1},
                                                              {"iterations", 500},
                                                              {"tolerance", 0},
                                                              {"contactEquationStiffness", 1e9},
                                                              {"frictionEquationStiffness", 1e9}});
  double most = 0;
  for (const double angle : bare_angles(engine.name, bare_question(engine, scene, dt, stiff)))
    most = std::max(most, std::abs(angle));
  return most;
}

/// What carries the block along is 0.3 m g dt in a step. Four corners that hold μ m g by each, taken for an
/// impulse in N s, do that from μ = 0.075 dt/s on, at any step.
TEST(WebEngines, FrictionOfCannonIsAnImpulseThatKnowsNoStep) {
  const WorkerEngine* engine = there("cannon-es:gauss-seidel");
  if (engine == nullptr) GTEST_SKIP() << "cannon-es is not there";
  for (const double dt : {2e-3, 1e-3, 2.5e-4}) {
    EXPECT_LT(turn_on_pushed_ground(*engine, dt, 0.5 * 0.075 * dt), 1e-3) << dt;
    EXPECT_GT(turn_on_pushed_ground(*engine, dt, 2 * 0.075 * dt), 0.02) << dt;
    EXPECT_GT(turn_on_pushed_ground(*engine, dt, 0.1), 0.02) << dt;
  }
}

/// A block on ground that accelerates by 0.2 g, which a friction of 0.5 holds.
Scene held_on_a_slope() {
  Scene scene = slender_block(1);
  scene.blocks = {make_block(2, 1, 2500)};
  scene.initial = {{0}, {0}};
  scene.friction = {0.5};
  scene.horizontal.interval = 10;
  scene.horizontal.samples = {0.2 * scene.gravity, 0.2 * scene.gravity};
  return scene;
}

/// How fast that block creeps in MuJoCo 3 in its second half of a second, m/s.
double creep_in_mujoco(const WorkerEngine& engine, const Parameters& changes) {
  const Parameters parameters = with(engine.default_parameters(), changes);
  const std::vector<BodyState> bodies =
      run(engine, set_up(held_on_a_slope(), 1e-3, parameters), parameters, true).bodies;
  return std::abs(bodies.back().x - bodies.at(bodies.size() / 2).x) / 0.5;
}

/// What sticks is held by a dashpot of friction's own: the block creeps by its time constant, and by the
/// share of the normal's compliance that friction has.
TEST(WebEngines, FrictionsOwnTimeConstantMakesBlocksCreepInMuJoCo3) {
  const WorkerEngine* engine = there("mujoco-js:newton");
  if (engine == nullptr) GTEST_SKIP() << "MuJoCo 3 is not there";
  const double creep = creep_in_mujoco(*engine, {});
  EXPECT_GT(creep, 1e-4);
  const auto slower = [&](const Parameters& changes) { return creep / creep_in_mujoco(*engine, changes); };
  EXPECT_NEAR(slower({{"solreffriction_timeconst", 0.2}, {"solreffriction_dampratio", 1}}), 0.1, 1e-3);
  EXPECT_NEAR(slower({{"solreffriction_timeconst", 0.002}, {"solreffriction_dampratio", 1}}), 10, 0.1);
  EXPECT_NEAR(slower({{"impratio", 10}}), 10, 0.1);
}

/// Boxes have a way to touch of their own.
TEST(WebEngines, MuJoCo3sWaysForConvexShapesAreNotThoseOfBoxes) {
  const WorkerEngine* engine = there("mujoco-js:newton");
  if (engine == nullptr) GTEST_SKIP() << "MuJoCo 3 is not there";
  Scene scene = slender_block(0.7);
  scene.blocks.push_back(make_block(0.3, 1, 2500));
  scene.initial = {{0.1, 0.1}, {0, 0}};
  scene.friction.assign(2, 1);
  const std::string question = bare_question(*engine, scene, 1e-3, engine->default_parameters());
  EXPECT_EQ(bare_angles(engine->name, question), bare_angles(engine->name, question + "convex 1\n"));
}

/// How fast a block creeps in PhysX on ground that accelerates by 0.364 g, which a friction of 0.5 holds,
/// m/s.
double creep_in_physx(const WorkerEngine& engine, const Block& block, double dt, int bits) {
  Scene scene = slender_block(0.2);
  scene.blocks = {block};
  scene.initial = {{0}, {0}};
  scene.friction.assign(scene.blocks.size(), 0.5);
  scene.horizontal.interval = 10;
  scene.horizontal.samples = {0.364 * scene.gravity, 0.364 * scene.gravity};
  const std::string question =
      bare_question(engine, scene, dt, engine.default_parameters()) + fmt::format("along 1 bits {}\n", bits);
  const std::vector<double> places = bare_angles(engine.name, question);
  return std::abs(places.back() - places.front()) / scene.duration;
}

/// The ground's plane is turned upwards by a quaternion that is rounded. One last bit of an element, a turn
/// by 1e-7 rad, and nothing creeps.
TEST(WebEngines, RoundingOfTheGroundsFrameMakesBlocksCreepInPhysX) {
  const WorkerEngine* engine = there("physx:tgs");
  if (engine == nullptr) GTEST_SKIP() << "PhysX is not there";
  for (const Block& block : {make_block(0.2, 0.2, 25), make_block(0.4, 0.3, 2500)}) {
    double coarser = 0;
    for (const double dt : {1e-3, 3e-4, 1e-4}) {
      const double creep = creep_in_physx(*engine, block, dt, 0);
      EXPECT_GT(creep, 1.5 * coarser) << dt;
      EXPECT_GT(creep, 10 * creep_in_physx(*engine, block, dt, 1)) << dt;
      coarser = creep;
    }
  }
}

}  // namespace
}  // namespace rockstack
