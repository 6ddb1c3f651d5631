// What is said of npm's engines (engines/web), by bare programs that share no code with their workers. A
// cause is one thing that is changed by itself. No set was tuned on these scenes.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "engines/scene_setup.hpp"
#include "engines/worker/registry.hpp"
#include "tests/engines/bare.hpp"
#include "tests/engines/findings/draws.hpp"

namespace rockstack {
namespace {

/// nullptr where node or the packages are not there.
const WorkerEngine* there(const std::string& name) {
  for (const WorkerEngine& engine : engines())
    if (engine.full_name() == name) return &engine;
  return nullptr;
}

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
  scene.engine.friction = friction;
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
    scene.engine.friction = 5;
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
