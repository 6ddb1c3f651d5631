#include "comparisons/measures/metrics/contact/validity.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "analytic/solve.hpp"

namespace rockstack {
namespace {

Scene block_at_rest(double horizontal, double vertical) {
  Scene scene;
  scene.duration = 1;
  scene.blocks = {make_block(1.0, 2.0, 2500)};
  scene.initial = {{0}, {0}};
  scene.horizontal = {1.0, {0, horizontal}};
  scene.vertical = {1.0, {0, vertical}};
  return scene;
}

History solved(const Scene& scene) {
  return solve(scene, {.validity = true});
}

TEST(Validity, ABlockCarriedAlongNeedsFrictionOfItsAccelerationOverItsWeight) {
  // Demands are taken at the starts of steps; at rest the step is the piece between samples, so the last is
  // at 1 s.
  Scene scene = block_at_rest(3.0, -2.0);
  scene.duration = 2;
  scene.horizontal.samples.push_back(3.0);
  scene.vertical.samples.push_back(-2.0);
  const History history = solved(scene);
  ASSERT_TRUE(history.events.empty());  // b/h = 0.5 is more than 3/(9.81 − 2)
  EXPECT_NEAR(history.forces[0].friction, 3.0 / (9.81 - 2.0), 1e-14);
  EXPECT_EQ(history.forces[0].friction_time, 1.0);
  EXPECT_NEAR(history.forces[0].least_normal, scene.blocks[0].mass * (9.81 - 2.0), 1e-9);
}

TEST(Validity, FrictionThatAnImpactOfOneBlockNeeds) {
  Scene scene;
  scene.duration = 3;
  scene.blocks = {make_block(0.5, 2.0, 2500)};
  scene.initial = {{0.1}, {0}};
  // With velocity ratio η = 1 − 1.5 sin²α, the centre's change of velocity is h (1 − η) along the ground and
  // b (1 + η) upwards, per unit of angular velocity before.
  const double sine = 0.5 / std::hypot(0.5, 2.0);
  const double cosine = 2.0 / std::hypot(0.5, 2.0);
  const double expected = 1.5 * sine * cosine / (2 - 1.5 * sine * sine);
  EXPECT_NEAR(solved(scene).impulses[0].friction, expected, 1e-11);
}

TEST(Validity, NothingIsKeptUnlessAskedFor) {
  EXPECT_TRUE(solve(block_at_rest(1, 0)).forces.empty());
}

TEST(Validity, WarnsOfTooLittleFrictionAndOfLiftingOff) {
  Scene slippery = block_at_rest(3.0, 0);
  slippery.duration = 2;
  slippery.horizontal.samples.push_back(3.0);
  slippery.engine.friction = 0.25;
  const auto slip = validity_warnings(slippery, solved(slippery));
  ASSERT_EQ(slip.size(), 1u);
  EXPECT_EQ(slip[0],
            "interface 1 needs friction 0.3058 for the force at t = 1 s, the scene has 0.25: blocks would "
            "slip, first "
            "at t = 0.8175 s");
  slippery.engine.friction = 0.31;
  EXPECT_TRUE(validity_warnings(slippery, solved(slippery)).empty());

  // A ground that falls faster than the block: the model turns it about a corner, a real block would fly.
  Scene falling = block_at_rest(0.5, -12.0);
  falling.duration = 1.1;
  falling.horizontal.samples.push_back(0.5);
  falling.vertical.samples.push_back(-12.0);
  const auto lift = validity_warnings(falling, solved(falling));
  ASSERT_FALSE(lift.empty());
  EXPECT_NE(lift[0].find("interface 1 would have to pull, normal force -"), std::string::npos) << lift[0];
}

TEST(Validity, InfiniteRatiosAreNullInJson) {
  History history;
  history.forces = {{-1.0, 0.5, std::numeric_limits<double>::infinity(), 0.5}};
  history.impulses.resize(1);
  const auto json = validity_json(history);
  EXPECT_TRUE(json[0]["forces"]["friction"].is_null());
  EXPECT_EQ(json[0]["forces"]["least_normal"], -1.0);
  EXPECT_TRUE(json[0]["impulses"]["least_normal"].is_null());
}

}  // namespace
}  // namespace rockstack
