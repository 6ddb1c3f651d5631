// What is made of an engine's bodies, on bodies that are placed by hand and on real engines.

#include "engines/body_record.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "analytic/scene/kinematics.hpp"
#include "engines/scene_setup.hpp"
#include "tests/engines/linked_engines.hpp"

namespace rockstack {
namespace {

/// With centres of mass anywhere in blocks.
Scene random_stack(std::mt19937_64& random) {
  std::uniform_real_distribution<double> size(0.3, 3), angle(-0.3, 0.3), share(-0.9, 0.9);
  Scene scene;
  scene.duration = 1;
  for (int k = 0; k < 4; ++k) {
    Block& block = scene.blocks.emplace_back(make_block(size(random), size(random), 2500));
    block.offset_x = share(random) * block.half_width;
    block.offset_y = share(random) * block.half_height;
    scene.initial.angles.push_back(angle(random));
    scene.initial.velocities.push_back(0);
  }
  return scene;
}

BlockPose pose_of(const Placement& placement) {
  return {placement.x, placement.y, placement.angle};
}

/// Interface k of placed blocks.
InterfaceState interface_of(const Scene& scene, const std::vector<Placement>& placements, std::size_t k) {
  return k == 0 ? on_ground(scene.blocks[0], pose_of(placements[0]))
                : on_block(scene.blocks[k - 1], pose_of(placements[k - 1]), scene.blocks[k],
                           pose_of(placements[k]));
}

// Lengths of a few metres and a dozen operations: 1e-14 m is far above rounding.
constexpr double round_off = 1e-14;

TEST(Interfaces, StacksOnTheirPivotsNeitherPenetrateNorSlip) {
  std::mt19937_64 random(5);
  for (int round = 0; round < 200; ++round) {
    const Scene scene = random_stack(random);
    const auto placements = place(scene);
    for (std::size_t k = 0; k < placements.size(); ++k) {
      const InterfaceState state = interface_of(scene, placements, k);
      EXPECT_LE(state.depth, round_off) << round << " interface " << k;
      EXPECT_NEAR(state.slip, 0, round_off) << round << " interface " << k;
    }
  }
}

TEST(Interfaces, AStackThatIsPushedDownAndAlongShowsBoth) {
  std::mt19937_64 random(6);
  for (int round = 0; round < 200; ++round) {
    const Scene scene = random_stack(random);
    auto placements = place(scene);
    placements[0].y -= 0.002;
    placements[0].x += 0.003;
    const InterfaceState state = interface_of(scene, placements, 0);
    EXPECT_NEAR(state.depth, 0.002, round_off);
    EXPECT_NEAR(state.slip, 0.003, round_off);
  }
}

// Energy is nought where blocks stand upright in the middle, on a slope too, wherever their centres of mass
// are.
TEST(BodyRecords, EnergyIsFromAStackThatRestsUpright) {
  std::mt19937_64 random(8);
  for (int round = 0; round < 20; ++round) {
    Scene scene = random_stack(random);
    scene.inclination = 0.1;
    scene.initial.angles.assign(scene.blocks.size(), 0);
    const rockstack::Setup setup = set_up(scene, 0.5, {});
    Trajectory still;
    still.angles = still.velocities = std::vector<double>(4);
    for (const Placement& block : setup.blocks) still.bodies.push_back({.x = block.x, .y = block.y});
    const EngineRun run = engine_run_of(scene, setup, std::move(still), true);
    double weight = 0;
    for (const Block& block : scene.blocks) weight += block.mass * scene.gravity;
    EXPECT_NEAR(run.bodies->energy.front(), 0, round_off * weight);
    EXPECT_NEAR(run.bodies->slip, 0, round_off);
  }
}

// Over a time t slips grow by their rates, to the second order in t: here within 100 (m/s²) t².
TEST(Interfaces, StacksThatStartToSlipSlipAtTheRateThatWasAskedFor) {
  constexpr double t = 1e-6;
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> rate(-1, 1);
  for (int round = 0; round < 200; ++round) {
    Scene scene = random_stack(random);
    scene.law = Law::unilateral;
    for (std::size_t k = 0; k < scene.blocks.size(); ++k) {
      scene.initial.velocities[k] = rate(random);
      scene.initial.slip_velocities.push_back(rate(random));
    }
    auto placements = place(scene);
    for (Placement& placement : placements) {
      placement.x += t * placement.velocity_x;
      placement.y += t * placement.velocity_y;
      placement.angle += t * placement.angular_velocity;
    }
    for (std::size_t k = 0; k < placements.size(); ++k) {
      EXPECT_NEAR(interface_of(scene, placements, k).slip, t * scene.initial.slip_velocities[k], 100 * t * t)
          << round << " interface " << k;
    }
  }
}

/// A block that overhangs after it has slipped leans over the corner below.
TEST(Interfaces, SlipPastTheEndOfAFaceIsThatOfTheCornerBelow) {
  Scene scene;
  scene.blocks = {make_block(2, 1, 2500), make_block(2, 1, 2500)};
  const double slip = 0.25, angle = 0.1;
  // The lower block's right corner is where the upper one's face has 1 − slip of its half-width left.
  const Point<double> arm = turned(slip - 1, 0.5, std::cos(angle), std::sin(angle));
  const InterfaceState state =
      on_block(scene.blocks[0], {0, 0.5, 0}, scene.blocks[1], {1 + arm.x(), 1 + arm.y(), angle});
  EXPECT_NEAR(state.slip, slip, round_off);
  EXPECT_NEAR(state.depth, 0, round_off);
}

TEST(Interfaces, ABlockThatIsLiftedOffAnotherLeavesAGapOfThatSize) {
  Scene scene;
  scene.blocks = {make_block(2, 1, 2500), make_block(1, 2, 2500)};
  scene.initial = {{0.1, 0.1}, {0, 0}};
  auto placements = place(scene);
  // Along the normal of the face, which is turned clockwise by 0.1 rad.
  placements[1].x += 0.01 * std::sin(0.1);
  placements[1].y += 0.01 * std::cos(0.1);
  EXPECT_NEAR(interface_of(scene, placements, 1).depth, -0.01, round_off);
}

/// A body that flies as a thrown stone does, in even steps.
TEST(BodyRecords, EnergyOfFreeFlightIsConstantAndDriftOutOfThePlaneIsSeen) {
  Scene scene;
  scene.duration = 1;
  scene.blocks = {make_block(1, 1, 2500)};
  scene.initial = {{0}, {0.5}};
  constexpr double dt = 0.125;
  Trajectory stone;
  for (int step = 0; step <= 8; ++step) {
    const double time = step * dt;
    stone.angles.push_back(0);
    stone.velocities.push_back(0.5);
    stone.bodies.push_back({.x = 2 * time,
                            .y = 10 + 3 * time - 0.5 * 9.81 * time * time,
                            .velocity_x = 2,
                            .velocity_y = 3 - 9.81 * time,
                            .z = 1e-3 * time,
                            .tilt = 1e-4 * time});
  }
  const BodyRecord record = engine_run_of(scene, set_up(scene, dt, {}), stone, true).bodies.value();
  const Block& block = scene.blocks[0];
  const double expected = 0.5 * block.mass * (2 * 2 + 3 * 3) + 0.5 * block.inertia * 0.25 +
                          block.mass * scene.gravity * (10 - block.half_height);
  for (const double energy : record.energy) EXPECT_NEAR(energy, expected, 1e-12 * expected);
  EXPECT_EQ(record.out_of_plane, 1e-3);
  EXPECT_EQ(record.out_of_plane_tilt, 1e-4);
}

// Two cubes of 0.4 m: the upper hops, slides until nothing of the lower one is below it, and is back for a
// moment.
TEST(Bodies, ABlockHasFallenOffSinceItLastHadSomethingBelowIt) {
  Scene scene;
  scene.duration = 0.5;
  scene.blocks = {make_block(0.4, 0.4, 2500), make_block(0.4, 0.4, 2500)};
  scene.initial = {{0, 0}, {0, 0}};
  const double dt = 0.1, infinity = std::numeric_limits<double>::infinity();
  const auto since = [&](const std::vector<double>& places) {
    Trajectory cubes;
    for (const double x : places) {
      cubes.angles.insert(cubes.angles.end(), {0, 0});
      cubes.velocities.insert(cubes.velocities.end(), {0, 0});
      cubes.bodies.insert(cubes.bodies.end(), {{.x = 0, .y = 0.2}, {.x = x, .y = 0.7}});
    }
    const BodyRecord record = engine_run_of(scene, set_up(scene, dt, {}), cubes, true).bodies.value();
    EXPECT_EQ(record.centres.size(), 4 * places.size());
    EXPECT_EQ(record.centres[4], 0);
    EXPECT_EQ(record.centres[6], places[1]);
    return record.unsupported_since;
  };
  EXPECT_EQ(since({0, 0.3, 0.5, 0.3, 0.5, 0.6}), (std::vector<double>{infinity, 4 * dt}));
  EXPECT_EQ(since({0, 0.3, 0.5, 0.6, 0.5, 0.3}), (std::vector<double>{infinity, infinity}));
}

// Two cubes of 0.4 m: the upper one turns by 45° over the edge of the lower one, on which it still leans at
// the end.
TEST(Bodies, ABlockThatLiesOnTheGroundBesideItsBaseHasFallen) {
  Scene scene;
  scene.duration = 0.2;
  scene.blocks = {make_block(0.4, 0.4, 2500), make_block(0.4, 0.4, 2500)};
  scene.initial = {{0, 0}, {0, 0}};
  const double dt = 0.1, corner = 0.2 * std::numbers::sqrt2,
               infinity = std::numeric_limits<double>::infinity();
  Trajectory cubes;
  cubes.angles = {0, 0, 0, std::numbers::pi / 4, 0, std::numbers::pi / 4};
  cubes.velocities.assign(6, 0);
  for (const double height : {0.6, corner + 0.1, corner})
    cubes.bodies.insert(cubes.bodies.end(), {{.x = 0, .y = 0.2}, {.x = 0.39, .y = height}});
  const BodyRecord record = engine_run_of(scene, set_up(scene, dt, {}), cubes, true).bodies.value();
  EXPECT_EQ(record.unsupported_since, (std::vector<double>{infinity, 2 * dt}));
  // An engine that keeps a skin of 15 mm.
  for (BodyState& body : cubes.bodies) body.y += 0.015;
  const BodyRecord hovering = engine_run_of(scene, set_up(scene, dt, {}), cubes, true).bodies.value();
  EXPECT_EQ(hovering.unsupported_since, record.unsupported_since);
}

// A cube of 0.4 m on a plate of 0.2 m goes down through it, and lies on the ground where it stood.
TEST(Bodies, ABlockThatSinksThroughWhatItStandsOnHasNotFallenOff) {
  Scene scene;
  scene.duration = 0.2;
  scene.blocks = {make_block(0.4, 0.2, 2500), make_block(0.4, 0.4, 2500)};
  scene.initial = {{0, 0}, {0, 0}};
  Trajectory bodies;
  bodies.angles.assign(6, 0);
  bodies.velocities.assign(6, 0);
  for (const double height : {0.4, 0.3, 0.201})
    bodies.bodies.insert(bodies.bodies.end(), {{.x = 0, .y = 0.1}, {.x = 0.06, .y = height}});
  const BodyRecord record = engine_run_of(scene, set_up(scene, 0.1, {}), bodies, true).bodies.value();
  EXPECT_TRUE(std::ranges::all_of(record.unsupported_since, [](double time) { return std::isinf(time); }));
  EXPECT_NEAR(record.penetration.back(), 0.199, 1e-12);
}

/// A slender block under one sine in both directions that lifts it; it does not come back in time to hit.
Scene lifted_block() {
  Scene scene;
  scene.duration = 0.4;
  scene.blocks = {make_block(0.4, 2, 2500)};
  scene.initial = {{0}, {0}};
  scene.horizontal.pulse = Pulse{PulseShape::sine, 5, 0.8, 0, 1, 0};
  scene.vertical.pulse = Pulse{PulseShape::sine, 1.5, 0.5, 0, 1, 0};
  return scene;
}

/// Largest difference between energy and work, as a share of the largest energy.
double imbalance(const Engine& engine, double dt, double shaking) {
  Parameters parameters = engine.tuned_parameters();
  parameters["shaking"] = shaking;
  const BodyRecord record = simulate(engine, lifted_block(), dt, parameters, true).bodies.value();
  double apart = 0;
  for (std::size_t i = 0; i < record.energy.size(); ++i)
    apart = std::max(apart, std::abs(record.energy[i] - record.input[i]));
  return apart / *std::max_element(record.energy.begin(), record.energy.end());
}

TEST(BodyRecords, WorkOfTheGroundIsTheEnergyOfABlockThatDoesNotHitHoweverItIsShaken) {
  for (const auto& engine : linked_engines()) {
    for (const double shaking : {0.0, 1.0}) {
      const double coarse = imbalance(*engine, 2e-3, shaking), fine = imbalance(*engine, 5e-4, shaking);
      // Engines step at first order: a quarter of the step leaves about a quarter.
      EXPECT_LT(fine, 0.5 * coarse) << engine->solver << " " << shaking;
      EXPECT_LT(fine, 0.02) << engine->solver << " " << shaking;
    }
  }
}

TEST(BodyRecords, KeepsNothingUnlessAsked) {
  for (const auto& engine : linked_engines()) {
    EXPECT_FALSE(simulate(*engine, lifted_block(), 1e-3, engine->tuned_parameters()).bodies);
  }
}

TEST(BodyRecords, LeavesTheMotionAsItIs) {
  for (const auto& engine : linked_engines()) {
    const Parameters parameters = engine->tuned_parameters();
    EXPECT_EQ(simulate(*engine, lifted_block(), 1e-3, parameters, true).history.angles,
              simulate(*engine, lifted_block(), 1e-3, parameters).history.angles);
  }
}

}  // namespace
}  // namespace rockstack
