#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/analytic/unilateral/scenes.hpp"
#include "tests/analytic/unilateral/springs/random_springs.hpp"
#include "tests/analytic/unilateral/springs/stiff_cases.hpp"

namespace rockstack {
namespace {

/// A block of half-sizes b and h in m on two corner springs of k N/m, c N·s/m.
Scene on_springs(double half_width, double half_height, double stiffness, double damping, double duration) {
  Scene scene = testing::single(half_width, half_height, duration);
  scene.law = Law::compliant;
  scene.springs = {{stiffness}, {damping}};
  return scene;
}

// Lifted by the ground's fall beneath it and without weight, a block comes down flat on both corners: a mass
// on two springs and dashpots that push alone. m = 2500 kg, ω² = 2k/m, ζ = c/√(2km).
TEST(CornerSprings, RestoreWhatADampedImpactLeaves) {
  for (const double ratio : {0.01, 0.1, 0.5, 0.9, 1.0, 1.1, 2.0, 10.0}) {
    constexpr double stiffness = 1e7;
    Scene scene = on_springs(0.25, 0.5, stiffness, 0, 2);
    const double mass = scene.blocks.front().mass;
    scene.springs.damping = {ratio * std::sqrt(2 * stiffness * mass)};
    scene.gravity = 1e-10;
    scene.initial.preloaded = false;
    scene.vertical.samples = {-10, -10, 10, 10, 0};
    scene.vertical.interval = 0.1;
    const History history = solve_unilateral(scene);
    const auto touch = std::find_if(history.events.begin(), history.events.end(), [](const auto& event) {
      return event.kind == EventKind::touch && event.time > 0.4;
    });
    ASSERT_NE(touch, history.events.end());
    EXPECT_EQ(history.events.back().kind, EventKind::part);
    const double root = std::sqrt(std::abs(1 - ratio * ratio));
    const double expected =
        ratio == 1  ? std::exp(-2)
        : ratio < 1 ? std::exp(-ratio / root *
                               (std::numbers::pi - std::atan2(2 * ratio * root, 1 - 2 * ratio * ratio)))
                    : std::exp(-ratio / root * std::log((ratio + root) / (ratio - root)));
    EXPECT_NEAR(-bodies_after(history.events.back()).velocity[0].y / bodies_before(*touch).velocity[0].y,
                expected, 1e-10)
        << ratio;
  }
}

// The ground is pushed down by a fifth of g for a while: y = −(a/ω²)(1 − cos ωt), ω² = 2k/m, with a = g/5.
TEST(CornerSprings, CarryABlockUpAndDownAtItsFrequency) {
  Scene scene = on_springs(0.25, 0.5, 1e7, 0, 0.5);
  scene.vertical = testing::pulse_of(PulseShape::rectangle, scene.gravity / 5, 1);
  const double frequency = std::sqrt(2 * 1e7 / scene.blocks.front().mass);
  const std::vector<double> times = regular_times(0.01, scene.duration);
  const History history = solve_unilateral(scene, {.sample_times = times});
  const double rest = bodies_at(history, 0).pose[0].y;
  EXPECT_NEAR(rest, 0.5 - scene.gravity / (frequency * frequency), 1e-15);
  EXPECT_TRUE(history.events.empty());
  const double depth = scene.gravity / 5 / (frequency * frequency);
  // Positions round to 10⁻¹⁶ m each step, of which there are some hundreds.
  for (const auto& sample : samples_of(history))
    EXPECT_NEAR(sample.bodies.pose[0].y - rest, -depth * (1 - std::cos(frequency * sample.time)),
                1e-10 * depth)
        << sample.time;
}

// A block that slides on springs has N = mg, so that friction stops it after v₀²/(2μg): from its slider,
// which leaves the springs' stretch out. Its springs are soft across, so stiff enough against tipping.
TEST(CornerSprings, SlideAsFarAsOnRigidGround) {
  Scene scene = on_springs(1, 0.05, 1e7, 0, 1);
  scene.friction = {0.4};
  scene.initial.slip_velocities = {1};
  const History history = solve_unilateral(scene, {.peaks = true});
  // The slider stops while the block moves on against the springs and back: within μ mg/(2k) of that.
  const double elastic = 0.4 * scene.blocks[0].mass * scene.gravity / (2 * 1e7);
  EXPECT_NEAR(history.slips_left[0], 1 / (2 * 0.4 * scene.gravity), 2 * elastic);
  EXPECT_EQ(history.events.back().kind, EventKind::stick);
}

TEST(CornerSprings, AStackThatHasSettledRests) {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    Scene scene = testing::springy_scene(seed);
    scene.horizontal = scene.vertical = {};
    scene.initial = {std::vector<double>(scene.blocks.size()), std::vector<double>(scene.blocks.size())};
    for (double& friction : scene.friction) friction = std::max(friction, 0.5);
    // Stiff enough not to fall over: at 10⁷ N/m a tonne a stack of metres has 2kb² > mgh.
    for (double& stiffness : scene.springs.stiffness) stiffness *= 100;
    scene.inclination = seed % 2 == 0 ? 0 : 1e-3;
    const History history =
        solve_unilateral(scene, {.sample_times = {0, scene.duration / 2, scene.duration}});
    EXPECT_TRUE(history.events.empty()) << seed << ' ' << name(history.events.front().kind);
    for (const auto& sample : samples_of(history))
      for (std::size_t k = 0; k < scene.blocks.size(); ++k) {
        const Pose<> start = bodies_at(history, 0).pose[k];
        const double rounding = 1e-11;
        EXPECT_NEAR(sample.bodies.pose[k].x, start.x, rounding) << seed;
        EXPECT_NEAR(sample.bodies.pose[k].y, start.y, rounding) << seed;
        EXPECT_NEAR(sample.bodies.pose[k].angle, start.angle, rounding) << seed;
      }
  }
}

bool all_soft(const Scene& scene) {
  return std::all_of(scene.springs.stiffness.begin(), scene.springs.stiffness.end(),
                     [](double stiffness) { return std::isfinite(stiffness); });
}

// Where the ground is still, mechanical and elastic energy and what dashpots and friction have taken stay the
// same; impacts of rigid interfaces take some away.
TEST(CornerSprings, EnergyIsKeptOrTold) {
  int soft = 0;
  double lost = 0;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const Scene scene = testing::springy_scene(seed);
    if (!scene.horizontal.empty() || !scene.vertical.empty()) continue;
    const History history =
        solve_unilateral(scene, {.sample_times = regular_times(scene.duration / 20, scene.duration)});
    const double scale = testing::weight_times_height(scene);
    double last = testing::energy_with_losses(scene, samples_of(history).front());
    for (const auto& sample : samples_of(history)) {
      const double now = testing::energy_with_losses(scene, sample);
      EXPECT_LE(now, last + 1e-11 * scale) << seed << ' ' << sample.time;
      if (!all_soft(scene)) last = now;
      EXPECT_GE(now, last - 1e-11 * scale) << seed << ' ' << sample.time;
    }
    for (const auto& springs : history.row(history.spring_energies, history.size() - 1))
      lost = std::max(lost, (springs.damped + springs.rubbed) / scale);
    soft += all_soft(scene) ? 1 : 0;
  }
  EXPECT_GE(soft, 5);
  EXPECT_GT(lost, 1e-3);
}

