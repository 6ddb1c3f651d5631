#include <gtest/gtest.h>

#include "tests/analytic/reference/random_scenes.hpp"

namespace rockstack::testing {
namespace {

class RandomScenes : public ::testing::TestWithParam<std::uint64_t> {};

// Many more by the program reference_scenes.
TEST_P(RandomScenes, HaveEveryEventOfTheReferenceAndNoOther) {
  constexpr std::uint64_t count = 60;
  Tally tally;
  for (std::uint64_t seed = GetParam(); seed < GetParam() + count; ++seed) {
    const std::string difference = tally.add(seed);
    EXPECT_TRUE(difference.empty()) << difference;
  }
  EXPECT_GT(tally.events, 5 * count);
  RecordProperty("summary", tally.summary());
}

INSTANTIATE_TEST_SUITE_P(From, RandomScenes, ::testing::Values(0, 60, 120, 180, 240),
                         ::testing::PrintToStringParamName());

}  // namespace
}  // namespace rockstack::testing
