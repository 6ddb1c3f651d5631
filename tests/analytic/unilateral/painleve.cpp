#include <gtest/gtest.h>

#include <cmath>

#include "tests/analytic/unilateral/scenes.hpp"
#include "tests/analytic/unilateral/time_stepping.hpp"

namespace rockstack {
namespace {

/// A block on its right corner that slides as told.
History sliding_on_its_corner(double slip_rate, double friction, double duration) {
  Scene scene = testing::with_friction(testing::single(0.5, 1, duration), friction);
  scene.initial.angles = {0.2};
  scene.initial.slip_velocities = {slip_rate};
  return solve_unilateral(scene);
}

bool tells(const History& history, Consistency consistency) {
  for (const Event& event : history.events)
    if (event.consistency == consistency) return true;
  return false;
}

// Painlevé 1895: at a sliding corner whose friction turns the block onto it, G_NN ≤ μ |G_NT|, no forces
// satisfy the laws of contact: an impulse stops the slip. Of the uniform block leaning by θ, with arms a and
// c of its centre along and above the ground, m G_NN = 1 + 3a²/(b² + h²) and m G_NT = 3ac/(b² + h²).
TEST(UnilateralPainleve, WhereNoForcesDoAnImpulseIsToldAndTakesEnergy) {
  const double a = 0.5 * std::cos(0.2) - std::sin(0.2);
  const double c = std::cos(0.2) + 0.5 * std::sin(0.2);
  const double critical = (1 + 3 * a * a / 1.25) / (3 * a * c / 1.25);
  const bool left = tells(sliding_on_its_corner(-1, 1.05 * critical, 1e-3), Consistency::none);
  const bool right = tells(sliding_on_its_corner(1, 1.05 * critical, 1e-3), Consistency::none);
  EXPECT_TRUE(left != right);
  for (const double rate : {-1.0, 1.0}) {
    EXPECT_FALSE(tells(sliding_on_its_corner(rate, 0.95 * critical, 1e-3), Consistency::none));
    const Scene scene = testing::single(0.5, 1, 1);
    for (const Event& event : sliding_on_its_corner(rate, 1.05 * critical, 0.5).events)
      EXPECT_LE(energy(scene, bodies_after(event)), energy(scene, bodies_before(event)) * (1 + 1e-12));
  }
}

// Whether forces can be, and which, depends on two signs: that of p = m (G_NN − μ |G_NT|), and that of the
// acceleration with which the corner would part without contact, c ω² − g. With p < 0 a corner that would
// part may do so, or press itself onto the ground with N = m (c ω² − g)/−p and be braked; with p > 0 it
// parts.
TEST(UnilateralPainleve, SignsOfTheCornerTellHowManySolutionsThereAre) {
  const double angle = 0.2;
  const double a = 0.5 * std::cos(angle) - std::sin(angle);
  const double c = std::cos(angle) + 0.5 * std::sin(angle);
  const double critical = (1 + 3 * a * a / 1.25) / (3 * a * c / 1.25);
  for (const double friction : {0.95 * critical, 1.05 * critical}) {
    for (const double lift : {0.95, 1.05}) {
      Scene scene = testing::with_friction(testing::single(0.5, 1, 1e-3), friction);
      scene.initial = {{angle}, {std::sqrt(lift * scene.gravity / c)}, {1.0}};
      const History history = solve_unilateral(scene);
      const bool jams = friction > critical;
      EXPECT_EQ(tells(history, Consistency::several), jams && lift > 1) << friction << ' ' << lift;
      EXPECT_EQ(tells(history, Consistency::none), jams && lift < 1) << friction << ' ' << lift;
      if (lift < 1) continue;
      ASSERT_FALSE(history.events.empty());
      EXPECT_EQ(history.events.front().kind, EventKind::lift_off);
    }
  }
}

/// A heavy block that turns on its left corner, and slides, on a light one that turns back on its right one.
Scene jamming(double duration) {
  const Block base{0.5, 0.8, 1, rectangle_inertia(1, 0.5, 0.8)};
  const Block top{1.4, 1.37, 785, rectangle_inertia(785, 1.4, 1.37)};
  Scene scene = testing::released({base, top}, {0, 0}, duration);
  scene.law = Law::unilateral;
  scene.friction = {1000, 0.56};
  scene.initial.velocities = {0.3, -1};
  return scene;
}

// A dynamic jam: as the base turns back, G_NN − μ |G_NT| of the sliding corner falls to zero, and the force
// grows like one over the time that is left. So, before that time, it has stopped any slip, within roundings.
TEST(UnilateralPainleve, AForceThatGrowsWithoutBoundStopsTheSlipAsTimeStepsHaveIt) {
  const Scene scene = jamming(0.06);
  const History history = solve_unilateral(scene);
  EXPECT_FALSE(ends_early(history));
  ASSERT_EQ(history.events.size(), 2U);
  EXPECT_EQ(history.events.front().kind, EventKind::slip);
  const Event& jam = history.events.back();
  EXPECT_EQ(jam.kind, EventKind::impact);
  EXPECT_EQ(jam.consistency, Consistency::none);
  EXPECT_EQ(jam.from.slides[1], 1);
  EXPECT_EQ(jam.to.slides[1], 0);
  EXPECT_LT(energy(scene, bodies_after(jam)), energy(scene, bodies_before(jam)));
  // Time steps come nearer in proportion to their size, 6 m/s and rad/s per s of it.
  const Poses<> rates = bodies_at_end(history).velocity;
  for (const double step : {1e-3, 1e-4}) {
    const Bodies<> stepped = testing::time_stepped(scene, step, 1e-12);
    for (std::size_t k = 0; k < 2; ++k) {
      EXPECT_NEAR(rates[k].x, stepped.velocity[k].x, 6 * step) << step;
      EXPECT_NEAR(rates[k].y, stepped.velocity[k].y, 6 * step) << step;
      EXPECT_NEAR(rates[k].angle, stepped.velocity[k].angle, 6 * step) << step;
    }
  }
}

}  // namespace
}  // namespace rockstack
