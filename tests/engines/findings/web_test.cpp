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
#include "tests/engines/findings/impact_laws.hpp"
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

/// A scene, and the same with one number moved to the next of 32 bits.
struct LastBit {
  Scene scene, next;
};

void to_next(double& value) {
  value = std::nextafter(static_cast<float>(value), 100.0F);
}

/// A block whose corner slides as it rocks; three that slide on each other, on ground that jerks; and a squat
/// block that falls back on one at rest, where friction is more than Bullet has.
std::vector<LastBit> last_bits() {
  Scene rocks = slender_block(0.4);
  rocks.law = Law::unilateral;
  rocks.blocks = {make_block(1, 2, 2500)};
  rocks.friction = {0.2};
  Scene slides = rocks;
  slides.blocks.assign(3, make_block(1, 0.5, 2500));
  slides.initial = {{0, 0, 0}, {0, 0, 0}};
  slides.friction = {0.3, 0.2, 0.11};
  slides.horizontal.pulse = Pulse{PulseShape::sine, 5, 0.3, 0, 1, 0};
  Scene falls = slender_block(0.4);
  falls.blocks = {make_block(1, 1, 2500), make_block(1, 0.8, 2500)};
  falls.initial = {{0, 0.2}, {0, 0}};
  std::vector<LastBit> list{{rocks, rocks}, {slides, slides}, {falls, falls}};
  to_next(list[0].next.friction.back());
  to_next(list[1].next.friction.back());
  to_next(list[2].next.initial.angles.back());
  return list;
}

/// Of Bullet in single precision, compiled in version 3.24 and as WebAssembly in 3.26, with the same
/// settings.
struct BothBullets {
  const WorkerEngine* compiled = there("bullet-single:sequential-impulse");
  const WorkerEngine* web = there("ammo:sequential-impulse");

  bool there_are() const { return compiled != nullptr && web != nullptr; }

  void expect_the_same(const Scene& scene, double dt) const {
    const auto velocities = [&](const WorkerEngine& engine, const Parameters& parameters) {
      return simulate(engine, scene, dt, parameters).history.velocities;
    };
    EXPECT_EQ(velocities(*web, web->default_parameters()),
              velocities(*compiled, compiled->default_parameters()));
    EXPECT_EQ(velocities(*web, web->tuned_parameters()),
              velocities(*compiled, with(compiled->tuned_parameters(), {{"warmstartingFactor", 0.85}})));
  }
};

/// What compiles them, and the version, change no bit.
TEST(WebEngines, AmmoHasTheBitsOfCompiledBullet) {
  const BothBullets bullets;
  if (!bullets.there_are()) GTEST_SKIP() << "one of them is not there";
  Scene pair = slender_block(1);
  pair.blocks = {make_block(1.25, 1.25, 2500), make_block(1, 2.5, 2500)};
  pair.initial = {{0.15, 0.15}, {0, 0}};
  std::vector<Scene> scenes{slender_block(1), pair};
  for (const LastBit& one : last_bits()) scenes.push_back(one.scene);
  for (const Scene& scene : scenes)
    for (const double dt : {1e-3, 2.5e-4}) bullets.expect_the_same(scene, dt);
}

/// So the scenes above tell whether both are told the same coefficients and the same start.
TEST(WebEngines, BulletTellsTheLastBitOfWhatItIsTold) {
  const WorkerEngine* engine = BothBullets{}.compiled;
  if (engine == nullptr) GTEST_SKIP() << "Bullet is not there";
  for (const auto& [scene, next] : last_bits()) {
    const auto velocities = [&](const Scene& one) {
      return simulate(*engine, one, 1e-3, engine->default_parameters()).history.velocities;
    };
    EXPECT_NE(velocities(scene), velocities(next));
  }
}