Scene mirrored(Scene scene) {
  for (std::vector<double>* values :
       {&scene.initial.angles, &scene.initial.velocities, &scene.horizontal.samples})
    for (double& value : *values) value = -value;
  if (scene.horizontal.pulse) scene.horizontal.pulse->amplitude *= -1;
  return scene;
}

// Sums run from left to right, so that mirror images round differently.
TEST(CornerSprings, MirrorImagesMoveAlike) {
  int events = 0;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const Scene scene = testing::springy_scene(seed);
    const History one = solve_unilateral(scene);
    const History other = solve_unilateral(mirrored(scene));
    const std::size_t count = std::min<std::size_t>({one.events.size(), other.events.size(), 12});
    for (std::size_t i = 0; i < count; ++i) {
      EXPECT_EQ(one.events[i].kind, other.events[i].kind) << seed << ' ' << i;
      EXPECT_NEAR(one.events[i].time, other.events[i].time, 1e-9) << seed << ' ' << i;
      ++events;
    }
    if (one.events.size() > 12) continue;
    for (std::size_t k = 0; k < scene.blocks.size(); ++k)
      EXPECT_NEAR(bodies_at_end(one).pose[k].angle, -bodies_at_end(other).pose[k].angle, 1e-8) << seed;
  }
  EXPECT_GT(events, 60);
}

