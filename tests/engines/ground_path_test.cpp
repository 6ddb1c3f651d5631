// A ground that really moves: its displacement is the double integral of the accelerations.

#include "engines/ground_path.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace rockstack {
namespace {

/// Displacement after `steps` steps, m.
double displacement(const GroundMotion& horizontal, double dt, int steps) {
  Scene scene;
  scene.horizontal = horizontal;
  GroundPath path(scene, dt);
  for (int i = 0; i < steps; ++i) path.next();
  return path.next().x;
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
  GroundPath path(scene, 0.01);
  GroundStep last = path.next();
  for (int i = 0; i < 200; ++i) {
    const GroundStep next = path.next();
    // Displacements reach a few metres: a few roundings of them.
    ASSERT_NEAR(next.x, last.x + 0.01 * last.velocity_x, 1e-14);
    ASSERT_NEAR(next.y, last.y + 0.01 * last.velocity_y, 1e-14);
    last = next;
  }
}

}  // namespace
}  // namespace rockstack
