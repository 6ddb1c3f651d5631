// What engines are told about blocks and ground.
// A ground that really moves: its displacement is the double integral of the accelerations.

#include "engines/scene_setup.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "analytic/scene/solve_options.hpp"
#include "analytic/unilateral/contact/initial_contacts.hpp"
#include "engines/simulation.hpp"
#include "tests/analytic/solver/stacks.hpp"

namespace rockstack {
namespace {

GroundMotion sampled(double interval, std::vector<double> samples) {
  GroundMotion motion;
  motion.interval = interval;
  motion.samples = std::move(samples);
  return motion;
}

Scene leaning_stack() {
  Scene scene;
  scene.duration = 1;
  scene.blocks = {make_block(1.25, 1.25, 2500), make_block(1, 2.5, 2500)};
  scene.initial = {{0.1, -0.05}, {0.2, 0.3}};
  scene.depth = 2;
  return scene;
}

/// World position of a point of a block, x and y from its centre before it turned.
std::pair<double, double> corner(const Placement& block, double x, double y) {
  const double c = std::cos(block.angle);
  const double s = std::sin(block.angle);
  return {block.x + x * c + y * s, block.y - x * s + y * c};
}

TEST(Placement, PivotsTouch) {
  const auto blocks = place(leaning_stack());
  // The lower block leans right on its right corner, the upper one left on its own left corner.
  EXPECT_NEAR(corner(blocks[0], 0.625, -0.625).second, 0, 1e-15);
  const auto on_base = corner(blocks[0], -0.5, 0.625);
  const auto pivot = corner(blocks[1], -0.5, -1.25);
  EXPECT_NEAR(on_base.first, pivot.first, 1e-15);
  EXPECT_NEAR(on_base.second, pivot.second, 1e-15);
}

// Two derivations: blocks of a chain that are moved, and joints of free bodies. Some ten operations on
// metres.
TEST(Placement, IsTheStartOfTheExactMotion) {
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    testing::Draw draw(seed);
    Scene scene = testing::seeded_scene(seed);
    scene.law = Law::unilateral;
    const std::size_t size = scene.blocks.size();
    InitialState& initial = scene.initial;
    for (std::vector<double>* values :
         {&initial.offsets, &initial.gaps, &initial.slip_velocities, &initial.gap_velocities})
      values->assign(size, 0);
    for (std::size_t k = 0; k < size; ++k) {
      Block& block = scene.blocks[k];
      block.offset_x = draw.coin() ? 0 : draw.between(-0.9, 0.9) * block.half_width;
      block.offset_y = draw.coin() ? 0 : draw.between(-0.9, 0.9) * block.half_height;
      initial.offsets[k] = draw.coin() ? 0 : draw.between(-0.8, 0.8) * scene.blocks[k].half_width;
      initial.slip_velocities[k] = draw.coin() ? 0 : draw.between(-1, 1);
      if (draw.coin()) continue;
      initial.gaps[k] = draw.between(0, 1);
      initial.gap_velocities[k] = draw.between(-1, 1);
    }
    const auto bodies = initial_contacts(contact_model_of<double>(scene), initial).bodies;
    const auto blocks = place(scene);
    for (std::size_t k = 0; k < size; ++k) {
      EXPECT_NEAR(blocks[k].x, bodies.pose[k].x, 1e-13) << seed;
      EXPECT_NEAR(blocks[k].y, bodies.pose[k].y, 1e-13) << seed;
      EXPECT_NEAR(blocks[k].velocity_x, bodies.velocity[k].x, 1e-13) << seed;
      EXPECT_NEAR(blocks[k].velocity_y, bodies.velocity[k].y, 1e-13) << seed;
      EXPECT_EQ(blocks[k].angular_velocity, bodies.velocity[k].angle) << seed;
    }
  }
}

TEST(Placement, VelocitiesAreThoseOfThePositions) {
  Scene scene = leaning_stack();
  const auto now = place(scene);
  const double dt = 1e-6;
  for (std::size_t k = 0; k < 2; ++k) scene.initial.angles[k] += dt * scene.initial.velocities[k];
  const auto later = place(scene);
  for (std::size_t k = 0; k < 2; ++k) {
    // A difference over dt is off by dt/2 of the acceleration, here below 1 m/s².
    EXPECT_NEAR((later[k].x - now[k].x) / dt, now[k].velocity_x, dt);
    EXPECT_NEAR((later[k].y - now[k].y) / dt, now[k].velocity_y, dt);
  }
}

TEST(Placement, InertiasAreThoseOfTheBox) {
  const Placement base = place(leaning_stack())[0];
  EXPECT_DOUBLE_EQ(base.inertia_about_x, base.mass * (2.0 * 2.0 + 1.25 * 1.25) / 12);
  EXPECT_DOUBLE_EQ(base.inertia_about_y, base.mass * (2.0 * 2.0 + 1.25 * 1.25) / 12);
  EXPECT_DOUBLE_EQ(base.inertia, leaning_stack().blocks[0].inertia);
}

TEST(Placement, GravityIsInTheAxesOfAnInclinedGround) {
  Scene scene = leaning_stack();
  scene.inclination = 0.1;
  scene.horizontal = sampled(1, {2, 2});
  const BodyAcceleration acceleration = body_acceleration(scene, 0, 1);
  EXPECT_DOUBLE_EQ(acceleration.x, scene.gravity * std::sin(0.1) - 2);
  EXPECT_DOUBLE_EQ(acceleration.y, -scene.gravity * std::cos(0.1));
}

// An engine's own names for both; its threshold is the least that it takes.
TEST(Restitution, GoesIntoTheSettingsThatAreForIt) {
  EngineDescription engine;
  engine.name = "some";
  engine.solver = "one";
  engine.settings = {
      {.name = "bounce", .most = 1, .role = SettingRole::restitution},
      {.name = "bounce_vel", .default_value = 0.2, .least = 0.01, .role = SettingRole::restitution_threshold},
      {.name = "other", .default_value = 3}};
  Scene scene = leaning_stack();
  const Parameters standard = engine.default_parameters();
  EXPECT_EQ(with_restitution(engine, scene, standard), standard);
  scene.point_restitution = 0.8;
  const Parameters expected{{"bounce", 0.8}, {"bounce_vel", 0.01}, {"other", 3}};
  EXPECT_EQ(with_restitution(engine, scene, standard), expected);
  EXPECT_NO_THROW(require_able(engine, scene));
  engine.settings.erase(engine.settings.begin());
  try {
    require_able(engine, scene);
    FAIL() << "an engine without a coefficient takes it";
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(), "contact.restitution: some:one has no coefficient of restitution");
  }
}

