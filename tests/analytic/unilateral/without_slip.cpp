#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

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

// With enough friction the law is `consistent` for as long as no block lifts off and an impact has a
// consistent pattern. Roundings grow with the motion's own sensitivity, to 10⁻⁹ in one of these scenes.
TEST(UnilateralWithoutSlip, EventsAreThoseOfLawConsistent) {
  std::size_t events = 0;
  std::size_t exact = 0;
  for (std::uint64_t seed = 0; seed < 150; ++seed) {
    Scene scene = testing::seeded_scene(seed);
    scene.law = Law::consistent;
    History one;
    try {
      one = solve(scene);
    } catch (const Unfinished&) {
      continue;
    }
    const ContactHistory other = solve_unilateral(scene, {.friction = std::vector(scene.blocks.size(), 1.5)});
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
  EXPECT_GT(events, 500U);
  EXPECT_GT(exact, events * 9 / 10);
}

}  // namespace
}  // namespace rockstack
