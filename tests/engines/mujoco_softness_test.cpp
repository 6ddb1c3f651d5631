// The springs that MuJoCo's settings stand for (engines/mujoco/README.md), in a block that rests on them.

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "engines/scene_setup.hpp"
#include "tests/engines/linked_engines.hpp"

namespace rockstack {
namespace {

constexpr double mass = 1250;  // kg
constexpr double impedance = 0.9, time_constant = 0.02, damping_ratio = 1.5;

/// Contacts of a block that has come to rest on the ground, with its own stiffness and damping at any depth.
std::vector<ContactPoint> contacts_at_rest(const Engine& engine, double friction, double cone) {
  Scene scene;
  scene.duration = 2;
  scene.blocks = {make_block(1, 0.5, mass / 0.5)};
  scene.initial = {{0}, {0}};
  scene.friction = {friction};
  scene.law = Law::unilateral;
  Parameters parameters = engine.default_parameters();
  parameters["cone"] = cone;
  parameters["solref_timeconst"] = time_constant;
  parameters["solref_dampratio"] = damping_ratio;
  parameters["solimp_d0"] = parameters["solimp_dwidth"] = impedance;
  const Setup setup = set_up(scene, 1e-3, parameters);
  const auto simulation = engine.start(setup, parameters);
  EXPECT_TRUE(simulation->watch_contacts());
  for (std::size_t step = 0; step < setup.steps; ++step) simulation->step();
  return simulation->contacts();
}

class MujocoSoftness : public testing::TestWithParam<const Engine*> {};

/// Time constants are some 30 ms, so that after 2 s rounding is left of the way down.
TEST_P(MujocoSoftness, RestingBlockPressesAsItsSpringsSay) {
  const std::vector<ContactPoint> points = contacts_at_rest(*GetParam(), 0.5, 1);
  ASSERT_EQ(points.size(), 4U);
  double weight = 0;
  for (const ContactPoint& point : points) {
    const double gives = (1 - impedance) * time_constant;
    EXPECT_NEAR(point.stiffness * gives * time_constant * damping_ratio * damping_ratio / (1.5 * mass), 1,
                1e-9);
    EXPECT_NEAR(point.damping * gives / (3 * mass), 1, 1e-9);
    EXPECT_NEAR(point.normal / (-point.stiffness * point.gap * 1e-3), 1, 1e-6);
    weight += point.normal / 1e-3;
  }
  EXPECT_NEAR(weight / (mass * 9.81), 1, 1e-6);
}

TEST_P(MujocoSoftness, PyramidIsSofterTheMoreFrictionItHas) {
  for (const double friction : {0.3, 1.0, 3.0}) {
    const double elliptic = contacts_at_rest(*GetParam(), friction, 1).at(0).stiffness;
    const ContactPoint point = contacts_at_rest(*GetParam(), friction, 0).at(0);
    const double squared = friction * friction;
    EXPECT_NEAR(point.stiffness / elliptic * squared * (1 + squared) / 2, 1, 1e-9) << friction;
    EXPECT_NEAR(point.normal / (-point.stiffness * point.gap * 1e-3), 1, 1e-5) << friction;
  }
}

/// With the solver that comes to rest most exactly: what springs are does not depend on it.
std::vector<const Engine*> mujocos() {
  std::vector<const Engine*> list;
  for (const auto& engine : linked_engines()) {
    if (engine->name == "mujoco" && engine->solver == "newton") list.push_back(engine);
  }
  return list;
}

GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(MujocoSoftness);
INSTANTIATE_TEST_SUITE_P(Engines, MujocoSoftness, testing::ValuesIn(mujocos()),
                         [](const auto& engine) { return engine.param->solver; });

}  // namespace
}  // namespace rockstack
