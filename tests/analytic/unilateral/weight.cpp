#include <gtest/gtest.h>

#include <cmath>

#include "tests/analytic/unilateral/scenes.hpp"

namespace rockstack {
namespace {

using testing::round_off;

TEST(UnilateralWeight, ABlockSlidesDownInclinedGround) {
  for (const double inclination : {-0.3, 0.1, 0.2}) {
    const double friction = 0.05;
    Scene scene = testing::with_friction(testing::single(1, 0.8, 1), friction);
    scene.inclination = inclination;
    const double pull = scene.gravity * (std::sin(std::abs(inclination)) - friction * std::cos(inclination));
    const History history = solve_unilateral(scene, {.validity = true});
    ASSERT_EQ(history.events.size(), 1U);
    EXPECT_NEAR(bodies_at_end(history).pose[0].x, std::copysign(pull / 2, inclination),
                round_off * scene.gravity);
    const Demand& force = history.forces[0];
    const double weight = scene.blocks[0].mass * scene.gravity * std::cos(inclination);
    EXPECT_NEAR(force.least_normal, weight, round_off * weight);
    EXPECT_NEAR(force.friction, friction, round_off);
  }
}

// Gravity along inclined ground is a steady acceleration of level ground, and gravity across it is less.
// Where an event leaves a force at zero to rounding, roundings say by how much a decision comes later, so
// that times may differ by some 10⁻⁷ √(H/g) from there on; most motions have no such event.
TEST(UnilateralWeight, InclinedGroundIsAPushAndLessGravity) {
  std::size_t events = 0;
  std::size_t exact = 0;
  for (std::uint64_t seed = 0; seed < 160; seed += 4) {
    Scene inclined = testing::rubbing_scene(seed);
    inclined.inclination = 0.002 * (double(seed) - 80);
    Scene level = inclined;
    level.inclination = 0;
    const Gravity gravity = gravity_of(inclined);
    level.horizontal = testing::pulse_of(PulseShape::rectangle, -gravity.along, 2 * level.duration);
    level.vertical =
        testing::pulse_of(PulseShape::rectangle, gravity.across - level.gravity, 2 * level.duration);
    const History one = solve_unilateral(inclined);
    const History other = solve_unilateral(level);
    for (std::size_t i = 0; i < std::min(one.events.size(), other.events.size()); ++i) {
      if (one.events[i].kind != other.events[i].kind) break;
      ++events;
      if (std::abs(one.events[i].time - other.events[i].time) < 1e-11) ++exact;
    }
  }
  EXPECT_GT(events, 200U);
  EXPECT_GT(exact, events * 9 / 10);
}

// About its corner a block with its centre of mass off the middle turns as a body of that arm.
TEST(UnilateralWeight, ACentreOfMassOffTheMiddleTurnsAboutTheCorner) {
  for (const double offset_x : {-0.2, 0.15}) {
    Scene scene = testing::with_friction(testing::single(0.5, 1, 1e-3), 2);
    Block& block = scene.blocks[0];
    block.offset_x = offset_x;
    block.offset_y = -0.3;
    scene.initial.angles = {0.1};
    const History history = solve_unilateral(scene);
    const double arm_x = -0.5 + offset_x;
    const double arm_y = 1 - 0.3;
    const double inertia = block.inertia + block.mass * (arm_x * arm_x + arm_y * arm_y);
    const double lever = arm_x * std::cos(0.1) + arm_y * std::sin(0.1);
    const double turning = block.mass * scene.gravity * lever / inertia;
    const Bodies<> last = bodies_at_end(history);
    // To the next order in t, θ⁗ t²/12 of it, which is below 10⁻⁵.
    EXPECT_NEAR(last.velocity[0].angle, turning * scene.duration, 1e-5 * std::abs(turning) * scene.duration);
    EXPECT_NEAR(last.pose[0].x,
                0.5 + arm_x * std::cos(last.pose[0].angle) + arm_y * std::sin(last.pose[0].angle), round_off);
    EXPECT_NEAR(last.pose[0].y, arm_y * std::cos(last.pose[0].angle) - arm_x * std::sin(last.pose[0].angle),
                round_off);
  }
}

}  // namespace
}  // namespace rockstack