// The ratio of a rocking block is of the exact solver alone: engines run without it.
TEST(CentreOfMass, OffTheMiddleIsForEnginesThatSayThatTheyKnowIt) {
  EngineDescription engine;
  engine.name = "some";
  engine.solver = "one";
  Scene scene = leaning_stack();
  scene.restitution = {0.9, 0.9};
  EXPECT_NO_THROW(require_able(engine, scene));
  scene.blocks[1].offset_y = 0.1;
  try {
    require_able(engine, scene);
    FAIL() << "an engine of centred boxes takes it";
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(),
                 "blocks.2.center_of_mass: some:one has centres of mass in the middle of its boxes");
  }
  engine.capabilities.center_of_mass = true;
  EXPECT_NO_THROW(require_able(engine, scene));
}

TEST(Placement, GroundMotionPushesTheOtherWay) {
  Scene scene = leaning_stack();
  scene.horizontal = sampled(1, {0, 2});
  scene.vertical = sampled(1, {1, 1});
  const BodyAcceleration acceleration = body_acceleration(scene, 0.25, 0.75);
  EXPECT_DOUBLE_EQ(acceleration.x, -1);
  EXPECT_DOUBLE_EQ(acceleration.y, -scene.gravity - 1);
}

TEST(Placement, AnglesRunOnPastHalfATurn) {
  const double pi = std::numbers::pi;
  EXPECT_NEAR(unwrap(-pi + 0.1, pi - 0.1), pi + 0.1, 1e-14);
  EXPECT_NEAR(unwrap(0.2, 4 * pi), 4 * pi + 0.2, 1e-14);
}

