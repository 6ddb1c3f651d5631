// Points that bounce by Newton's law, against closed forms and against a program of their own.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "analytic/solve.hpp"
#include "tests/analytic/unilateral/bouncing.hpp"
#include "tests/analytic/unilateral/time_stepping.hpp"

namespace rockstack {
namespace {

using testing::bouncing;
using testing::dropped;
using testing::gains;
using testing::random_bounces;
using testing::released;

constexpr double close = 1e-10;

// Falls of t₀, 2 e t₀, 2 e² t₀, … and heights of h, e² h, e⁴ h, …: a geometric series that ends after
// t₀ (1 + e)/(1 − e).
TEST(Bounces, ADroppedBlockBouncesInAGeometricSeries) {
  for (const double e : {0.2, 0.5, 0.8, 0.95, 0.99}) {
    const double height = 0.3;
    const double fall = std::sqrt(2 * height / dropped(e, height, 1).gravity);
    const double end = fall * (1 + e) / (1 - e);
    const Scene scene = dropped(e, height, end + 0.1);
    const History history = solve_unilateral(scene);
    ASSERT_GT(history.events.size(), 4U);
    double time = fall, speed = scene.gravity * fall;
    for (std::size_t n = 0; n < 3; ++n) {
      const Event& impact = history.events[n];
      EXPECT_EQ(impact.kind, EventKind::impact);
      EXPECT_EQ(name(impact.to), "-");
      EXPECT_NEAR(impact.time, time, close);
      EXPECT_NEAR(bodies_before(impact).velocity[0].y, -speed, close);
      EXPECT_NEAR(bodies_after(impact).velocity[0].y, e * speed, close);
      speed *= e;
      time += 2 * speed / scene.gravity;
    }
    EXPECT_EQ(history.events.back().kind, EventKind::rest) << e;
    EXPECT_EQ(name(history.events.back().to), "C");
    EXPECT_NEAR(history.events.back().time, end, close) << e;
    EXPECT_NEAR(bodies_at_end(history).pose[0].y, 0.25, close);
  }
}

TEST(Bounces, HeightsFallByTheSquareOfTheCoefficient) {
  const double e = 0.8, height = 0.3;
  Scene scene = dropped(e, height, 3);
  const double fall = std::sqrt(2 * height / scene.gravity);
  std::vector<double> tops;
  double time = fall;
  for (int n = 1; n <= 3; ++n) {
    tops.push_back(time + std::pow(e, n) * fall);
    time += 2 * std::pow(e, n) * fall;
  }
  const History history = solve_unilateral(scene, {.sample_times = tops});
  for (std::size_t n = 0; n < 3; ++n)
    EXPECT_NEAR(history.gaps[n], height * std::pow(e, 2 * (n + 1.0)), close);
}

TEST(Bounces, NothingIsLostWithACoefficientOfOne) {
  Scene scene = dropped(1, 0.3, 20);
  const double fall = std::sqrt(0.6 / scene.gravity);
  const History flat = solve_unilateral(scene);
  ASSERT_EQ(flat.events.size(), static_cast<std::size_t>((20 / fall + 1) / 2));
  EXPECT_NEAR(flat.events.back().time, fall * (2 * static_cast<double>(flat.events.size()) - 1), close);
  scene.friction = {0};
  scene.initial.angles = {0.3};
  const History tilted = solve_unilateral(scene);
  EXPECT_GT(tilted.events.size(), 3U);
  const double start = energy(scene, bodies_before(tilted.events[0]));
  EXPECT_NEAR(energy(scene, bodies_at_end(tilted)) / start, 1, close);
}

// Each impact takes μ times its impulse, (1 + e) e^n m u, from a block that slides: in the end, μ m u (1 +
// e)/(1 − e).
TEST(Bounces, ABlockThatSlidesLosesFrictionsShareOfEachImpact) {
  for (const double e : {0.3, 0.8}) {
    const double height = 0.05, friction = 0.1, along = 3;
    Scene scene = dropped(e, height, 4, friction);
    scene.initial.slip_velocities = {along};
    const double g = scene.gravity, fall = std::sqrt(2 * height / g);
    const History history = solve_unilateral(scene);
    EXPECT_NEAR(bodies_after(history.events[0]).velocity[0].x, along - friction * (1 + e) * g * fall, close);
    const double end = fall * (1 + e) / (1 - e);
    const double left = along - friction * (1 + e) * g * fall / (1 - e);
    EXPECT_EQ(history.events.back().kind, EventKind::stick);
    EXPECT_NEAR(history.events.back().time, end + left / (friction * g), close);
    const auto closure = std::find_if(history.events.begin(), history.events.end(),
                                      [](const auto& event) { return event.kind == EventKind::closure; });
    ASSERT_NE(closure, history.events.end());
    EXPECT_NEAR(closure->time, end, close);
    EXPECT_NEAR(bodies_after(*closure).velocity[0].x, left, close);
  }
}

TEST(Bounces, ATiltedBlockTurnsByTheImpulseOnItsCorner) {
  for (const double angle : {0.2, -0.4, 0.9}) {
    for (const double friction : {0.0, 0.05, 0.3, 10.0}) {
      for (const double along : {0.0, -2.0, 2.0}) {
        Scene scene = dropped(0.7, 0.2, 0.4, friction);
        scene.initial.angles = {angle};
        scene.initial.velocities = {0.5};
        scene.initial.slip_velocities = {along};
        const Event impact = solve_unilateral(scene).events.at(0);
        const testing::LowCorner corner(scene.blocks[0], impact.angles[0]);
        const Pose<> before = bodies_before(impact).velocity[0], after = bodies_after(impact).velocity[0];
        const Pose<> expected = corner.after(before, corner.newton(before, 0.7, friction));
        EXPECT_NEAR(after.x, expected.x, close) << angle << ' ' << friction << ' ' << along;
        EXPECT_NEAR(after.y, expected.y, close);
        EXPECT_NEAR(after.angle, expected.angle, close);
      }
    }
  }
}

// Without friction only height and angle move: between impacts a parabola and a uniform turn, and the lowest
// corner is the first to come down. Each impact multiplies what roundings are by some two.
TEST(Bounces, ABlockBouncesFromCornerToCornerAsAProgramOfItsOwnHasIt) {
  Scene scene = dropped(0.8, 0.5, 3, 0);
  scene.initial.angles = {std::numbers::pi / 3};
  const Block block = scene.blocks[0];
  const History history = solve_unilateral(scene);
  const double g = scene.gravity;
  const auto reach = [&](double angle) {  // of the centre over the lowest corner
    return block.half_height * std::cos(angle) + block.half_width * std::abs(std::sin(angle));
  };
  double time = 0, height = 0.5 + reach(std::numbers::pi / 3), angle = std::numbers::pi / 3;
  double rise = 0, turn = 0;
  std::size_t impacts = 0;
  for (const Event& impact : history.events) {
    if (impact.kind != EventKind::impact) break;
    const auto gap = [&](double t) { return height + rise * t - g * t * t / 2 - reach(angle + turn * t); };
    double low = 1e-9, high = 1e-9;
    while (gap(high) > 0) high += 1e-4;
    low = high - 1e-4;
    for (int i = 0; i < 60; ++i) (gap((low + high) / 2) > 0 ? low : high) = (low + high) / 2;
    height += rise * low - g * low * low / 2;
    angle += turn * low;
    rise -= g * low;
    time += low;
    EXPECT_NEAR(impact.time, time, close) << impacts;
    EXPECT_NEAR(impact.angles[0], angle, impacts < 3 ? close : 100 * close) << impacts;
    const double side = angle > 0 ? 1 : -1;
    const double lever = block.half_width * side * std::cos(angle) - block.half_height * std::sin(angle);
    const double impulse = -1.8 * (rise - lever * turn) / (1 / block.mass + lever * lever / block.inertia);
    rise += impulse / block.mass;
    turn -= lever * impulse / block.inertia;
    ++impacts;
  }
  EXPECT_EQ(impacts, 7U);
  EXPECT_EQ(history.events.back().kind, EventKind::topple);
  EXPECT_EQ(bodies_at_end(history).velocity[0].x, 0);
}

// Short blocks bounce as they rock (Lipscombe & Pellegrino 1993, J. Eng. Mech. 119, 1387–1410). A block that
// rocks at ω, and sticks as its other corner lands at 2bω, keeps c ω, c = 1 − (1 + e) 3b²/2R², so that the
// corner about which it turned leaves at 2bω (c + e): slender ones hop. Where that is negative, of blocks
// with h/b < 1/√2, it stays, and the block is thrown back about it, at −eω. Either law has both: nothing
// slides.
TEST(Bounces, RockingBlocksHopAndShortOnesAreThrownBack) {
  for (const RestitutionLaw law : {RestitutionLaw::newton, RestitutionLaw::poisson}) {
    for (const double e : {0.3, 0.7}) {
      for (const double slenderness : {0.4, 0.6, 0.8, 2.0}) {
        const double b = 0.5, h = slenderness * b;
        Scene scene = bouncing(testing::single(b, h, 2), e, 100);
        scene.restitution_law = law;
        scene.initial.angles = {-0.1};
        const Event impact = solve_unilateral(scene).events.at(0);
        const double rate = impact.before[0];
        const double kept = 1 - (1 + e) * 1.5 / (1 + slenderness * slenderness);
        const bool is_short = kept + e < 0;
        SCOPED_TRACE(::testing::Message() << e << ' ' << slenderness << ' ' << static_cast<int>(law));
        EXPECT_EQ(is_short, slenderness < 1 / std::numbers::sqrt2);
        EXPECT_EQ(name(impact.to), is_short ? "L" : "-");
        EXPECT_NEAR(impact.after[0], (is_short ? -e : kept) * rate, close);
        EXPECT_NEAR(bodies_after(impact).velocity[0].y, b * rate * (is_short ? e : kept + 2 * e), close);
      }
    }
  }
}

// Where an interface rests, it has no speed to give back: a block that falls on one leaves it at e u, and the
// one on the ground stays. Two that fall as one leave the ground as one.
TEST(Bounces, StacksKeepOfEachPointWhatItHad) {
  Scene scene = bouncing(released({testing::block(1, 0.5), testing::block(0.6, 0.3)}, {0, 0}, 0.4), 0.6, 0.4);
  scene.initial.gaps = {0, 0.2};
  const double speed = std::sqrt(0.4 * scene.gravity);
  const Event on_top = solve_unilateral(scene).events.at(0);
  EXPECT_EQ(name(on_top.to), "C-");
  EXPECT_NEAR(bodies_after(on_top).velocity[1].y, 0.6 * speed, close);
  EXPECT_NEAR(bodies_after(on_top).velocity[0].y, 0, close);
  scene.initial.gaps = {0.2, 0};
  const Event as_one = solve_unilateral(scene).events.at(0);
  EXPECT_EQ(name(as_one.to), "-C");
  EXPECT_NEAR(bodies_after(as_one).velocity[1].y, 0.6 * speed, close);
  EXPECT_NEAR(bodies_after(as_one).velocity[0].y, 0.6 * speed, close);
}

// Time steps meet a point a step late at most, so that a velocity is off for a step after each of a few
// impacts. A coefficient that were off by a hundredth would show ten times as much.
TEST(Bounces, StacksMoveAsMoreausTimeStepsDo) {
  const double step = 1e-5;
  std::size_t impacts = 0;
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    Scene scene = random_bounces(seed, true);
    scene.duration = 0.35;
    SCOPED_TRACE(seed);
    impacts += testing::expect_as_stepped(scene, solve_unilateral(scene), step);
  }
  EXPECT_GT(impacts, 30U);
}

TEST(Bounces, EnergyNeverGrowsWithoutFriction) {
  std::size_t impacts = 0;
  for (std::uint64_t seed = 0; seed < 25; ++seed) {
    const Scene scene = random_bounces(seed, false);
    for (const Event& event : solve_unilateral(scene).events) {
      if (event.kind == EventKind::impact) ++impacts;
      EXPECT_FALSE(gains(scene, event)) << seed << ' ' << event.time;
      EXPECT_NE(event.consistency, Consistency::gains) << seed << ' ' << event.time;
    }
  }
  EXPECT_GT(impacts, 1000U);
}

TEST(Bounces, WhereNewtonsLawGainsEnergyTheEventTellsSo) {
  std::size_t told = 0;
  for (const std::uint64_t seed : {137, 158, 175, 186, 189}) {
    const Scene scene = random_bounces(seed, true);
    for (const Event& event : solve_unilateral(scene).events) {
      if (!gains(scene, event)) continue;
      EXPECT_EQ(event.consistency, Consistency::gains) << seed << ' ' << event.time;
      ++told;
    }
  }
  EXPECT_GT(told, 0U);
}

/// Two blocks of 2500 kg/m³ that lean by a hundredth about one corner, which bounce as they land.
Scene leaning_pair(double upper_height, double friction, double restitution, RestitutionLaw law) {
  Scene scene =
      bouncing(released({make_block(1, 0.8, 2500), make_block(0.6, upper_height, 2500)}, {-0.01, -0.01}, 0.4),
               restitution, friction);
  scene.restitution_law = law;
  return scene;
}

// A corner that has bounced to within rounding of its face is turned back there by another impact, and
// strikes.
TEST(Bounces, NothingFallsThroughAFaceToWhichAnotherImpactTurnsItBack) {
  for (const RestitutionLaw law : {RestitutionLaw::newton, RestitutionLaw::poisson})
    for (const double restitution : {0.3, 0.4, 0.5})
      for (const double upper : {0.4, 0.6})
        for (const double friction : {0.5, 1.0}) {
          const Scene scene = leaning_pair(upper, friction, restitution, law);
          const auto history = solve_unilateral(scene, {.sample_times = regular_times(0.01, scene.duration)});
          EXPECT_FALSE(ends_early(history));
          for (const Sample& sample : samples_of(history))
            for (const double gap : sample.gaps)
              EXPECT_GT(gap, -1e-9) << restitution << ' ' << upper << ' ' << friction << ' ' << sample.time;
        }
}

// What parted a moment ago may return to its joint by a decision, and slides on there: between events
// velocities change by what accelerations make of the time, here less than 10⁴ m/s² and 10⁴ rad/s².
TEST(Bounces, DecisionsChangeNoVelocities) {
  Scene four = bouncing(released({make_block(1.646, 1.025, 2301), make_block(0.523, 0.793, 1714),
                                  make_block(2.48, 1.349, 1660), make_block(1.276, 1.177, 2034)},
                                 {0, 0.030533, 0.030533, 0.004364}, 0.001),
                        0.69, 0);
  four.restitution_law = RestitutionLaw::poisson;
  four.friction = {0.633, 0, 1.092, 0};
  four.initial.velocities = {0, -0.2949, -0.29489, 0.6518};
  four.initial.offsets = {0.00323, 0.020055, 0.000645, -0.005245};
  four.initial.slip_velocities = {0, 0.392, 0, -0.11};
  Scene three = bouncing(
      released({make_block(1.26, 0.76, 2500), make_block(1.02, 0.44, 2500), make_block(1.18, 0.5, 2500)},
               {0.027, -0.006, -0.03}, 0.17),
      0.5, 0);
  three.friction = {1.14, 0.99, 0.12};
  three.initial.offsets = {0, 0.039, 0.094};
  std::size_t compared = 0;
  for (const Scene& scene : {four, three}) {
    const History history = solve_unilateral(scene);
    for (std::size_t i = 1; i < history.events.size(); ++i) {
      const Event &last = history.events[i - 1], &next = history.events[i];
      const double most = 1e-9 + 1e4 * (next.time - last.time);
      if (most > 1e-3) continue;
      ++compared;
      for (std::size_t k = 0; k < scene.blocks.size(); ++k) {
        const Pose<> before = bodies_after(last).velocity[k], after = bodies_before(next).velocity[k];
        EXPECT_NEAR(after.angle, before.angle, most) << next.time;
        EXPECT_NEAR(after.x, before.x, most) << next.time;
        EXPECT_NEAR(after.y, before.y, most) << next.time;
      }
    }
  }
  EXPECT_GT(compared, 100U);
}

}  // namespace
}  // namespace rockstack
