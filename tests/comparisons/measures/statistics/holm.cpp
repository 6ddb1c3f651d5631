#include "comparisons/measures/statistics/holm.hpp"

#include <gtest/gtest.h>

namespace rockstack {
namespace {

// The least of n is multiplied by n, the next by n − 1, …; none falls below one before it.
TEST(Holm, StepsDownFromTheLeastChance) {
  const AdjustedTests adjusted = adjust({{0.02, 0}, {0.01, 0}, {0.05, 0}, {0.04, 0}, {0.03, 0}}, 0.05);
  const std::vector<double> expected{0.08, 0.05, 0.09, 0.09, 0.09};
  EXPECT_EQ(adjusted.counted, 5U);
  for (std::size_t i = 0; i < expected.size(); ++i)
    EXPECT_NEAR(adjusted.p_values[i], expected[i], 1e-15) << i;
}

// Ninety tests of two values each, whose least chance is 1/3, take nothing from ten that can show something.
TEST(Holm, TestsThatCannotShowAnythingDoNotCount) {
  std::vector<TestChance> tests(10, {0.5, 1e-4});
  tests.front().p_value = 0.004;
  tests.resize(100, {1.0 / 3, 1.0 / 3});
  const AdjustedTests adjusted = adjust(tests, 0.05);
  EXPECT_EQ(adjusted.counted, 10U);
  EXPECT_NEAR(adjusted.p_values.front(), 0.04, 1e-15);
  EXPECT_EQ(adjusted.p_values.back(), 1);
}

// Twenty tests that reach 0.004 at best: a share of 0.05/12 is enough for all of them, 0.05/13 for none.
TEST(Holm, WhereTooManyCouldJustShowSomethingNoneCounts) {
  EXPECT_EQ(adjust(std::vector<TestChance>(20, {0.004, 0.004}), 0.05).counted, 0U);
  EXPECT_EQ(adjust(std::vector<TestChance>(12, {0.004, 0.004}), 0.05).counted, 12U);
  EXPECT_EQ(adjust({}, 0.05).counted, 0U);
}

}  // namespace
}  // namespace rockstack
