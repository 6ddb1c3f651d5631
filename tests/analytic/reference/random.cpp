#include <gtest/gtest.h>

#include <array>
#include <tuple>

#include "tests/analytic/reference/random_scenes.hpp"

namespace rockstack::testing {
namespace {

class RandomScenes : public ::testing::TestWithParam<std::tuple<Equations, std::uint64_t>> {};

// Many more by the program reference_scenes.
TEST_P(RandomScenes, HaveEveryEventOfTheReferenceAndNoOther) {
  constexpr std::uint64_t count = 60;
  const auto [equations, first] = GetParam();
  Tally tally;
  for (std::uint64_t seed = first; seed < first + count; ++seed) {
    const std::string difference = tally.add(seed, equations);
    EXPECT_TRUE(difference.empty()) << difference;
  }
  EXPECT_GT(tally.events, 5 * count);
  RecordProperty("summary", tally.summary());
}

constexpr std::array<std::uint64_t, 5> starts{0, 60, 120, 180, 240};

INSTANTIATE_TEST_SUITE_P(Nonlinear, RandomScenes,
                         ::testing::Combine(::testing::Values(Equations::nonlinear),
                                            ::testing::ValuesIn(starts)));
INSTANTIATE_TEST_SUITE_P(Linear, RandomScenes,
                         ::testing::Combine(::testing::Values(Equations::linear),
                                            ::testing::Values(starts[0], starts[1])));

}  // namespace
}  // namespace rockstack::testing