/// Displacement after `steps` steps, m.
double displacement(const GroundMotion& horizontal, double dt, int steps) {
  Scene scene;
  scene.horizontal = horizontal;
  return ground_path(scene, dt, static_cast<std::size_t>(steps) + 1).back().x;
}

GroundMotion pulse(PulseShape shape) {
  GroundMotion motion;
  motion.pulse = Pulse{shape, 3, 0.5, 0.1, 1, 0};
  return motion;
}

TEST(GroundPath, FollowsASineToRounding) {
  // A sin(ωt): x = A/ω (t − sin(ωt)/ω) from its start; after its period the ground is still again, A T²/2π
  // on.
  const double omega = 2 * std::numbers::pi / 0.5;
  for (const double dt : {0.03, 0.01, 0.007}) {
    const int steps = static_cast<int>(0.35 / dt);
    const double t = steps * dt - 0.1;
    EXPECT_NEAR(displacement(pulse(PulseShape::sine), dt, steps),
                3 / omega * (t - std::sin(omega * t) / omega), 1e-14);
    EXPECT_NEAR(displacement(pulse(PulseShape::sine), dt, static_cast<int>(2 / dt)), 3 / omega * 0.5, 1e-13);
  }
}

TEST(GroundPath, FollowsARectangleWhereverItBeginsAndEndsInAStep) {
  // A t²/2 for T, then A T for ever.
  for (const double dt : {0.04, 0.035, 0.3}) {
    const int steps = static_cast<int>(1.5 / dt);
    const double t = steps * dt - 0.6;
    EXPECT_NEAR(displacement(pulse(PulseShape::rectangle), dt, steps), 0.5 * 3 * 0.5 * 0.5 + 3 * 0.5 * t,
                1e-13);
  }
}

TEST(GroundPath, IsACubicBetweenSamples) {
  // A triangle 0, 2, 0 over 2 s: x = t³/3 up to 1 s, and by symmetry 2 (t − 1) after 2 s.
  GroundMotion motion;
  motion.interval = 1;
  motion.samples = {0, 2, 0};
  for (const double dt : {0.25, 0.07, 0.3}) {
    const int early = static_cast<int>(0.9 / dt);
    EXPECT_NEAR(displacement(motion, dt, early), std::pow(early * dt, 3) / 3, 1e-14);
    const int late = static_cast<int>(3 / dt);
    EXPECT_NEAR(displacement(motion, dt, late), 2 * (late * dt - 1), 1e-13);
  }
}

TEST(GroundPath, VelocityOfAStepCarriesToTheNextDisplacement) {
  Scene scene;
  scene.horizontal = pulse(PulseShape::ricker);
  scene.vertical = pulse(PulseShape::cosine);
  GroundStep last;
  for (const GroundStep& next : ground_path(scene, 0.01, 201)) {
    // Displacements reach a few metres: a few roundings of them.
    ASSERT_NEAR(next.x, last.x + 0.01 * last.velocity_x, 1e-14);
    ASSERT_NEAR(next.y, last.y + 0.01 * last.velocity_y, 1e-14);
    last = next;
  }
}

TEST(SetUp, OfManyStepsEndsWhereItIsCancelled) {
  Scene scene = leaning_stack();
  scene.horizontal = pulse(PulseShape::ricker);
  const std::function<bool()> cancelled = [] { return true; };
  for (const double moving : {0, 1}) {
    const Parameters shaking{{"shaking", moving}};
    EXPECT_THROW(set_up(scene, 1e-5, shaking, &cancelled), Stopped);
    EXPECT_EQ(set_up(scene, 1e-3, shaking, &cancelled).steps, 1000U);
  }
}

}  // namespace
}  // namespace rockstack