/// Neither is the square of its root, as both are rounded to 32 bits.
TEST(WebEngines, AmmoHasAnyCoefficientToTheBit) {
  const BothBullets bullets;
  if (!bullets.there_are()) GTEST_SKIP() << "one of them is not there";
  for (const double friction : {0.5, 0.2}) {
    const auto square = [](float root) { return root * root; };
    const auto wanted = static_cast<float>(friction);
    EXPECT_NE(square(std::sqrt(wanted)), wanted);
    for (const std::size_t blocks : {1U, 3U}) {
      Scene scene = last_bits()[1].scene;
      scene.blocks.resize(blocks);
      scene.initial = {std::vector<double>(blocks), std::vector<double>(blocks)};
      scene.friction.assign(blocks, friction);
      bullets.expect_the_same(scene, 1e-3);
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

/// What a landing leaves of 1 rad/s in Rapier, for a block of height over width r without weight.
double left_in_rapier(const WorkerEngine& engine, double r, double friction, double dt,
                      const Parameters& parameters, const std::string& more) {
  Scene scene;
  scene.gravity = 1e-9;
  scene.duration = 40.5 * dt;
  scene.blocks = {make_block(1, r, 500)};
  scene.initial = {{1e-9}, {-1}};
  scene.engine.friction = friction;
  const std::vector<double> angles =
      bare_angles(engine.name, moving_question(engine, scene, dt, parameters, more));
  return (angles.at(20) - angles.at(40)) / (20 * dt);
}

/// Normal impulses are found without friction, N₀, and then friction from them, once a substep. That friction
/// pushes the corner down by the share q = 3μr/(4 + r²) of what N₀ stopped. The next substep applies it once
/// more from its warm start, finds 2qN₀ for both, and then cuts friction to μ2qN₀. So N₀(1 + 2q) it is, where
/// Coulomb's law has N₀/(1 − q). More passes of a substep, or no warm start, give Coulomb's.
TEST(WebEngines, RapierFindsFrictionOnceInASubstep) {
  const WorkerEngine* engine = there("rapier:sequential-impulse");
  if (engine == nullptr) GTEST_SKIP() << "Rapier is not there";
  struct Shape {
    double r, friction, dt;
    Parameters set;
  };
  const Parameters standard = engine->default_parameters();
  for (const auto& [r, friction, dt, set] : {Shape{1.5, 0.2, 1e-3, standard},
                                             {2, 0.3, 3e-4, standard},
                                             {2, 0.3, 3e-4, engine->tuned_parameters()},
                                             {3, 0.1, 1e-4, standard}}) {
    const double q = 3 * friction * r / (4 + r * r);
    const double once = 1 - 6 * (1 - friction * r) / (4 + r * r) * (1 + 2 * q);
    const auto left = [&, r = r, friction = friction, dt = dt, set = set](const std::string& more) {
      return left_in_rapier(*engine, r, friction, dt, set, more);
    };
    SCOPED_TRACE(r);
    // Of gaps that close within a substep, 1e-9 m over 2e-5 s, and angles of 2e-3 rad, rounded to 1e-7 of
    // that.
    EXPECT_NEAR(left(""), once, 1e-3);
    EXPECT_NEAR(left("set num_internal_stabilization_iterations 16"), left_by_coulomb(r, friction), 1e-3);
    EXPECT_NEAR(left("set warmstart_coefficient 0"), left_by_coulomb(r, friction), 1e-3);
    EXPECT_GT(std::abs(once - left_by_coulomb(r, friction)), 0.01);
  }
}

/// A block of 1 m by 2 m, tilted by 0.3 rad, whose lowest corner comes down at 1 m/s and slides at ±3 m/s,
/// for a kilogram.
struct TiltedDrop {
  static constexpr double inertia = 5. / 12;
  double slip, friction;
  double across = 0.5 * std::cos(0.3) - std::sin(0.3), down = 0.5 * std::sin(0.3) + std::cos(0.3);
  double frictionless = 1 / (1 + across * across / inertia);  ///< normal impulse, N·s
  /// The share of what that stopped by which friction presses the corner down, or lifts it where it is below
  /// 0.
  double pressed = std::copysign(friction, slip) * across * down / inertia * frictionless;

  /// rad/s clockwise
  double spin(double normal) const {
    return (std::copysign(friction, slip) * down - across) * normal / inertia;
  }
};

/// The second scene: where friction lifts, the frictionless impulse is left as it is.
TEST(WebEngines, RapierDropsACornerByTheSameLaw) {
  const WorkerEngine* engine = there("rapier:sequential-impulse");
  if (engine == nullptr) GTEST_SKIP() << "Rapier is not there";
  constexpr double dt = 1e-4;
  for (const TiltedDrop& drop : {TiltedDrop{3, 0.3}, {-3, 0.3}, {3, 0.1}}) {
    Scene scene;
    scene.gravity = 1e-9;
    scene.duration = 25.5 * dt;
    scene.blocks = {make_block(1, 2, 500)};
    scene.initial = {{0.3}, {0}};
    scene.engine.friction = drop.friction;
    const auto spin = [&](const std::string& more) {
      const std::string question = bare_question(*engine, scene, dt, engine->default_parameters()) +
                                   fmt::format("moving {} -1 0\n{}\n", drop.slip, more);
      const std::vector<double> angles = bare_angles(engine->name, question);
      return (angles.at(25) - angles.at(5)) / (20 * dt);
    };
    SCOPED_TRACE(drop.slip);
    const double normal = drop.frictionless * (1 + 2 * std::max(0.0, drop.pressed));
    // In 2.5 ms a corner that slides goes on by a hundredth of what the block measures.
    EXPECT_NEAR(spin(""), drop.spin(normal), 0.01);
    EXPECT_NEAR(spin("set num_internal_stabilization_iterations 16"),
                drop.spin(drop.frictionless / (1 - drop.pressed)), 0.01);
  }
}

/// How far the top one of some blocks at rest stands too low in Rapier, m.
double sinking_in_rapier(const WorkerEngine& engine, std::size_t blocks, double frequency) {
  Scene scene = slender_block(0.1);
  scene.blocks.assign(blocks, make_block(1, 1, 2500));
  scene.initial = {std::vector<double>(blocks), std::vector<double>(blocks)};
  const Parameters parameters = with(engine.default_parameters(), {{"contact_natural_frequency", frequency}});
  const Trajectory motion = run(engine, set_up(scene, 1e-3, parameters), parameters, true);
  return static_cast<double>(blocks) - 0.5 - motion.bodies.back().y;
}

/// Contacts of the ground have their own.
TEST(WebEngines, RapierHasAnotherFrequencyOnTheGround) {
  const WorkerEngine* engine = there("rapier:sequential-impulse");
  if (engine == nullptr) GTEST_SKIP() << "Rapier is not there";
  EXPECT_EQ(sinking_in_rapier(*engine, 1, 5), sinking_in_rapier(*engine, 1, 300));
  EXPECT_GT(sinking_in_rapier(*engine, 2, 5), 1.5 * sinking_in_rapier(*engine, 2, 300));
}

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

/// The largest turn of a drum of three within a step of a bare program, rad.
double largest_turn_in_jolt(const WorkerEngine& engine, double dt, double convex_radius) {
  Scene scene;
  scene.duration = 0.4;
  scene.blocks.assign(3, make_block(1, 1, 2700));
  scene.initial = {{0.1, 0.1, 0.1}, {0, 0, 0}};
  Parameters set = engine.tuned_parameters();
  set["mConvexRadius"] = convex_radius;
  const std::vector<double> angles = bare_angles(engine.name, bare_question(engine, scene, dt, set));
  double most = 0;
  for (std::size_t i = 3; i < angles.size(); ++i) most = std::max(most, std::abs(angles[i] - angles[i - 3]));
  return most;
}

/// A drum that had all energy, that of three whose centre is 42 mm higher than where they stand, would turn
/// about its edge at 1.94 rad/s: ω² = 2 · 3 g · 0.0425 m/(2/3 m²). Without a convex radius the normal of a
/// contact is at times another one, and a drum is turned by a quarter of a radian at once; a tenth of a
/// millimetre prevents it.
TEST(WebEngines, JoltWithoutAConvexRadiusTurnsADrumAtOnce) {
  const WorkerEngine* engine = there("jolt:sequential-impulse");
  if (engine == nullptr) GTEST_SKIP() << "Jolt is not there";
  for (const double dt : {1e-3, 2.5e-4}) {
    EXPECT_GT(largest_turn_in_jolt(*engine, dt, 0), 0.2) << dt;
    EXPECT_LT(largest_turn_in_jolt(*engine, dt, 1e-4), 1.94 * dt) << dt;
  }
}

/// How fast a block creeps in PhysX on ground that accelerates by 0.364 g, which a friction of 0.5 holds,
/// m/s.
double creep_in_physx(const WorkerEngine& engine, const Block& block, double dt, int bits) {
  Scene scene = slender_block(0.2);
  scene.blocks = {block};
  scene.initial = {{0}, {0}};
  scene.engine.friction = 0.5;
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