// As stiffness grows, a rigid interface is what springs on it come to.
TEST(CornerSprings, StiffOnesComeToRigidFaces) {
  Scene scene = testing::released({testing::block(1, 1), testing::block(0.6, 2)}, {0.1, 0.1}, 0.3);
  scene.law = Law::compliant;
  scene.friction = {0.9, 0.9};
  scene.springs = {{1e7, INFINITY}, {1e5, 0}};
  const History rigid = solve_unilateral(scene);
  double before = INFINITY;
  for (const double stiffness : {1e9, 1e10, 1e11}) {
    scene.springs.stiffness[1] = stiffness;
    scene.springs.damping[1] = 2 * std::sqrt(stiffness * 1000);
    const History soft = solve_unilateral(scene);
    const double difference =
        std::abs(bodies_at_end(soft).pose[1].angle - bodies_at_end(rigid).pose[1].angle);
    EXPECT_LT(difference, before / 2) << stiffness;
    before = difference;
  }
  EXPECT_LT(before, 1e-4);
}

// After strong dashpots the velocity that a rocking impact leaves tends to Housner's 0.7, as 1/k. After weak
// ones the block hops on its landing corner, and keeps more, however stiff they are.
TEST(CornerSprings, ThatAreStiffLeaveHousnersRatioWhereDashpotsAreStrong) {
  EXPECT_NEAR(testing::rocking_ratio(1e10, 10), 0.7, 1.5e-4);
  EXPECT_NEAR(testing::rocking_ratio(1e8, 10), 0.7, 1.5e-2);
  for (const double stiffness : {1e8, 1e10}) EXPECT_GT(testing::rocking_ratio(stiffness, 0.1), 0.8);
}

// A squat top falls back on a resting base: by law paper the base stays, by the other two all above the
// ground lifts. Stiff springs with strong dashpots lift it too, within a tenth as far.
TEST(CornerSprings, ThatAreStiffLiftABaseThatPushingImpulsesLift) {
  const testing::StiffAnswer answer = testing::answer_of(testing::stiff_cases().front(), 1e10, 10);
  EXPECT_EQ(answer.paper, 0);
  EXPECT_NEAR(answer.springs / answer.consistent, 1, 0.1);
  EXPECT_NEAR(answer.unilateral, answer.consistent, 1e-12);
}

// The left corner bears 0.05 N, so its spring is pressed in by no more than 5·10⁻¹⁵ m. The ground sets off to
// the left, and the corner leaves faster than its dashpot follows, once. Its depth is near to a rounding of
// the block's size; were it taken for zero, the corner would touch again in the next step, and again.
TEST(CornerSprings, PartOnceFromADepthNearRounding) {
  constexpr double stiffness = 1e13, force = 0.05, acceleration = 1.5e-3;
  Scene scene = on_springs(0.25, 0.5, stiffness, 0, 1e-4);
  Block& block = scene.blocks.front();
  scene.springs.damping = {20 * std::sqrt(stiffness * block.mass)};
  const double arm = 2 * block.half_width * force / (block.mass * scene.gravity);
  block.offset_x = block.half_width - arm;
  scene.horizontal.samples = {-acceleration, -acceleration};
  scene.horizontal.interval = scene.duration;
  const History history = solve_unilateral(scene, {.sample_times = {0}, .end = true});
  ASSERT_EQ(history.events.size(), 1);
  EXPECT_EQ(history.events.front().kind, EventKind::part);
  // It turns about the other corner, which gives way along the face as it takes up the ground's motion.
  const double turning = (acceleration * block.half_height - scene.gravity * arm) /
                         (block.inertia / block.mass + block.half_height * block.half_height + arm * arm);
  const double angle = bodies_at_end(history).pose[0].angle - bodies_at(history, 0).pose[0].angle;
  EXPECT_NEAR(angle / (turning * scene.duration * scene.duration / 2), 1, 0.01);
}

TEST(CornerSprings, ThatAreTooStiffToFollowAreRefusedAtOnce) {
  Scene scene = on_springs(0.25, 0.5, 1e19, 0, 10);
  EXPECT_THROW(solve_unilateral(scene), std::invalid_argument);
}

}  // namespace
}  // namespace rockstack
