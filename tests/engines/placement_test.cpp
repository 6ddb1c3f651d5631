// What engines are told about blocks and ground.

#include "engines/placement.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "engines/simulation.hpp"

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
  scene.engine.depth = 2;
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

TEST(Placement, RefusesWhatEnginesAreNotTold) {
  const auto refusal = [](const Scene& scene) -> std::string {
    try {
      place(scene);
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return {};
  };
  Scene scene = leaning_stack();
  scene.restitution = {0.9, 0.9};
  EXPECT_EQ(refusal(scene), "restitution: must be left out for engines, whose impacts have no such ratio");
  scene.restitution.clear();
  scene.blocks[1].offset_y = 0.1;
  EXPECT_EQ(refusal(scene),
            "blocks.2.center_of_mass: must be left out for engines, which are given uniform boxes");
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

}  // namespace
}  // namespace rockstack
