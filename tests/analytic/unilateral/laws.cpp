#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "tests/analytic/unilateral/scenes.hpp"

namespace rockstack {
namespace {

using testing::rubbing_scene;
using testing::with_friction;

std::vector<double> regular(double interval, double duration) {
  return regular_times(interval, duration);
}

bool slips_or_flies(const History& history) {
  for (const Event& event : history.events)
    if (!all_stick(event.to)) return true;
  return false;
}

/// What roundings may make of energies, J: each step and each event leaves some units in the last place of
/// them; a sample has a few of either before it.
double rounding(const Scene& scene, const Bodies<>& bodies) {
  return 100 * std::numeric_limits<double>::epsilon() * energy(scene, bodies);
}

TEST(ContactLaws, SamplesAreThoseThatAreAskedFor) {
  const Scene scene = with_friction(testing::single(1, 2, 0.5), 0.4);
  const std::vector<double> times{0, 0.2, 0.2, 0.5, 0.5};
  const History history = solve_unilateral(scene, {.sample_times = times});
  EXPECT_EQ(history.times, times);
  for (const std::vector<double>& wrong : {std::vector<double>{-1}, {0.3, 0.2}, {std::nan("")}})
    EXPECT_THROW(solve_unilateral(scene, {.sample_times = wrong}), std::invalid_argument);
}

void expect_no_event_to_add_energy(const Scene& scene, const History& history, std::uint64_t seed) {
  for (const Event& event : history.events) {
    const Bodies<> before = bodies_before(event);
    EXPECT_LE(energy(scene, bodies_after(event)), energy(scene, before) + rounding(scene, before))
        << seed << ' ' << event.time;
  }
}

TEST(UnilateralLaws, EnergyNeverRisesWhereTheGroundIsStill) {
  int rubbing = 0;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    testing::Draw draw(seed);
    Scene scene = with_friction(testing::random_scene(draw, 1 + draw.below(3), false), 0);
    for (double& friction : scene.friction) friction = draw.between(0.05, 0.8);
    const History history = solve_unilateral(scene, {.sample_times = regular(0.01, scene.duration)});
    if (slips_or_flies(history)) ++rubbing;
    double last = energy(scene, bodies_at(history, 0));
    for (const auto& sample : samples_of(history)) {
      EXPECT_LE(energy(scene, sample.bodies), last + rounding(scene, sample.bodies))
          << seed << ' ' << sample.time;
      last = energy(scene, sample.bodies);
    }
    expect_no_event_to_add_energy(scene, history, seed);
  }
  EXPECT_GE(rubbing, 30);
}

TEST(UnilateralLaws, ImpactsLeaveEnergyOrTakeIt) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const Scene scene = rubbing_scene(seed);
    expect_no_event_to_add_energy(scene, solve_unilateral(scene), seed);
  }
}

/// How deep a block is in the one below at any sample, m. Blocks that lie on each other's sides have no gap.
double deepest(const History& history) {
  double least = 0;
  for (const auto& sample : samples_of(history)) {
    double below = 0;
    for (std::size_t k = 0; k < sample.gaps.size(); ++k) {
      const double angle = sample.bodies.pose[k].angle;
      if (std::abs(angle - below) < std::numbers::pi / 2) least = std::min(least, sample.gaps[k]);
      below = angle;
    }
  }
  return -least;
}

// Where a block has just left another, its other corner may be above the face by rounding, and come down.
TEST(UnilateralLaws, NoBlockSinksIntoAnother) {
  for (const std::uint64_t seed : {0, 1, 2, 3, 4, 5, 71, 1532, 1561, 1563, 2916, 3751, 3882}) {
    const Scene scene = testing::slippery(testing::seeded_scene(seed), seed);
    const History history =
        solve_unilateral(scene, {.sample_times = regular(scene.duration / 50, scene.duration)});
    EXPECT_LT(deepest(history), 1e-13) << seed;
  }
}

// Ever larger friction leaves no scene without a next moment, and no event with more energy. In the scenes of
// large seeds roundings lead Lemke's method astray, or blocks fly side by side with no force between them.
TEST(UnilateralLaws, FrictionWithoutBoundsLetsMotionsGoOn) {
  for (const std::uint64_t seed : {33, 72, 84, 866, 1224, 1249, 1749, 1763, 2262, 2317, 2326, 2365, 2844}) {
    for (const double friction : {1.0, 5.0, 1000.0}) {
      const Scene scene = with_friction(testing::seeded_scene(seed), friction);
      const History history = solve_unilateral(scene);
      expect_no_event_to_add_energy(scene, history, seed);
      if (!ends_early(history)) continue;
      const EventKind end = history.events.back().kind;
      EXPECT_TRUE(ends_motion(end)) << seed;
    }
  }
}

