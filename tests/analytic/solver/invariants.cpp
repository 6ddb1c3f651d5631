#include <gtest/gtest.h>

#include "tests/analytic/solver/stacks.hpp"
#include "tests/stride.hpp"

namespace rockstack {
namespace {

Scene heavier_by_four(Scene scene) {
  for (Block& block : scene.blocks) {
    block.mass *= 4;
    block.inertia *= 4;
  }
  return scene;
}

void slow_down(GroundMotion& motion) {
  motion.interval *= 2;
  if (!motion.pulse) return;
  motion.pulse->period *= 2;
  motion.pulse->start *= 2;
}

/// Lengths times four, times times two: under the same gravity, all accelerations stay.
Scene larger_by_four(Scene scene) {
  scene.duration *= 2;
  slow_down(scene.horizontal);
  slow_down(scene.vertical);
  for (double& velocity : scene.initial.velocities) velocity /= 2;
  for (Block& block : scene.blocks) {
    block.half_width *= 4;
    block.half_height *= 4;
    block.inertia *= 16;
  }
  return scene;
}

void expect_same_events(const History& one, const History& other, double time_scale, std::uint64_t seed) {
  ASSERT_EQ(one.events.size(), other.events.size()) << seed;
  for (std::size_t i = 0; i < one.events.size(); ++i) {
    ASSERT_EQ(time_scale * one.events[i].time, other.events[i].time) << seed;
    ASSERT_EQ(one.events[i].kind, other.events[i].kind) << seed;
    ASSERT_EQ(one.events[i].interface, other.events[i].interface) << seed;
    ASSERT_EQ(one.events[i].to, other.events[i].to) << seed;
    ASSERT_EQ(one.events[i].angles, other.events[i].angles) << seed;
    ASSERT_EQ(one.events[i].consistency, other.events[i].consistency) << seed;
  }
}

// Powers of two change no rounding, so both scalings hold bit for bit.
TEST(Invariants, ScaledMassesOrLengthsGiveTheSameMotionBitForBit) {
  for (std::uint64_t seed = 0; seed < 1000; seed += testing::stride) {
    const Scene scene = testing::seeded_scene(4000 + seed);
    std::vector<double> times = regular_times(0.01, scene.duration);
    const History one = solve(scene, {.sample_times = times});
    const History heavier = solve(heavier_by_four(scene), {.sample_times = times});
    ASSERT_EQ(one.angles, heavier.angles) << seed;
    ASSERT_EQ(one.velocities, heavier.velocities) << seed;
    expect_same_events(one, heavier, 1, seed);
    for (double& time : times) time *= 2;
    const History larger = solve(larger_by_four(scene), {.sample_times = times});
    ASSERT_EQ(one.angles, larger.angles) << seed;
    expect_same_events(one, larger, 2, seed);
  }
}

TEST(Invariants, VerticalGroundAccelerationIsMoreGravity) {
  testing::Draw draw(42);
  for (int i = 0; i < 500; ++i) {
    const int size = 1 + draw.below(4);
    auto model = make_model<double>(testing::random_stack(draw, size));
    const auto state = testing::random_state<double>(draw, size);
    const Vector<double> lifted = accelerations(model, state, Point<double>(3, 2.5));
    model.gravity += 2.5;
    EXPECT_EQ(lifted, accelerations(model, state, Point<double>(3, 0)));
  }
}

// A constant ground acceleration is gravity turned by β: the stack turned along with it accelerates alike.
TEST(Invariants, ConstantGroundAccelerationIsGravityTurned) {
  testing::Draw draw(43);
  for (int i = 0; i < 500; ++i) {
    const int size = 1 + draw.below(4);
    auto model = make_model<double>(testing::random_stack(draw, size));
    State<double> state = testing::random_state<double>(draw, size);
    const double turn = draw.between(-0.3, 0.3);
    const double strength = draw.between(5, 15);
    // Pull seen from the ground: (−ẍg, −g − ÿg) = −strength (sin β, cos β); turning all by β makes it
    // straight down.
    const Point<double> ground{strength * std::sin(turn), strength * std::cos(turn) - model.gravity};
    if (state.pattern[0] == Contact::closed) continue;
    const Vector<double> inclined = accelerations(model, state, ground);
    state.angles[0] -= turn;
    model.gravity = strength;
    const Vector<double> upright = accelerations(model, state, Point<double>(0, 0));
    const double scale = 1 + upright.cwiseAbs().maxCoeff();
    EXPECT_LE((inclined - upright).cwiseAbs().maxCoeff(), 1e-11 * scale);  // rounding, mass ratios 10³
  }
}

}  // namespace
}  // namespace rockstack
