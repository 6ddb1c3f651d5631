// Blocks on slopes, under Coulomb friction.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "analytic/solve.hpp"
#include "tests/analytic/unilateral/scenes.hpp"

namespace rockstack {
namespace {

using testing::round_off;
using testing::single;
using testing::with_friction;

constexpr double degree = std::numbers::pi / 180;

Scene on_slope(double width, double height, double degrees, double friction, double duration) {
  Scene scene = with_friction(single(width / 2, height / 2, duration), friction);
  scene.inclination = degrees * degree;
  return scene;
}

// It sticks up to tan of the slope, and needs that much, on either side.
TEST(Slopes, ABlockIsHeldUpToTheFrictionOfTheSlope) {
  for (const double degrees : {-20.0, 5.0, 20.0}) {
    const double needed = std::tan(std::abs(degrees) * degree);
    const History held = solve(on_slope(0.4, 0.1, degrees, 1.0001 * needed, 10), {.validity = true});
    EXPECT_TRUE(held.events.empty()) << degrees;
    EXPECT_NEAR(held.forces[0].friction, needed, round_off);
    EXPECT_FALSE(solve(on_slope(0.4, 0.1, degrees, 0.9999 * needed, 1)).events.empty()) << degrees;
  }
}

// ½ g (sin α − μ cos α) t².
TEST(Slopes, ABlockSlidesDown) {
  for (const double degrees : {-20.0, 20.0}) {
    const Scene scene = on_slope(0.2, 0.2, degrees, 0.2, 1);
    const double angle = std::abs(scene.inclination);
    const double way = scene.gravity / 2 * (std::sin(angle) - 0.2 * std::cos(angle));
    EXPECT_NEAR(way, 0.7557703420214288, round_off);
    const History history = solve(scene, {.sample_times = {0, 0.5, 1}});
    EXPECT_NEAR(history.slips[1], std::copysign(way / 4, degrees), round_off);
    EXPECT_NEAR(history.slips[2], std::copysign(way, degrees), round_off);
  }
}

// A block with the friction for it tips down the slope from its slenderness on.
TEST(Slopes, ABlockTipsFromItsSlendernessOn) {
  const double slenderness = std::atan(0.5) / degree;
  EXPECT_TRUE(solve(on_slope(0.2, 0.4, 0.9999 * slenderness, 1, 1)).events.empty());
  for (const double side : {-1.0, 1.0}) {
    const History tips = solve(on_slope(0.2, 0.4, side * 1.0001 * slenderness, 1, 1));
    ASSERT_FALSE(tips.events.empty());
    EXPECT_EQ(tips.events[0].kind, EventKind::opening);
    EXPECT_EQ(tips.events[0].to[0], side > 0 ? Contact::right : Contact::left);
  }
}

// The first turn about the lower corner: ω̇ = m g R sin(β − α)/I₀.
TEST(Slopes, ABlockBeginsToTipAtItsRate) {
  const Scene scene = on_slope(0.2, 0.4, 40, 10, 1e-3);
  const Block& block = scene.blocks[0];
  const double radius = std::hypot(block.half_width, block.half_height);
  const double rate = scene.gravity * block.mass * radius *
                      std::sin(scene.inclination - std::atan2(block.half_width, block.half_height)) /
                      (block.inertia + block.mass * radius * radius);
  const History history = solve(scene, {.sample_times = {0, 1e-3}});
  // The angle of 4 µrad turns the lever by as much.
  EXPECT_NEAR(history.velocities[1] / (rate * 1e-3), 1, 1e-5);
}

}  // namespace
}  // namespace rockstack