/// How far the higher corner of a block's lower face is off the plane of the face below, m.
double corner_rise_at(const Scene& scene, const Poses<>& poses, std::size_t k) {
  const Pose<> below = pose_of(poses, static_cast<int>(k) - 1);
  const Block& own = scene.blocks[k];
  double highest = -std::numeric_limits<double>::infinity();
  for (const int side : {-1, 1}) {
    const Point<double> corner =
        turned<double>(side * own.half_width - own.offset_x, -own.half_height - own.offset_y,
                       std::cos(poses[k].angle), std::sin(poses[k].angle));
    const double up = (poses[k].x + corner.x() - below.x) * std::sin(below.angle) +
                      (poses[k].y + corner.y() - below.y) * std::cos(below.angle);
    const double face = k > 0 ? scene.blocks[k - 1].half_height - scene.blocks[k - 1].offset_y : 0;
    highest = std::max(highest, up - face);
  }
  return highest;
}

TEST(UnilateralLaws, NothingPullsNorRubsMoreThanItsFriction) {
  int partings = 0;
  int slips = 0;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const Scene scene = rubbing_scene(seed);
    const History history = solve_unilateral(
        scene, {.sample_times = regular(0.01, scene.duration), .validity = true, .peaks = true});
    for (std::size_t k = 0; k < scene.blocks.size(); ++k) {
      for (const auto* demands : {&history.forces, &history.impulses}) {
        const Demand& demand = (*demands)[k];
        EXPECT_GE(demand.least_normal, 0) << seed;
        // Normal forces above their rounding are known to two digits at least.
        EXPECT_LE(demand.friction, 1.01 * scene.friction[k]) << seed;
        EXPECT_GE(demand.least_normal_time, 0) << seed;
        EXPECT_LE(demand.friction_time, scene.duration) << seed;
        if (demand.least_normal == 0) ++partings;
        if (demand.friction > 0.99 * scene.friction[k]) ++slips;
      }
      EXPECT_LE(std::abs(history.slips_left[k]), history.largest_slips[k]) << seed;
      for (const auto& sample : samples_of(history)) {
        EXPECT_LE(std::abs(sample.bodies.pose[k].angle), history.peaks[k] + 1e-15) << seed;
        // Places round to some units in the last place of metres.
        EXPECT_LE(std::abs(sample.slips[k]), history.largest_slips[k] + 1e-13) << seed;
        EXPECT_LE(corner_rise_at(scene, sample.bodies.pose, k), history.uplifts[k] + 1e-13) << seed;
      }
    }
  }
  EXPECT_GT(partings, 20);
  EXPECT_GT(slips, 50);
}

/// Momenta of a stack and its angular momentum about its centre of mass, counterclockwise.
struct Momenta {
  double x = 0, y = 0, turning = 0;
};

Momenta momenta(const Scene& scene, const Bodies<>& bodies) {
  Momenta result;
  double mass = 0;
  double centre_x = 0;
  double centre_y = 0;
  for (std::size_t k = 0; k < scene.blocks.size(); ++k) {
    const Block& block = scene.blocks[k];
    mass += block.mass;
    centre_x += block.mass * bodies.pose[k].x;
    centre_y += block.mass * bodies.pose[k].y;
    result.x += block.mass * bodies.velocity[k].x;
    result.y += block.mass * bodies.velocity[k].y;
    result.turning +=
        block.mass * (bodies.pose[k].x * bodies.velocity[k].y - bodies.pose[k].y * bodies.velocity[k].x) -
        block.inertia * bodies.velocity[k].angle;
  }
  result.turning -= (centre_x * result.y - centre_y * result.x) / mass;
  return result;
}

