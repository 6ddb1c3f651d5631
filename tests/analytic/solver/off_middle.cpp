#include <gtest/gtest.h>

#include <cmath>

#include "tests/analytic/solver/stacks.hpp"

namespace rockstack {
namespace {

/// A block 0.5 m × 2 m whose centre of mass is to the right of its middle, and below it.
Scene lopsided(double angle, double duration) {
  Block block = testing::block(0.5, 2);
  block.offset_x = 0.06;
  block.offset_y = -0.25;
  return testing::released({block}, {angle}, duration);
}

/// From an edge to the centre of mass: how far aside and up, m.
struct Arm {
  double x, y;
  double inertia;  ///< of the block about the edge, kg·m²

  Arm(const Block& block, double side)
      : x(block.half_width - side * block.offset_x),
        y(block.half_height + block.offset_y),
        inertia(block.inertia + block.mass * (x * x + y * y)) {}
};

TEST(OffMiddle, ABlockRestsUpToTheLeverOfEitherEdge) {
  for (const double push : {1.0, -1.0}) {
    Scene scene = lopsided(0, 2);
    scene.horizontal = {2, {0, push * 8}};
    // A ground that is pushed to the right turns the block about its left edge.
    const Arm arm(scene.blocks[0], -push);
    const Event opening = solve(scene).events.at(0);
    EXPECT_EQ(opening.kind, EventKind::opening);
    EXPECT_EQ(opening.to[0], push > 0 ? Contact::left : Contact::right);
    EXPECT_NEAR(opening.time, scene.gravity * arm.x / arm.y / 4, 1e-12);
  }
}

// By energy the centre falls from R cos(γ − θ) above its edge to R cos γ, with γ = atan(x/y) of the arm; the
// impact keeps angular momentum about the other edge, I_c + m r·r' of I_c + m r'².
TEST(OffMiddle, ABlockLandsByItsEnergyAndKeepsItsAngularMomentum) {
  for (const double side : {1.0, -1.0}) {
    const Scene scene = lopsided(0.08 * side, 2);
    const Block& block = scene.blocks[0];
    const Arm from(block, side), to(block, -side);
    const double radius = std::hypot(from.x, from.y);
    const double lean = std::atan2(from.x, from.y);
    const double square =
        2 * block.mass * scene.gravity * radius / from.inertia * (std::cos(lean - 0.08) - std::cos(lean));
    const double kept = (block.inertia + block.mass * (from.y * to.y - from.x * to.x)) / to.inertia;
    const Event impact = solve(scene).events.at(0);
    EXPECT_EQ(impact.kind, EventKind::impact);
    EXPECT_NEAR(impact.before[0], -side * std::sqrt(square), 1e-12);
    EXPECT_NEAR(impact.after[0] / impact.before[0], kept, 1e-12);
  }
}

/// A stack of two lopsided blocks under a moving ground.
Scene lopsided_stack() {
  Scene scene = testing::released({testing::block(1, 2), testing::block(0.7, 1.6)}, {0.05, 0.09}, 1.2);
  scene.blocks[0].offset_x = -0.08;
  scene.blocks[0].offset_y = 0.2;
  scene.blocks[1].offset_x = 0.1;
  scene.blocks[1].offset_y = -0.3;
  Pulse pulse;
  pulse.amplitude = 2;
  pulse.period = 0.8;
  scene.horizontal.pulse = pulse;
  return scene;
}

// The series and the general rule share no line of the equations of motion.
TEST(OffMiddle, SeriesOfAStackAgreeWithRungeAndKutta) {
  const Scene scene = lopsided_stack();
  SolveOptions options{.sample_times = regular_times(0.05, scene.duration)};
  const History series = solve(scene, options);
  options.integrator = Integrator::rk4;
  const History steps = solve(scene, options);
  ASSERT_EQ(series.events.size(), steps.events.size());
  for (std::size_t i = 0; i < series.angles.size(); ++i) EXPECT_NEAR(series.angles[i], steps.angles[i], 1e-9);
}

// Two blocks that rock as one body are one block with the centre of mass of both.
TEST(OffMiddle, ABlockIsTheTwoThatItIsMadeOf) {
  Scene pair = testing::released({testing::block(1, 2), testing::block(1, 0.5)}, {0.1, 0.1}, 0.3);
  pair.blocks[1].mass *= 0.25;
  pair.blocks[1].inertia *= 0.25;
  const Block &low = pair.blocks[0], &high = pair.blocks[1];
  Block whole;
  whole.half_width = 0.5;
  whole.half_height = 1.25;
  whole.mass = low.mass + high.mass;
  const double low_place = 1, high_place = 2.25;
  const double centre = (low.mass * low_place + high.mass * high_place) / whole.mass;
  whole.offset_y = centre - whole.half_height;
  whole.inertia = low.inertia + low.mass * std::pow(centre - low_place, 2) + high.inertia +
                  high.mass * std::pow(high_place - centre, 2);
  const Scene one = testing::released({whole}, {0.1}, 0.3);
  const SolveOptions options{.sample_times = regular_times(0.05, 0.3)};
  const History of_pair = solve(pair, options), of_one = solve(one, options);
  ASSERT_TRUE(of_pair.events.empty()) << testing::listing(of_pair);
  for (std::size_t i = 0; i < of_one.size(); ++i)
    EXPECT_NEAR(of_pair.angles_at(i)[0], of_one.angles_at(i)[0], 1e-13);
}

TEST(OffMiddle, IsRefusedWhereItHasNoMeaning) {
  const auto refusal = [](const Scene& scene) -> std::string {
    try {
      validate(scene);
    } catch (const FieldError& error) {
      return error.what();
    }
    return {};
  };
  Scene scene = lopsided(0, 1);
  scene.blocks[0].offset_x = 0.25;
  EXPECT_EQ(refusal(scene), "blocks.1.center_of_mass.1 = 0.25: must be inside the block, between ±0.25 m");
  scene = lopsided(0, 1);
  scene.equations = Equations::small_angle;
  EXPECT_EQ(refusal(scene).find("blocks.1.center_of_mass = [0.06, -0.25]: must be [0, 0] in small-angle"),
            0U);
  scene.equations = Equations::nonlinear;
  scene.restitution = {0.9};
  EXPECT_EQ(refusal(scene).find("blocks.1.center_of_mass = [0.06, -0.25]: must be [0, 0] beside"), 0U);
}

}  // namespace
}  // namespace rockstack
