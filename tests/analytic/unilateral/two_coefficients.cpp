#include "tests/analytic/unilateral/two_coefficients.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace rockstack {
namespace {

using testing::block;
using testing::pulse_of;
using testing::released;
using testing::rubbing_scene;
using testing::single;
using testing::with_coefficients;
using testing::with_friction;

constexpr double closed_form = 1e-10;
constexpr std::uint64_t scenes_stepped = 100;

const Event* first_of(const History& history, EventKind kind) {
  const auto found = std::ranges::find(history.events, kind, &Event::kind);
  return found == history.events.end() ? nullptr : &*found;
}

Scene flat_block(double duration) {
  return released({block(2, 0.4)}, {0}, duration);
}

double slip_at_end(const History& history) {
  return history.slips.back();
}

TEST(TwoCoefficients, ABlockOnAnInclineStartsToSlideAtTheStaticOneAndSlidesByTheKinetic) {
  const double friction = 0.5, kinetic = 0.35, duration = 0.7;
  Scene scene = with_coefficients(flat_block(duration), friction, kinetic);
  scene.inclination = std::atan(friction) - 1e-9;
  EXPECT_EQ(slip_at_end(solve_unilateral(scene)), 0);
  scene.inclination = std::atan(friction) + 1e-9;
  const double g = scene.gravity;
  const auto slid = [&] {
    return g * (std::sin(scene.inclination) - kinetic * std::cos(scene.inclination)) * duration * duration /
           2;
  };
  EXPECT_NEAR(slip_at_end(solve_unilateral(scene)), slid(), closed_form);
  // Between both angles of friction it stays where it is, or slides for ever.
  scene.inclination = 0.42;
  EXPECT_EQ(slip_at_end(solve_unilateral(scene)), 0);
  scene.initial.slip_velocities = {0.3};
  EXPECT_NEAR(slip_at_end(solve_unilateral(scene)), 0.3 * duration + slid(), closed_form);
  // Uphill it comes to a halt, and stays.
  scene.initial.slip_velocities = {-0.3};
  const double slowed = g * (std::sin(scene.inclination) + kinetic * std::cos(scene.inclination));
  EXPECT_NEAR(slip_at_end(solve_unilateral(scene)), -0.3 * 0.3 / (2 * slowed), closed_form);
}

TEST(TwoCoefficients, ASlidingBlockStopsByTheKineticOne) {
  Scene scene = with_coefficients(flat_block(2), 0.6, 0.2);
  scene.initial.slip_velocities = {1.7};
  const History history = solve_unilateral(scene);
  EXPECT_NEAR(slip_at_end(history), 1.7 * 1.7 / (2 * 0.2 * scene.gravity), closed_form);
  ASSERT_NE(first_of(history, EventKind::stick), nullptr);
  EXPECT_NEAR(first_of(history, EventKind::stick)->time, 1.7 / (0.2 * scene.gravity), closed_form);
}

// Newmark's sliding block (1965, Géotechnique 15, 139–160) with two coefficients, under half a sine.
TEST(TwoCoefficients, ASlidingBlockUnderAPulseStartsAndStopsWhereItsEquationSays) {
  const double friction = 0.5, kinetic = 0.3, period = 0.8;
  Scene scene = with_coefficients(flat_block(2), friction, kinetic);
  const double g = scene.gravity, a = 0.9 * g, turn = 2 * std::acos(-1.0) / period;
  scene.horizontal = pulse_of(PulseShape::half_sine, a, period);
  const double start = std::asin(friction * g / a) / turn;
  const double stop = start + a / turn * (std::cos(turn * start) + 1) / (kinetic * g);
  ASSERT_GT(stop, period / 2);
  const double end = period / 2 - start, speed = kinetic * g * (stop - period / 2);
  const double slid = kinetic * g * end * end / 2 - a / (turn * turn) * std::sin(turn * start) -
                      a / turn * std::cos(turn * start) * end - speed * (stop - period / 2) / 2;
  const History history = solve_unilateral(scene);
  ASSERT_NE(first_of(history, EventKind::slip), nullptr);
  ASSERT_NE(first_of(history, EventKind::stick), nullptr);
  EXPECT_NEAR(first_of(history, EventKind::slip)->time, start, closed_form);
  EXPECT_NEAR(first_of(history, EventKind::stick)->time, stop, closed_form);
  EXPECT_NEAR(slip_at_end(history), slid, closed_form);
  EXPECT_EQ(history.events.size(), 2U);
}

// Under a rectangle it starts at once, and slides A t₀²/2 (A/(μ g) − 1).
TEST(TwoCoefficients, ABlockUnderARectangularPulseSlidesByTheKineticOne) {
  Scene scene = with_coefficients(flat_block(2), 0.5, 0.2);
  const double g = scene.gravity, a = 0.6 * g, length = 0.4;
  scene.horizontal = pulse_of(PulseShape::rectangle, a, length);
  EXPECT_NEAR(-slip_at_end(solve_unilateral(scene)), a * length * length / 2 * (a / (0.2 * g) - 1),
              closed_form);
  scene.horizontal = pulse_of(PulseShape::rectangle, 0.49 * g, length);
  EXPECT_EQ(slip_at_end(solve_unilateral(scene)), 0);
}

// Impulses have the kinetic coefficient: with it the ratio of a rocking impact is (r² − 2 + 3μr)/(4 + r² −
// 3μr) where it slips, whatever the static one is.
TEST(TwoCoefficients, ARockingImpactSlipsByTheKineticOne) {
  for (const double kinetic : {0.1, 0.3, 0.36}) {
    Scene scene = with_coefficients(single(0.5, 1, 2), 2, kinetic);
    scene.initial.angles = {0.2};
    const double r = 2;
    const double expected = kinetic >= 3 * r / (1 + 4 * r * r)
                                ? 1 - 1.5 / (1 + r * r)
                                : (r * r - 2 + 3 * kinetic * r) / (4 + r * r - 3 * kinetic * r);
    const History history = solve_unilateral(scene);
    const Event* impact = first_of(history, EventKind::impact);
    ASSERT_NE(impact, nullptr);
    EXPECT_NEAR(impact->after[0] / impact->before[0], expected, closed_form);
  }
}

TEST(TwoCoefficients, EqualOnesLeaveEveryBitAsItIs) {
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    const Scene one = rubbing_scene(seed);
    Scene two = one;
    two.kinetic_friction = two.friction;
    const History expected = solve_unilateral(one), found = solve_unilateral(two);
    ASSERT_EQ(found.events.size(), expected.events.size());
    EXPECT_EQ(found.slips, expected.slips);
    EXPECT_EQ(found.angles, expected.angles);
  }
}