// The top rocks back onto the base while the ground falls away under both.
TEST(UnilateralLaws, AFlyingStackKeepsItsMomentum) {
  for (const double angle : {0.02, 0.05, -0.08}) {
    Scene scene = testing::released({testing::block(1, 1), testing::block(0.6, 0.9)}, {0, angle}, 0.5);
    scene.initial.velocities = {0, -12 * angle};
    scene.vertical = testing::pulse_of(PulseShape::rectangle, -3 * scene.gravity, 0.5);
    scene.friction = {0.5, 0.3};
    const History history = solve_unilateral(scene, {.sample_times = regular(0.01, scene.duration)});
    double mass = 0;
    for (const Block& block : scene.blocks) mass += block.mass;
    int impacts = 0;
    for (const Event& event : history.events) {
      EXPECT_EQ(event.to[0], Contact::apart);
      if (event.kind == EventKind::impact) ++impacts;
    }
    EXPECT_GT(impacts, 0);
    const Momenta first = momenta(scene, bodies_at(history, 1));
    for (std::size_t i = 2; i < history.size(); ++i) {
      const Momenta now = momenta(scene, bodies_at(history, i));
      const double time = history.times[i] - history.times[1];
      EXPECT_NEAR(now.x, first.x, 1e-12 * mass);
      EXPECT_NEAR(now.y, first.y + 2 * mass * scene.gravity * time, 1e-12 * mass);
      EXPECT_NEAR(now.turning, first.turning, 1e-12 * mass);
    }
  }
}

Poses<> mirrored(Poses<> poses) {
  for (Pose<>& pose : poses) {
    pose.x = -pose.x;
    pose.angle = -pose.angle;
  }
  return poses;
}

void expect_equal(const Poses<>& one, const Poses<>& other, std::uint64_t seed) {
  for (std::size_t k = 0; k < one.size(); ++k) {
    EXPECT_EQ(one[k].x, other[k].x) << seed;
    EXPECT_EQ(one[k].y, other[k].y) << seed;
    EXPECT_EQ(one[k].angle, other[k].angle) << seed;
  }
}

TEST(UnilateralLaws, AMirroredSceneHasTheMirroredHistoryBitForBit) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const Scene scene = rubbing_scene(seed);
    Scene image = scene;
    for (auto* values : {&image.initial.angles, &image.initial.velocities, &image.horizontal.samples})
      for (double& value : *values) value = -value;
    if (image.horizontal.pulse) image.horizontal.pulse->amplitude *= -1;
    const History one = solve_unilateral(scene);
    const History other = solve_unilateral(image);
    ASSERT_EQ(one.events.size(), other.events.size()) << seed;
    for (std::size_t i = 0; i < one.events.size(); ++i) {
      EXPECT_EQ(one.events[i].time, other.events[i].time) << seed;
      EXPECT_EQ(one.events[i].kind, other.events[i].kind) << seed;
      const Bodies<> after = bodies_after(one.events[i]), image_after = bodies_after(other.events[i]);
      expect_equal(after.pose, mirrored(image_after.pose), seed);
      expect_equal(after.velocity, mirrored(image_after.velocity), seed);
      for (std::size_t k = 0; k < scene.blocks.size(); ++k) {
        EXPECT_EQ(one.events[i].to.slides[k], -other.events[i].to.slides[k]);
        const Contact contact = one.events[i].to.contacts[k];
        EXPECT_EQ(other.events[i].to.contacts[k], contact == Contact::apart ? contact : opposite(contact));
      }
    }
    expect_equal(bodies_at_end(one).pose, mirrored(bodies_at_end(other).pose), seed);
  }
}

// Four times the lengths at the same gravity take twice the time; both factors round nothing.
TEST(UnilateralLaws, ALargerStackDoesTheSameMoreSlowly) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const Scene scene = rubbing_scene(seed);
    Scene large = scene;
    large.duration *= 2;
    for (Block& block : large.blocks) {
      block.half_width *= 4;
      block.half_height *= 4;
      block.inertia *= 16;
    }
    for (double& velocity : large.initial.velocities) velocity /= 2;
    for (GroundMotion* motion : {&large.horizontal, &large.vertical}) {
      motion->interval *= 2;
      if (!motion->pulse) continue;
      motion->pulse->period *= 2;
      motion->pulse->start *= 2;
    }
    const History one = solve_unilateral(scene);
    const History other = solve_unilateral(large);
    ASSERT_EQ(one.events.size(), other.events.size()) << seed;
    for (std::size_t i = 0; i < one.events.size(); ++i) {
      EXPECT_EQ(2 * one.events[i].time, other.events[i].time) << seed;
      for (std::size_t k = 0; k < scene.blocks.size(); ++k) {
        EXPECT_EQ(4 * bodies_after(one.events[i]).pose[k].x, bodies_after(other.events[i]).pose[k].x) << seed;
        EXPECT_EQ(one.events[i].after[k], 2 * other.events[i].after[k]) << seed;
      }
    }
  }
}

}  // namespace
}  // namespace rockstack
