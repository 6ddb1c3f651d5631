#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "analytic/unilateral/springs/winkler_bed.hpp"
#include "tests/analytic/unilateral/scenes.hpp"
#include "tests/analytic/unilateral/springs/random_springs.hpp"

namespace rockstack {
namespace {

/// A block of half-sizes 0.25 m and 0.5 m, 1250 kg, on a bed of κ N/m², γ N·s/m².
Scene on_a_bed(double stiffness, double damping, double duration) {
  Scene scene = testing::single(0.25, 0.5, duration);
  scene.law = Law::compliant;
  scene.springs.bed_stiffness = {stiffness};
  scene.springs.bed_damping = {damping};
  return scene;
}

double mean(double a, double b, double share) {
  return a + share * (b - a);
}

// By strips that push or do not: their sum has an error of the second order in their width, one more where a
// pressure jumps at the bed's surface.
TEST(WinklerBed, PressesAsItsStripsDo) {
  testing::Draw draw(7);
  int inside = 0;
  for (int i = 0; i < 300; ++i) {
    BedState state;
    GrowingBed<double> bed;
    for (std::size_t end = 0; end < 2; ++end) {
      put(bed.depth[end], 0, draw.between(-1, 1));
      put(bed.pressure[end], 0, bed.depth[end][0] + (i % 3 == 0 ? 0 : draw.between(-1, 1)));
      state.ends[end] = {bed.depth[end][0] > 0, bed.pressure[end][0] > 0};
    }
    state.crossed = bed.crosses();
    bed.stretch = stretch_of(state);
    bed.extend(0);
    constexpr int strips = 20000;
    double normal = 0;
    double couple = 0;
    for (int k = 0; k < strips; ++k) {
      const double share = (k + 0.5) / strips;
      if (!(mean(bed.depth[0][0], bed.depth[1][0], share) > 0)) continue;
      const double pressure = std::max(0.0, mean(bed.pressure[0][0], bed.pressure[1][0], share));
      normal += pressure / strips;
      couple += pressure * (share - 0.5) / strips;
    }
    EXPECT_NEAR(bed.normal[0], normal, 1e-4) << i;
    EXPECT_NEAR(bed.couple[0], couple, 1e-4) << i;
    inside += bed.stretch.presses && bed.stretch.near != BedBound::end ? 1 : 0;
  }
  EXPECT_GT(inside, 3);
}

// After uplift the pressure is a triangle: N = ½κℓ² sin θ, so the moment about the middle is N (b − ℓ/3),
// with ℓ = √(2N/(κ sin θ)). In terms of the angle of uplift under N, θ_u = N/(2κb²), it is N b (1 − ⅔
// √(θ_u/sin θ)), which starts from ⅓ N b as that of the whole bed, ⅔ κb³ sin θ, ends.
TEST(WinklerBed, HasItsMomentBeforeAndAfterUplift) {
  constexpr double stiffness = 4e6;
  Scene scene = on_a_bed(stiffness, 0, 1.5);
  scene.horizontal = testing::pulse_of(PulseShape::sine, 0.6 * scene.gravity, 0.6);
  const History history = solve_unilateral(scene, {.sample_times = regular_times(0.005, scene.duration)});
  const double b = scene.blocks.front().half_width;
  int whole = 0;
  int lifted = 0;
  for (const auto& sample : samples_of(history)) {
    const Reaction& reaction = sample.reactions.front();
    const double angle = sample.bodies.pose[0].angle;
    const double moment = reaction.normal * reaction.centre;
    const double lean = std::sin(std::abs(angle));
    const double uplift = reaction.normal / (2 * stiffness * b * b);
    const bool up = lean > uplift;
    const double expected = up ? reaction.normal * b * (1 - 2.0 / 3 * std::sqrt(uplift / lean))
                               : 2.0 / 3 * stiffness * b * b * b * lean;
    EXPECT_NEAR(std::copysign(expected, angle), moment, 1e-10 * reaction.normal * b) << sample.time;
    (up ? lifted : whole) += 1;
  }
  EXPECT_GT(whole, 20);
  EXPECT_GT(lifted, 20);
  const auto count = [&](EventKind kind) {
    return std::count_if(history.events.begin(), history.events.end(),
                         [&](const Event& event) { return event.kind == kind; });
  };
  EXPECT_GE(count(EventKind::part), 2);
  EXPECT_GE(count(EventKind::touch), 1);
}

// A weight whose line is nearer to an end than a third of the width leaves the other end free, and rests: the
// pressure is a triangle with its centre below the weight.
TEST(WinklerBed, BearsAnEccentricWeightByATriangle) {
  for (const double offset : {-0.12, -0.05, 0.02, 0.12}) {
    Scene scene = on_a_bed(4e7, 1e5, 1);
    scene.blocks.front().offset_x = offset;
    const History history = solve_unilateral(scene, {.sample_times = {0, 1}});
    EXPECT_TRUE(history.events.empty());
    const Reaction& reaction = history.reactions.front();
    const double weight = scene.blocks.front().mass * scene.gravity;
    const double angle = bodies_at(history, 0).pose[0].angle;
    EXPECT_NEAR(reaction.normal, weight, 1e-10 * weight);
    // The centre of mass is above the foot by half a metre, which leans with it.
    EXPECT_NEAR(reaction.centre * std::cos(angle), offset * std::cos(angle) + 0.5 * std::sin(angle), 1e-12);
    EXPECT_NEAR(bodies_at(history, 1).pose[0].angle, angle, 1e-12);
    const bool triangle = std::abs(reaction.centre) > 0.25 / 3;
    EXPECT_EQ(is_closed(history.patterns.front()), !triangle) << offset;
  }
}

// Where nothing rubs and the ground is still, energy goes to dashpots alone; without them nowhere.
TEST(WinklerBed, KeepsItsEnergyOrTellsIt) {
  int parted = 0;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const Scene scene = testing::bedded_scene(seed);
    if (!scene.horizontal.empty() || !scene.vertical.empty()) continue;
    const History history =
        solve_unilateral(scene, {.sample_times = regular_times(scene.duration / 20, scene.duration)});
    double scale = 0;
    for (const Block& block : scene.blocks) scale += 2 * block.mass * scene.gravity * block.half_height;
    const bool rigid = std::any_of(scene.springs.bed_stiffness.begin(), scene.springs.bed_stiffness.end(),
                                   [](double stiffness) { return std::isinf(stiffness); });
    double last = INFINITY;
    double damped = 0;
    for (const auto& sample : samples_of(history)) {
      double now = energy(scene, sample.bodies);
      double taken = 0;
      for (const auto& springs : sample.springs) {
        now += springs.elastic + springs.damped + springs.rubbed;
        taken += springs.damped;
      }
      EXPECT_LE(now, last + 1e-11 * scale) << seed << ' ' << sample.time;
      if (!rigid && std::isfinite(last)) {
        EXPECT_GE(now, last - 1e-11 * scale) << seed << ' ' << sample.time;
      }
      if (rigid || std::isinf(last)) last = now;
      EXPECT_GE(taken, damped - 1e-11 * scale) << seed << ' ' << sample.time;
      damped = taken;
    }
    const auto& dampings = scene.springs.bed_damping;
    if (!rigid && std::all_of(dampings.begin(), dampings.end(), [](double c) { return c == 0; })) {
      EXPECT_NEAR(damped, 0, 1e-11 * scale) << seed;
    }
    for (const Event& event : history.events) parted += event.kind == EventKind::part ? 1 : 0;
  }
  EXPECT_GT(parted, 20);
}

// Where a leaning block starts at the bed's surface, nothing pushes yet: the force goes with the fourth power
// of time. Without dashpots and slip the bed gives back what it takes, so that nothing is lost.
TEST(WinklerBed, StopsABlockThatStartsAtItsSurface) {
  for (const double angle : {0.02, -0.1, 0.2}) {
    Scene scene = on_a_bed(1e7, 0, 0.2);
    scene.initial.angles = {angle};
    scene.friction = {0};
    scene.initial.preloaded = false;
    const History history = solve_unilateral(scene, {.sample_times = regular_times(0.01, scene.duration)});
    const double scale = 2 * scene.blocks[0].mass * scene.gravity * scene.blocks[0].half_height;
    const double first = energy(scene, bodies_at(history, 0));
    for (const auto& sample : samples_of(history)) {
      EXPECT_NEAR(energy(scene, sample.bodies) + sample.springs[0].elastic, first, 1e-11 * scale)
          << angle << ' ' << sample.time;
    }
    EXPECT_NE(bodies_at(history, 4).pose[0].angle, angle);
  }
}

TEST(WinklerBed, RefusesABlockThatLiesFlatWithoutLoadAndTurns) {
  Scene scene = on_a_bed(1e7, 0, 0.2);
  scene.initial.velocities = {0.1};
  EXPECT_NO_THROW(validate(scene));
  scene.initial.preloaded = false;
  try {
    validate(scene);
    FAIL() << "no error";
  } catch (const FieldError& error) {
    EXPECT_STREQ(error.what(),
                 "initial.springs = unloaded: must be loaded where a block lies flat on a bed and turns, "
                 "as block 1 does");
  }
}

// Thrown up flat by the ground, a block leaves a bed and comes down on all of it at once.
TEST(WinklerBed, PartsAndLandsFlat) {
  Scene scene = on_a_bed(1e7, 2e4, 2);
  scene.vertical.samples = {30, 30, -30, -30, 0};
  scene.vertical.interval = 0.05;
  const History history = solve_unilateral(scene);
  ASSERT_GE(history.events.size(), 2U);
  EXPECT_EQ(history.events[0].kind, EventKind::part);
  EXPECT_EQ(name(history.events[0].from) + name(history.events[0].to), "C-");
  EXPECT_EQ(name(history.events[1].from) + name(history.events[1].to), "-C");
  EXPECT_NEAR(bodies_at_end(history).pose[0].angle, 0, 1e-12);
}

}  // namespace
}  // namespace rockstack