TEST(TwoCoefficients, EnergyNeverGrows) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    Scene scene = rubbing_scene(seed);
    testing::Draw draw(seed + 93000);
    for (const double friction : scene.friction)
      scene.kinetic_friction.push_back(friction * draw.between(0, 1));
    scene.horizontal = scene.vertical = {};
    for (double& rate : scene.initial.velocities) rate = draw.between(-1, 1);
    if (seed % 2 == 1) {
      scene.point_restitution = draw.between(0.2, 0.5);
      scene.restitution_law = RestitutionLaw::poisson;
    }
    const History history = solve_unilateral(scene);
    double before = energy(scene, bodies_at(solve_unilateral(scene, {.sample_times = {0}}), 0));
    const double rounding = 1e-11 * std::abs(before);
    for (const Event& event : history.events)
      for (const Bodies<>& bodies : {bodies_before(event), bodies_after(event)}) {
        const double now = energy(scene, bodies);
        EXPECT_LE(now, before + rounding) << seed << " at " << event.time;
        before = now;
      }
  }
}

/// Whether a motion is the only one, up to its end.
bool is_the_only_one(const History& history) {
  return !ends_early(history) && std::ranges::none_of(history.events, [](const Event& event) {
    return event.consistency == Consistency::several;
  });
}

// Time steps are of first order; motions that have a second one beside them, or end early, are left out.
TEST(TwoCoefficients, RandomBlocksMoveAsTimeStepsSay) {
  std::uint64_t compared = 0;
  for (std::uint64_t seed = 0; seed < scenes_stepped; ++seed) {
    const Scene scene = testing::shaken_block(seed);
    const History history = solve_unilateral(scene);
    if (!is_the_only_one(history)) continue;
    const Pose<> exact = bodies_at_end(history).pose[0], stepped = testing::block_stepped(scene, 20'000);
    EXPECT_NEAR(stepped.x, exact.x, 1e-3) << seed;
    EXPECT_NEAR(stepped.y, exact.y, 1e-3) << seed;
    EXPECT_NEAR(stepped.angle, exact.angle, 1e-3) << seed;
    ++compared;
  }
  EXPECT_GE(compared, scenes_stepped / 2);
}

// Where an upper interface comes to a halt while the ground pulls by more than both static coefficients, both
// slide, or the lower one alone, or the upper one alone: each keeps the other within its cone.
TEST(TwoCoefficients, AnEventSaysWhenOneOfTwoInterfacesAloneCouldSlide) {
  EXPECT_FALSE(is_the_only_one(solve_unilateral(testing::sliding_stack(8))));
}

TEST(TwoCoefficients, RandomStacksSlideAsTimeStepsSay) {
  std::uint64_t compared = 0;
  for (std::uint64_t seed = 0; seed < scenes_stepped; ++seed) {
    const Scene scene = testing::sliding_stack(seed);
    const History history = solve_unilateral(scene);
    if (!is_the_only_one(history)) continue;
    const std::vector<double> stepped = testing::slides_stepped(scene, 20'000);
    for (std::size_t k = 0; k < stepped.size(); ++k)
      EXPECT_NEAR(stepped[k], history.slips[history.slips.size() - stepped.size() + k], 1e-3) << seed;
    ++compared;
  }
  EXPECT_GE(compared, scenes_stepped / 2);
}

}  // namespace
}  // namespace rockstack
