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

}  // namespace
}  // namespace rockstack::testing
