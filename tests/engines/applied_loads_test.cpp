// Pushes, tendons and dampers: what engines are told of them, and what they make of it beside the exact
// motion.

#include "engines/applied_loads.hpp"

#include <gtest/gtest.h>

#include "analytic/solve.hpp"
#include "engines/body_record.hpp"
#include "engines/scene_setup.hpp"
#include "engines/worker/registry.hpp"

namespace rockstack {
namespace {

Setup one_block() {
  Setup setup;
  setup.blocks = {{.x = 0, .y = 1, .width = 1, .height = 2, .mass = 10}};
  return setup;
}

TEST(AppliedLoads, APushTurnsByItsArmAsTheBlockHasTurned) {
  rockstack::Setup setup = one_block();
  setup.pushes = {{{1, 0, 1}, 1, 0, {5, 0, -3}}};
  AppliedLoads loads(setup);
  const double angle = 0.3;
  const std::vector<BodyState> turned{{.y = 1, .angle = angle}};
  const BodyLoad first = loads.over_step(0, turned, {}).front();
  EXPECT_EQ(first.x, 5);
  EXPECT_EQ(first.y, 0);
  EXPECT_NEAR(first.moment, 5 * std::cos(angle), 1e-15);
  EXPECT_EQ(loads.over_step(2, turned, {}).front().x, -3);
  EXPECT_EQ(loads.over_step(3, turned, {}).front().x, 0) << "the scene is over";
}

TEST(AppliedLoads, WhatPullsTwoBlocksTogetherPullsBothAlike) {
  rockstack::Setup setup = one_block();
  setup.blocks.push_back(setup.blocks[0]);
  setup.restraints = {
      {.from = {1, 0.3, 0.5}, .to = {2, -0.2, 0.1}, .length = 1, .stiffness = 50, .damping = 7}};
  const std::vector<BodyState> blocks{
      {.x = 0.1, .y = 1, .velocity_x = 0.2, .angle = 0.2, .angular_velocity = -1},
      {.x = -0.3, .y = 3, .velocity_y = 0.4, .angle = -0.1, .angular_velocity = 2}};
  const std::vector<BodyLoad> loads = AppliedLoads(setup).over_step(0, blocks, {});
  EXPECT_EQ(loads[0].x, -loads[1].x);
  EXPECT_EQ(loads[0].y, -loads[1].y);
  // About the origin: clockwise moments and forces of both add to none.
  double sum = 0;
  for (std::size_t k = 0; k < 2; ++k)
    sum += loads[k].moment + blocks[k].y * loads[k].x - blocks[k].x * loads[k].y;
  EXPECT_NEAR(sum, 0, 1e-13 * std::abs(loads[0].moment));
}

TEST(AppliedLoads, ATendonIsElasticYieldsAndGoesSlack) {
  rockstack::Setup setup = one_block();
  setup.restraints = {
      {.from = {1, 0, 0}, .to = {0, -3, 1}, .length = 3, .stiffness = 100, .prestress = 10, .yield = 30}};
  AppliedLoads loads(setup);
  const auto pull_at = [&](double x) {
    return -loads.over_step(0, std::vector<BodyState>{{.x = x, .y = 1}}, {}).front().x;
  };
  const double rounding = 1e-12;
  EXPECT_NEAR(pull_at(0), 10, rounding) << "prestress";
  EXPECT_NEAR(pull_at(0.1), 20, rounding);
  EXPECT_NEAR(pull_at(0.5), 30, rounding) << "yields from 0.2 m on";
  EXPECT_NEAR(pull_at(0.4), 20, rounding) << "unloads elastically";
  EXPECT_EQ(pull_at(0.1), 0) << "slack from 0.2 m down";
  EXPECT_NEAR(pull_at(0.3), 10, rounding) << "taut again";
}

TEST(AppliedLoads, AnAnchorGoesWithTheGroundThatReallyMoves) {
  rockstack::Setup setup = one_block();
  setup.restraints = {{.from = {1, 0, 0}, .to = {0, 3, 1}, .length = 3, .stiffness = 100, .damping = 10}};
  setup.lookahead = 0.01;
  const GroundStep ground{0.2, 0, 0.5, 0};
  const double stretch = 0.2 + 0.01 * 0.5;
  EXPECT_NEAR(AppliedLoads(setup).over_step(0, std::vector<BodyState>{{.y = 1}}, ground).front().x,
              100 * stretch + 10 * 0.5, 1e-12);
}

/// A block that a push of half a second sets rocking.
Scene pushed() {
  Scene scene;
  scene.duration = 1.5;
  scene.blocks = {make_block(0.5, 2, 2500)};
  scene.initial = {{0}, {0}};
  Push push{{1, 0, 1.8}, 0, {}};
  push.force.pulse = Pulse{.shape = PulseShape::rectangle, .amplitude = 6000, .period = 0.3, .start = 0.1};
  scene.pushes = {push};
  return scene;
}

/// A column that a tendon and a damper bring back, without which it topples.
Scene tied() {
  Scene scene;
  scene.duration = 1;
  scene.blocks = {make_block(0.6, 3, 2500)};
  scene.initial = {{0}, {0.8}};
  Restraint tendon;
  tendon.from = {1, 0, 3};
  tendon.to = {0, 0, -0.5};
  tendon.stiffness = 1e6;
  tendon.prestress = 2e4;
  tendon.yield = 6e4;
  Restraint damper;
  damper.kind = RestraintKind::damper;
  damper.from = {1, -0.3, 0};
  damper.to = {0, -0.3, -0.3};
  damper.damping = 2e3;
  scene.restraints = {tendon, damper};
  return scene;
}

/// Largest angle difference of a tuned engine at 1 ms from the exact motion, rad.
double difference(const WorkerEngine& engine, const Scene& scene) {
  const History made = simulate(engine, scene, 1e-3, engine.tuned_parameters()).history;
  const History exact = solve(scene, {.sample_times = made.times});
  double apart = 0;
  for (std::size_t i = 0; i < std::min(made.size(), exact.size()); ++i)
    apart = std::max(apart, std::abs(made.angles_at(i)[0] - exact.angles_at(i)[0]));
  return made.size() == exact.size() ? apart : HUGE_VAL;
}

/// Engines that have these loads are as near to the exact motion as without: some mrad, as in the paper's
/// scene. Without the push the block stands, and without the tendon the column topples.
TEST(AppliedLoads, EnginesFollowTheExactMotion) {
  for (const char* name : {"bullet", "mujoco", "ode", "planck"}) {
    const EngineList found = engines_called(name);
    if (found.empty()) GTEST_SKIP() << name << " is not there";
    SCOPED_TRACE(name);
    EXPECT_LT(difference(found.front(), pushed()), 5e-3);
    EXPECT_LT(difference(found.front(), tied()), 5e-3);
  }
}

/// The work of pushes and restraints is what an engine's energy gains in flight.
TEST(AppliedLoads, TheirWorkIsWhatEnergyGains) {
  Scene scene = tied();
  scene.law = Law::unilateral;
  scene.duration = 0.2;
  scene.initial = {{0.1}, {0.5}};
  scene.initial.gaps = {5};
  scene.initial.slip_velocities = {0.3};
  scene.pushes = pushed().pushes;
  const EngineList found = engines_called("ode");
  if (found.empty()) GTEST_SKIP() << "ODE is not there";
  const WorkerEngine& engine = found.front();
  const double dt = 1e-5;
  const EngineRun run = simulate(engine, scene, dt, engine.tuned_parameters(), {}, true);
  const BodyRecord& record = *run.bodies;
  const double gained = record.energy.back() - record.energy.front();
  EXPECT_GT(std::abs(gained), 1000) << "J: the test must have something to see";
  // Semi-implicit Euler moves blocks by velocities of steps' ends: each step leaves the work F²h²/2m, and a
  // moment's.
  const Block& block = scene.blocks[0];
  const double force = 6e4 + 6e3 + block.mass * scene.gravity, moment = 6e4 * 1.5 + 6e3 * 0.3;
  const double left =
      (force * force / block.mass + moment * moment / block.inertia) * dt * scene.duration / 2;
  EXPECT_NEAR(record.input.back(), gained, left);
}

TEST(AppliedLoads, AnEngineThatIsToldOfNoneRefusesThemInOneLine) {
  const EngineDescription engine{.name = "one", .solver = "two"};
  EXPECT_NO_THROW(require_able(engine, Scene{}));
  for (const auto& [scene, message] : {std::pair{pushed(), "push: one:two is told of no forces on blocks"},
                                       {tied(), "restraint: one:two is told of no forces on blocks"}}) {
    try {
      require_able(engine, scene);
      ADD_FAILURE() << message;
    } catch (const std::runtime_error& error) {
      EXPECT_STREQ(error.what(), message);
    }
  }
}

}  // namespace
}  // namespace rockstack
