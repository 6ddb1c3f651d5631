#include <gtest/gtest.h>

#include "tests/analytic/reference/random_scenes.hpp"

namespace rockstack::testing {
namespace {

// Blocks that slip and fly have the events of the reference, or part from them where a rounding of the input
// does so too, or at the resolution of chatter. Many more by the program reference_scenes.
TEST(RandomContacts, HaveTheEventsOfTheReferenceUnlessRoundingsDecide) {
  constexpr std::uint64_t count = 8;
  Tally tally;
  for (std::uint64_t seed = 0; seed < count; ++seed) {
    const std::string difference = tally.add(seed, rubbing_scene_of(seed));
    EXPECT_EQ(tally.unexplained, 0U) << difference;
  }
  EXPECT_GT(tally.events, 5 * count);
  EXPECT_LE(tally.parted, count / 4);
  EXPECT_LT(tally.worst.time, 1e-11);
  RecordProperty("summary", tally.summary());
}

// A sliding corner whose friction is about to jam it unloads within 10⁻⁸ s: as G_NN − μ |G_NT| comes to zero
// together with the force, the latter goes like a root of the time that is left. 10⁻¹⁰ s before that the base
// slips.
TEST(SingularForces, AreFollowedToTheEventThatComesFirst) {
  Tally tally;
  EXPECT_EQ(tally.add(1439, rubbing_scene_of(1439)), "");
  EXPECT_GT(tally.events, 5U);
  EXPECT_LT(tally.worst.time, 1e-14);
}

}  // namespace
}  // namespace rockstack::testing
