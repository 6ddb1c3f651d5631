// What the canon makes of a deviation, by histories made by hand.

#include "comparisons/studies/canon/canon.hpp"

#include <gtest/gtest.h>

namespace rockstack {
namespace {

/// A block 2 m wide that is closed, and as if it turned at `rate` rad/s and slid at `speed` m/s, in two
/// steps.
History motion(double dt, double rate, double speed) {
  History history;
  history.blocks = 1;
  for (int i = 0; i <= 2; ++i) {
    const double time = i * dt;
    history.times.push_back(time);
    history.angles.push_back(rate * time);
    history.velocities.push_back(rate);
    history.slips.push_back(speed * time);
    history.gaps.push_back(0);
    history.patterns.push_back({.size = 1, .contacts = {}, .slides = {}});
  }
  return history;
}

Scene block() {
  Scene scene;
  scene.law = Law::unilateral;
  scene.blocks = {make_block(2, 1, 2500)};
  return scene;
}

constexpr double dt = 0.25;  // a power of two: products are exact

TEST(Canon, DeviationIsCountedInStepsOfTheFastestMotion) {
  const History exact = motion(dt, 4, 16);
  History engine = exact;
  engine.angles[2] += 2;
  const Deviation turned = deviation_in_steps(block(), exact, engine, dt);
  EXPECT_DOUBLE_EQ(turned.steps, 2 / (4 * dt));
  EXPECT_DOUBLE_EQ(turned.amount, 2);
  engine.slips[1] -= 32;
  const Deviation slid = deviation_in_steps(block(), exact, engine, dt);
  EXPECT_DOUBLE_EQ(slid.steps, 32 / (16 * dt));
  EXPECT_DOUBLE_EQ(slid.amount, 32);
}

TEST(Canon, RestIsMeasuredByWhatGravityGivesInAStep) {
  const History exact = motion(dt, 0, 0);
  History engine = exact;
  engine.angles[2] = 1;
  EXPECT_DOUBLE_EQ(deviation_in_steps(block(), exact, engine, dt).steps, 1 / (9.81 * dt / 2 * dt));
  engine.angles[2] = 0;
  engine.slips[2] = 1;
  EXPECT_DOUBLE_EQ(deviation_in_steps(block(), exact, engine, dt).steps, 1 / (9.81 * dt * dt));
}

TEST(Canon, VerdictIsAgreementThenConvergenceThenAnotherLaw) {
  EXPECT_EQ(canon_verdict({100, 1}, {canon_agreement, 1}), "agrees");
  EXPECT_EQ(canon_verdict({100, 1}, {100, 0.5}), "converges");
  EXPECT_EQ(canon_verdict({100, 1}, {100, 0.51}), "another law");
}

}  // namespace
}  // namespace rockstack
