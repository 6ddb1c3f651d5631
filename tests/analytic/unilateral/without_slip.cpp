#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/analytic/unilateral/scenes.hpp"

namespace rockstack {
namespace {

bool holds(const std::vector<Joint>& joints) {
  return std::all_of(joints.begin(), joints.end(),
                     [](const Joint& joint) { return joint.touches() && joint.slip == 0; });
}

/// The largest deviation of an event, in s and in shares of the size of angles or velocities.
double deviation(const Event& one, const ContactEvent& other) {
  double largest = std::abs(one.time - other.time);
  double size = 1;
  for (const double rate : one.after) size = std::max(size, std::abs(rate));
  for (std::size_t k = 0; k < one.after.size(); ++k) {
    largest = std::max({largest, std::abs(one.angles[k] - other.at[k].angle),
                        std::abs(one.after[k] - other.after[k].angle) / size});
  }
  return largest;
}

/// How many events of how many scenes there are, and how many of them agree to rounding.
struct Agreement {
  std::size_t events = 0, exact = 0;

  void compare(Scene scene, std::uint64_t seed) {
    scene.law = Law::consistent;
    History one;
    try {
      one = solve(scene);
    } catch (const Unfinished&) {
      return;
    }
    const ContactHistory other = solve_unilateral(testing::with_friction(scene, 1.5));
    for (std::size_t i = 0; i < one.events.size() && one.events[i].consistency == Consistency::consistent;
         ++i) {
      ASSERT_LT(i, other.events.size()) << seed;
      const ContactEvent& event = other.events[i];
      if (!holds(event.to)) break;
      ASSERT_EQ(name(one.events[i].kind), name(event.kind)) << seed << ' ' << event.time;
      ASSERT_EQ(one.events[i].interface, event.interface) << seed << ' ' << event.time;
      for (int k = 0; k < one.events[i].to.size; ++k)
        ASSERT_EQ(sign(one.events[i].to[k]), event.to[static_cast<std::size_t>(k)].side()) << seed;
      ++events;
      const double off = deviation(one.events[i], event);
      ASSERT_LT(off, 1e-8) << seed << ' ' << event.time;
      if (off < 1e-12) ++exact;
    }
  }
};

// With enough friction the law is `consistent` for as long as no block lifts off and an impact has a
// consistent pattern. Roundings grow with the motion's own sensitivity, to 10⁻⁹ in one of these scenes.
TEST(UnilateralWithoutSlip, EventsAreThoseOfLawConsistent) {
  Agreement agreement;
  for (std::uint64_t seed = 0; seed < 150; ++seed) agreement.compare(testing::seeded_scene(seed), seed);
  EXPECT_GT(agreement.events, 500U);
  EXPECT_GT(agreement.exact, agreement.events * 9 / 10);
}

// Likewise on inclined ground, with centres of mass off the middle of blocks.
TEST(UnilateralWithoutSlip, SoTheyAreWhereWeightIsAskew) {
  Agreement agreement;
  for (std::uint64_t seed = 0; seed < 150; ++seed) {
    Scene scene = testing::seeded_scene(seed);
    testing::Draw draw(seed + 70000);
    scene.inclination = draw.between(-0.05, 0.05);
    for (Block& block : scene.blocks) {
      block.offset_x = draw.between(-0.3, 0.3) * block.half_width;
      block.offset_y = draw.between(-0.5, 0.5) * block.half_height;
    }
    agreement.compare(scene, seed);
  }
  EXPECT_GT(agreement.events, 500U);
  EXPECT_GT(agreement.exact, agreement.events * 9 / 10);
}

/// Whether all that the pivots of a motion ask for is had with this friction.
bool stays_within(const std::vector<Demand>& demands, double friction) {
  return std::all_of(demands.begin(), demands.end(), [&](const Demand& demand) {
    return demand.least_normal > 0 && demand.friction < friction;
  });
}

void expect_same_demands(const std::vector<Demand>& one, const std::vector<Demand>& other,
                         std::uint64_t seed) {
  for (std::size_t k = 0; k < one.size(); ++k) {
    // Infinite where an interface bears no impact.
    if (one[k].least_normal != other[k].least_normal) {
      EXPECT_NEAR(one[k].least_normal, other[k].least_normal, 1e-8 * one[k].least_normal) << seed;
    }
    EXPECT_NEAR(one[k].friction, other[k].friction, 1e-8) << seed;
    EXPECT_EQ(other[k].first_pull_time, std::numeric_limits<double>::infinity());
    EXPECT_EQ(other[k].first_slip_time, std::numeric_limits<double>::infinity());
  }
}

// What acts, and how far blocks lean, is then what the pivots' solver tells of its own motion.
TEST(UnilateralWithoutSlip, DemandsAndPeaksAreThoseOfLawConsistent) {
  constexpr double friction = 1.5;
  int scenes = 0;
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    Scene scene = testing::seeded_scene(seed);
    scene.law = Law::consistent;
    const History one = solve(scene, {.validity = true, .peaks = true});
    if (!stays_within(one.forces, friction) || !stays_within(one.impulses, friction)) continue;
    const ContactHistory other =
        solve_unilateral(testing::with_friction(scene, friction), {.validity = true, .peaks = true});
    ++scenes;
    expect_same_demands(one.forces, other.forces, seed);
    expect_same_demands(one.impulses, other.impulses, seed);
    for (std::size_t k = 0; k < one.peaks.size(); ++k)
      EXPECT_NEAR(one.peaks[k], other.peaks[k], 1e-8) << seed;
  }
  EXPECT_GT(scenes, 20);
}

}  // namespace
}  // namespace rockstack
