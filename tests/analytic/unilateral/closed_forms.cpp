#include <gtest/gtest.h>

#include <cmath>

#include "analytic/unilateral/contact/contact_modes.hpp"
#include "tests/analytic/unilateral/scenes.hpp"

namespace rockstack {
namespace {

using testing::pulse_of;
using testing::round_off;
using testing::single;
using testing::with_friction;

std::string first_mode(const Scene& scene, double friction) {
  const History history = solve_unilateral(with_friction(scene, friction));
  return history.events.empty() ? "" : name(history.events.front().to);
}

// Shenton 1996, J. Eng. Mech. 122, 690–693: rocking without slip needs μ ≥ [A(4 + r²) + 3r]/[1 + 4r² + 3Ar].
TEST(UnilateralClosedForms, RockingSlidesBelowShentonsFriction) {
  for (const auto& [slenderness_ratio, push] : {std::pair{2.0, 1.0}, {1.5, 0.9}, {4.0, 0.3}}) {
    Scene scene = single(0.5, 0.5 * slenderness_ratio, 1e-3);
    scene.horizontal = pulse_of(PulseShape::rectangle, push * scene.gravity, 1);
    const double r = slenderness_ratio;
    const double expected = (push * (4 + r * r) + 3 * r) / (1 + 4 * r * r + 3 * push * r);
    double slides = expected - 0.01;
    double sticks = expected + 0.01;
    EXPECT_EQ(first_mode(scene, slides), "L<");
    EXPECT_EQ(first_mode(scene, sticks), "L");
    for (int i = 0; i < 35; ++i) {
      const double middle = (slides + sticks) / 2;
      (first_mode(scene, middle) == "L" ? sticks : slides) = middle;
    }
    EXPECT_NEAR(sticks, expected, 1e-11);
  }
}

// Friction μ stops a block of speed v after v²/(2μg). Ground that then has an acceleration a for a time T
// makes it slide back, by (a − μg) T²/2 up to its end and by ((a − μg) T)²/(2μg) from there on.
TEST(UnilateralClosedForms, TheLargestSlipIsTheLongerOfTwoStoppingDistances) {
  constexpr double friction = 0.4, speed = 2;
  for (const double time : {0.3, 0.9}) {
    Scene scene = with_friction(single(1, 0.05, 4), friction);
    const double holds = friction * scene.gravity, push = 1.5 * holds;
    scene.initial.slip_velocities = {speed};
    scene.horizontal = pulse_of(PulseShape::rectangle, push, time, 1);
    const double on = speed * speed / (2 * holds), fastest = (push - holds) * time;
    const double back = fastest * time / 2 + fastest * fastest / (2 * holds);
    const History history = solve_unilateral(scene, {.peaks = true});
    EXPECT_NEAR(history.slips_left[0], on - back, round_off);
    EXPECT_NEAR(history.largest_slips[0], std::max(on, back - on), round_off);
    EXPECT_EQ(history.uplifts[0], 0);
  }
}

TEST(UnilateralClosedForms, SlideRockFromRestHasItsAccelerations) {
  const Scene scene = single(1, 2, 1);
  const double g = scene.gravity;
  const double b = 1;
  const double h = 2;
  const double friction = 0.6;
  const ContactModel<> stack(scene.blocks, {friction});
  Joints<double> joints(1);
  Bodies<> bodies{{{}}, {{}}};
  place(stack, joints, bodies);
  FreeVector<> free(3);
  free << -g, -g, 0;
  const ContactProblem<> problem{stack, bodies, free, ContactLevel::accelerations};
  const auto mode = find_mode(problem, joints);
  ASSERT_TRUE(mode);
  EXPECT_EQ(name(pattern_of(*mode)), "L<");
  const ModeResponse<> response = respond(problem, *mode);
  const double turning = 3 * g * (friction * h - b) / (4 * b * b + h * h - 3 * friction * b * h);
  EXPECT_NEAR(-response.motion[2], turning, round_off * g);
  EXPECT_NEAR(response.forces[0].normal, scene.blocks[0].mass * (g + b * turning),
              round_off * scene.blocks[0].mass * g);
  const ContactKinematics<> rows = kinematics_of(stack, bodies, stack.held_point(0, (*mode)[0]));
  EXPECT_NEAR(-rows.slip_row.dot(response.motion), g - friction * (g + b * turning) - h * turning,
              round_off * g);
}

TEST(UnilateralClosedForms, ARockingImpactKeepsItsShareOfTheVelocity) {
  for (const double r : {1.8, 2.0, 3.0}) {
    const Scene scene = single(0.5, 0.5 * r, 1);
    const double sticks = 3 * r / (1 + 4 * r * r);
    for (const double friction : {0.1, 0.9 * sticks, 1.1 * sticks, 2.0}) {
      const ContactModel<> stack(scene.blocks, {friction});
      Joints<double> joints(1);
      joints[0].touch = Contact::right;
      Bodies<> bodies{{{}}, {{}}};
      bodies.velocity[0].angle = -1;
      place(stack, joints, bodies);
      const FreeVector<> before = vector_of(bodies.velocity);
      joints[0].touch = Contact::closed;
      const ContactProblem<> problem{stack, bodies, before, ContactLevel::velocities};
      const auto mode = find_mode(problem, joints);
      ASSERT_TRUE(mode);
      const FreeVector<> after = respond(problem, *mode).motion;
      const double sliding = (r * r - 2 + 3 * friction * r) / (4 + r * r - 3 * friction * r);
      if (r * r + 3 * friction * r <= 2) continue;
      EXPECT_NEAR(-after[2], friction >= sticks ? 1 - 1.5 / (1 + r * r) : sliding, round_off)
          << r << ' ' << friction;
      EXPECT_EQ((*mode)[0].slip == 0, friction >= sticks);
    }
  }
}

TEST(UnilateralClosedForms, ABlockUnderARectangularPulseSlidesItsWay) {
  for (const double side : {-1.0, 1.0}) {
    const double friction = 0.3;
    const double push = 0.7;
    const double time = 0.4;
    Scene scene = single(1, 0.8, 3);
    scene.horizontal = pulse_of(PulseShape::rectangle, side * push * scene.gravity, time, 0.1);
    const History history = solve_unilateral(with_friction(scene, friction));
    EXPECT_NEAR(history.slips.back(), -side * push * scene.gravity * time * time * (push / friction - 1) / 2,
                round_off);
    EXPECT_NEAR(history.events.back().time, 0.1 + push / friction * time, round_off);
  }
}

TEST(UnilateralClosedForms, ASlidingBlockStops) {
  const double friction = 0.2;
  const double speed = 1.5;
  Scene scene = with_friction(single(1, 0.8, 3), friction);
  scene.initial.slip_velocities = {speed};
  const History history = solve_unilateral(scene);
  EXPECT_NEAR(bodies_at_end(history).pose[0].x, speed * speed / (2 * friction * scene.gravity), round_off);
  EXPECT_NEAR(history.events.back().time, speed / (friction * scene.gravity), round_off);
  EXPECT_EQ(name(history.events.back().to), "C");
}

// The ground falls away at 2 g for t₀, so that the block rises against it at g and then falls at g.
TEST(UnilateralClosedForms, AThrownBlockFliesItsParabolaAndLandsWithFriction) {
  const double time = 0.2;
  const double speed = 2;
  const double friction = 0.25;
  Scene scene = with_friction(single(1, 0.8, 1), friction);
  scene.initial.slip_velocities = {speed};
  const double g = scene.gravity;
  scene.vertical = pulse_of(PulseShape::rectangle, -2 * g, time);
  const History history = solve_unilateral(scene, {.sample_times = {0.1, 0.3, 0.4}, .validity = true});
  ASSERT_GE(history.events.size(), 2U);
  const Event& landing = history.events[1];
  EXPECT_EQ(history.events[0].kind, EventKind::lift_off);
  EXPECT_EQ(history.events[0].time, 0);
  EXPECT_EQ(landing.kind, EventKind::impact);
  EXPECT_EQ(name(landing.to), "C>");
  EXPECT_NEAR(landing.time, (2 + std::sqrt(2.0)) * time, round_off);
  EXPECT_NEAR(bodies_before(landing).velocity[0].y, -std::sqrt(2.0) * g * time, round_off * g);
  EXPECT_EQ(bodies_after(landing).velocity[0].y, 0);
  EXPECT_NEAR(bodies_after(landing).velocity[0].x, speed - friction * std::sqrt(2.0) * g * time,
              round_off * g);
  EXPECT_NEAR(bodies_after(landing).pose[0].x, speed * landing.time, round_off);
  const double mass = scene.blocks[0].mass;
  EXPECT_EQ(history.forces[0].least_normal, 0);
  EXPECT_EQ(history.forces[0].least_normal_time, 0);
  EXPECT_NEAR(history.forces[0].friction, friction, round_off);
  EXPECT_NEAR(history.impulses[0].least_normal, mass * std::sqrt(2.0) * g * time, round_off * mass * g);
  EXPECT_NEAR(history.impulses[0].friction, friction, round_off);
  EXPECT_EQ(history.impulses[0].friction_time, landing.time);
  const auto height = [&](double t) {
    return t < time ? g * t * t / 2
                    : g * time * time / 2 + g * time * (t - time) - g * (t - time) * (t - time) / 2;
  };
  for (const auto& sample : samples_of(history))
    EXPECT_NEAR(sample.gaps[0], height(sample.time), round_off) << sample.time;
}

TEST(UnilateralClosedForms, TheLastEventsOfASlowDescentAreThoseOfHousner) {
  Scene scene = single(0.5, 1, 3);
  scene.initial.angles = {0.1};
  const History history = solve_unilateral(with_friction(scene, 10));
  for (std::size_t i = 0; i < 5; ++i) {
    const Event& event = history.events[i];
    EXPECT_EQ(event.kind, EventKind::impact);
    EXPECT_NEAR(event.after[0] / event.before[0], 0.7, round_off);
  }
  EXPECT_EQ(history.events.back().kind, EventKind::rest);
}

// Without friction a block glides at its speed, and tips as its centre passes the end of the face below.
TEST(UnilateralClosedForms, AGlidingBlockTipsAsItsCentrePassesAnEnd) {
  for (const double size : {0.01, 1.0, 30.0}) {
    for (const double speed : {1.2, 2.0, 8.0}) {
      Scene scene = testing::released(
          {testing::block(1.2 * size, 0.4 * size), testing::block(0.8 * size, 0.5 * size)}, {0, 0}, 1);
      const double own = speed * std::sqrt(size);
      scene.initial.slip_velocities = {0, own};
      scene.duration = 0.7 * size / own;
      const std::vector<Event> events = solve_unilateral(with_friction(scene, 0)).events;
      const auto tips = std::find_if(events.begin(), events.end(),
                                     [](const Event& event) { return event.kind == EventKind::opening; });
      ASSERT_NE(tips, events.end()) << size << ' ' << speed;
      const double passes = 0.6 * size / own;
      EXPECT_NEAR(tips->time, passes, 8 * std::numeric_limits<double>::epsilon() * passes)
          << size << ' ' << speed;
    }
  }
}

// A block that slides over another, v t − μ g t²/2 far, has its end over that of the other once.
TEST(UnilateralClosedForms, AnEndPassesAnotherOnce) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    testing::Draw draw(seed);
    const double apart = draw.between(-0.2, 0.2);
    const double friction = draw.between(0.05, 0.3);
    Scene scene = testing::released({testing::block(2, 0.5), testing::block(2 + 2 * apart, 0.5)}, {0, 0}, 1);
    scene.law = Law::unilateral;
    scene.friction = {10, friction};
    const double braking = friction * scene.gravity;
    const double speed = std::sqrt(2 * braking * (std::abs(apart) + 0.1));
    scene.initial.slip_velocities = {0, draw.coin() ? speed : -speed};
    std::vector<double> times;
    for (const Event& event : solve_unilateral(scene).events)
      if (event.kind == EventKind::corner) times.push_back(event.time);
    ASSERT_EQ(times.size(), 1U) << seed;
    EXPECT_NEAR(times.front(), (speed - std::sqrt(0.2 * braking)) / braking, 1e-12) << seed;
  }
}

}  // namespace
}  // namespace rockstack
