#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

#include "tests/analytic/solver/stacks.hpp"

namespace rockstack {
namespace {

Pulse sine(double amplitude, double period, double cycles) {
  Pulse pulse;
  pulse.amplitude = amplitude;
  pulse.period = period;
  pulse.cycles = cycles;
  return pulse;
}

std::string refusal(const Scene& scene) {
  try {
    validate(scene);
  } catch (const FieldError& error) {
    return error.what();
  }
  return {};
}

TEST(Restitution, IsWhatAnImpactLeavesOfTheVelocityOfABlock) {
  for (const double ratio : {0.0, 0.5, 0.925, 1.0}) {
    Scene scene = testing::released({testing::block(0.5, 2)}, {0.1}, 2);
    scene.restitution = {ratio};
    const Event impact = solve(scene).events.at(0);
    EXPECT_DOUBLE_EQ(impact.after[0], ratio * impact.before[0]);
    EXPECT_EQ(impact.to[0], ratio > 0 ? Contact::left : Contact::closed);
  }
}

// The law stops a block whose slenderness is 0.96 or more (1 − (3/2) sin²α < 0); a ratio that is given does
// not.
TEST(Restitution, LetsASquatBlockRockOn) {
  Scene scene = testing::released({testing::block(2, 1)}, {0.3}, 1);
  EXPECT_EQ(solve(scene).events.at(0).to[0], Contact::closed);
  scene.restitution = {0.8};
  EXPECT_EQ(solve(scene).events.at(0).to[0], Contact::left);
}

TEST(Restitution, OfTheLawsOwnRatioChangesNothing) {
  Scene scene = testing::released({testing::block(0.5, 2)}, {0.1}, 3);
  const History law = solve(scene);
  scene.restitution = {1 - 1.5 * 0.25 / 4.25};
  const History given = solve(scene);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(given.events.at(i).time, law.events.at(i).time, 1e-11);
}

// A stack that rocks as one body, and the upper block on a resting base, are single blocks; where both
// interfaces open, the law's impact stands.
TEST(Restitution, OfAStackActsWhereAllAboveAnInterfaceRocksAsOne) {
  Scene joined = testing::released({testing::block(1, 3), testing::block(0.9, 0.5)}, {0.05, 0.05}, 0.8);
  joined.restitution = {0.6, 0.3};
  const Event whole = solve(joined).events.at(0);
  ASSERT_EQ(name(whole.from), "3a");
  EXPECT_DOUBLE_EQ(whole.after[0], 0.6 * whole.before[0]);
  EXPECT_DOUBLE_EQ(whole.after[1], 0.6 * whole.before[1]);

  Scene upper = testing::released({testing::block(2, 1), testing::block(0.4, 1)}, {0, 0.1}, 0.8);
  upper.restitution = {0.6, 0.3};
  const Event top = solve(upper).events.at(0);
  ASSERT_EQ(name(top.from), "4a");
  EXPECT_EQ(top.after[0], 0);
  EXPECT_DOUBLE_EQ(top.after[1], 0.3 * top.before[1]);

  Scene both = testing::paper_example();
  const Event before = solve(both).events.at(1);
  both.restitution = {0.6, 0.3};
  const Event after = solve(both).events.at(1);
  ASSERT_NE(before.from[0], Contact::closed);
  ASSERT_NE(before.from[1], Contact::closed);
  EXPECT_EQ(before.after, after.after);
}

TEST(Restitution, IsRefusedWhereItHasNoMeaning) {
  Scene scene = testing::released({testing::block(0.5, 2)}, {0.1}, 2);
  scene.restitution = {0.9, 0.9};
  EXPECT_EQ(refusal(scene), "restitution = an array of 2: must be as long as there are blocks, 1");
  scene.restitution = {1.1};
  EXPECT_EQ(refusal(scene), "restitution.1 = 1.1: must be a number from 0 to 1");
}

TEST(Cycles, GoOnForAsLongAsTheySay) {
  GroundMotion motion;
  motion.pulse = sine(3, 0.5, 2.5);
  EXPECT_EQ(motion.end(), 1.25);
  EXPECT_NEAR(acceleration(motion, 1.125), 3, 1e-12);
  EXPECT_EQ(acceleration(motion, 1.3), 0);
  // Whole cycles leave no velocity, half a one A T/π.
  EXPECT_NEAR(mean_acceleration(motion, 0, 2) * 2, 3 * 0.5 / std::acos(-1.0), 1e-12);
  motion.pulse->cycles = std::numeric_limits<double>::infinity();
  EXPECT_NEAR(acceleration(motion, 1000.125), 3, 1e-9);
}

TEST(Cycles, WithoutEndMoveABlockAsTheFirstOnesDo) {
  Scene scene = testing::released({testing::block(0.5, 2)}, {0}, 6);
  const auto angles = [&](double cycles) {
    scene.horizontal.pulse = sine(4, 0.6, cycles);
    return solve(scene, {.sample_times = regular_times(0.5, scene.duration)}).angles;
  };
  EXPECT_EQ(angles(std::numeric_limits<double>::infinity()), angles(10));
  EXPECT_NE(angles(1), angles(10));
}

/// A block on ground that falls to the right.
Scene inclined(double angle, double inclination) {
  Scene scene = testing::released({testing::block(0.5, 2)}, {angle}, 2);
  scene.inclination = inclination;
  return scene;
}

TEST(Inclination, ABlockStandsUpToItsSlendernessAndNeedsFrictionOfTheSlope) {
  const double slenderness = std::atan(0.25);
  const History stands = solve(inclined(0, 0.99 * slenderness), {.validity = true});
  EXPECT_TRUE(stands.events.empty());
  EXPECT_NEAR(stands.forces[0].friction, std::tan(0.99 * slenderness), 1e-14);
  for (const double side : {1.0, -1.0}) {
    const History falls = solve(inclined(0, side * 1.01 * slenderness), {.peaks = true});
    ASSERT_FALSE(falls.events.empty());
    EXPECT_EQ(falls.events[0].kind, EventKind::opening);
    EXPECT_EQ(falls.events[0].to[0], side > 0 ? Contact::right : Contact::left);
    EXPECT_GT(falls.peaks[0], 1e-3);
  }
}

// On its right edge a block of half diagonal R stands R cos(α − θ − β) above it, so that
// ω² = 2mgR/I₀ (cos(α − θ₀ − β) − cos(α − β)) when it lands.
TEST(Inclination, ABlockLandsWithTheEnergyOfItsHeight) {
  for (const double slope : {0.08, -0.2}) {
    const Scene scene = inclined(0.1, slope);
    const Block& block = scene.blocks[0];
    const double radius = std::hypot(block.half_width, block.half_height);
    const double inertia = block.inertia + block.mass * radius * radius;
    const double slenderness = std::atan(0.25);
    const double square = 2 * block.mass * scene.gravity * radius / inertia *
                          (std::cos(slenderness - 0.1 - slope) - std::cos(slenderness - slope));
    const Event impact = solve(scene).events.at(0);
    EXPECT_NEAR(impact.before[0], -std::sqrt(square), 1e-12);
  }
}

// Along the ground gravity is an acceleration like that of the ground, the other way.
TEST(Inclination, ActsLikeASteadyAccelerationOfTheGround) {
  Scene slope = testing::paper_example();
  slope.duration = 1;
  slope.inclination = 0.05;
  slope.horizontal.pulse = sine(2, 0.4, 2);
  Scene level = slope;
  level.inclination = 0;
  level.gravity = slope.gravity * std::cos(0.05);
  level.horizontal.pulse.reset();
  level.horizontal.interval = 1e-4;
  for (int i = 0; i <= 10000; ++i)
    level.horizontal.samples.push_back(acceleration(slope.horizontal, i * 1e-4) -
                                       slope.gravity * std::sin(0.05));
  const History one = solve(slope), other = solve(level);
  ASSERT_EQ(one.events.size(), other.events.size());
  // Straight lines between samples leave out Aω²h²/8 = 6e-7 m/s².
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(one.events[i].time, other.events[i].time, 1e-6);
}

TEST(Inclination, InDegreesIsToldInRadians) {
  EXPECT_EQ(refusal(inclined(0, 20)),
            "ground.inclination = 20: must be between ±0.7854 rad; 20 degrees are 0.34907");
  EXPECT_EQ(refusal(inclined(0, -1)),
            "ground.inclination = -1: must be between ±0.7854 rad; -1 degrees are -0.017453");
  EXPECT_EQ(refusal(inclined(0, 50)), "ground.inclination = 50: must be between ±0.7854 rad");
}

// A block that is turned uphill past its balance there, slenderness + inclination, does not come back; one
// that is let go just before does.
TEST(Inclination, ABlockComesBackFromBelowItsBalanceUphillAlone) {
  // That of the last is beyond the angle at which it would have toppled on level ground.
  for (const auto& [width, slope] : {std::pair{0.5, 0.1}, {0.5, 0.3}, {2.0, 0.5}}) {
    Scene scene = inclined(0, slope);
    scene.blocks[0] = make_block(width, 2, 2500);
    const double balance = slenderness(scene, 0) + slope;
    ASSERT_LT(balance, toppling_angle(scene, 0));
    scene.duration = 20;
    for (const bool beyond : {false, true}) {
      scene.initial.angles[0] = -(beyond ? balance + 1e-3 : balance - 1e-3);
      const std::vector<Event> events = solve(scene).events;
      ASSERT_FALSE(events.empty());
      EXPECT_EQ(events.front().kind, beyond ? EventKind::topple : EventKind::impact) << slope;
    }
  }
}

TEST(Inclination, ASlabLiesOnARampThatIsSteeperThanItsDiagonalLeaves) {
  Scene scene = inclined(0, 0.2617993877991494);
  scene.blocks[0] = make_block(0.4, 0.1, 1000);
  EXPECT_GT(slenderness(scene, 0) + scene.inclination, 0.5 * std::numbers::pi);
  EXPECT_LT(toppling_angle(scene, 0), 0.5 * std::numbers::pi);
  scene.law = Law::unilateral;
  scene.friction = {0.4};
  EXPECT_TRUE(solve(scene).events.empty());
  scene.friction = {0.2};
  EXPECT_EQ(solve(scene).events.size(), 1U);
}

// A ramp of 2.5 m/s³ asks for a friction of 0.2 at 0.2 g/2.5, and the block opens at g b/(2.5 h).
TEST(Demands, TellWhenTheyFirstPassWhatTheSceneHas) {
  Scene scene = testing::released({testing::block(0.5, 2)}, {0}, 1.2);
  scene.horizontal = {2, {0, 5}};
  scene.friction.assign(scene.blocks.size(), 0.2);
  const Demand demand = solve(scene, {.validity = true}).forces[0];
  EXPECT_NEAR(demand.first_slip_time, 0.2 * scene.gravity / 2.5, 1e-12);
  EXPECT_GT(demand.friction_time, demand.first_slip_time);
  EXPECT_EQ(demand.first_pull_time, std::numeric_limits<double>::infinity());
}

// A ground that falls faster and faster pulls once it passes g.
TEST(Demands, TellWhenAnInterfaceWouldFirstHaveToPull) {
  Scene scene = testing::released({testing::block(1, 2)}, {0}, 1);
  scene.vertical = {1, {0, -12}};
  const History history = solve(scene, {.validity = true});
  EXPECT_NEAR(history.forces[0].first_pull_time, scene.gravity / 12, 1e-9);
  EXPECT_EQ(history.forces[0].first_slip_time, history.forces[0].first_pull_time);
}

TEST(Choices, AreNamedWhereASymmetricStackOpensUnderTension) {
  for (const std::vector<double>& fall : {std::vector<double>{-12, -12}, std::vector<double>{0, -12}}) {
    Scene scene = testing::released({testing::block(1, 2), testing::block(1, 2)}, {0, 0}, 0.9);
    scene.vertical = {1, fall};
    const History history = solve(scene);
    ASSERT_FALSE(history.choices.empty());
    EXPECT_EQ(history.choices[0].time, history.events.at(0).time);
    EXPECT_EQ(history.choices[0].kind, EventKind::opening);
  }
}

TEST(Choices, AreNoneWhereThePushTellsTheSide) {
  Scene scene = testing::released({testing::block(0.5, 2)}, {0}, 2);
  scene.horizontal = {1, {0, 4, 0}};
  const History history = solve(scene);
  ASSERT_FALSE(history.events.empty());
  EXPECT_TRUE(history.choices.empty());
}

TEST(Unwanted, MotionsEndBeforeTheirNextStep) {
  for (const Law law : {Law::consistent, Law::unilateral, Law::compliant}) {
    Scene scene = testing::released({testing::block(0.5, 2)}, {0.1}, 2);
    scene.law = law;
    if (law == Law::compliant) scene.springs.stiffness = {1e7};
    int asked = 0;
    const std::function<bool()> at_the_third = [&] { return ++asked == 3; };
    EXPECT_THROW(solve(scene, {.cancelled = &at_the_third}), Stopped) << name(law);
    EXPECT_EQ(asked, 3) << name(law);
    const std::function<bool()> never = [] { return false; };
    EXPECT_EQ(solve(scene, {.sample_times = {2}, .cancelled = &never}).angles,
              solve(scene, {.sample_times = {2}}).angles)
        << name(law);
  }
}

}  // namespace
}  // namespace rockstack
