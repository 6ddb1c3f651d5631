#include "comparisons/measures/statistics/joint_test.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace rockstack {
namespace {

std::vector<ReplicatedNumber> chance_numbers(std::mt19937_64& noise, std::size_t numbers) {
  std::lognormal_distribution<double> size(0, 0.5);
  std::vector<ReplicatedNumber> all(numbers, ReplicatedNumber(12));
  for (ReplicatedNumber& number : all)
    for (auto& value : number) value = size(noise);
  return all;
}

// 12 replicates can be shared out to two samples of six in 924 ways.
TEST(JointTest, ARiseByALargeFactorHasTheLeastChanceAmongManyNumbers) {
  EXPECT_EQ(ways_to_share(6, 6), 924);
  std::mt19937_64 noise(1);
  std::vector<ReplicatedNumber> numbers = chance_numbers(noise, 50);
  for (std::size_t i = 6; i < 12; ++i) *numbers[17][i] *= 100;
  const std::vector<double> chances = joint_chances(numbers, 6);
  EXPECT_DOUBLE_EQ(chances[17], 2.0 / 924);
  EXPECT_EQ(std::ranges::count_if(chances, [](double chance) { return chance < 0.05; }), 1);
}

TEST(JointTest, ValuesThatAreMissingInfiniteZeroOrAlikeAreTaken) {
  std::mt19937_64 noise(2);
  std::vector<ReplicatedNumber> numbers = chance_numbers(noise, 3);
  numbers[0].assign(12, 0.0);
  for (std::size_t i = 6; i < 12; ++i) numbers[1][i] = std::numeric_limits<double>::infinity();
  numbers[2].assign(12, std::nullopt);
  const std::vector<double> chances = joint_chances(numbers, 6);
  EXPECT_EQ(chances[0], 1);
  EXPECT_DOUBLE_EQ(chances[1], 2.0 / 924);
  EXPECT_EQ(chances[2], 1);
}

// By rounding alone the first number is parted in two, another way than the second.
TEST(JointTest, RoundingIsNoRise) {
  std::vector<ReplicatedNumber> numbers(2, ReplicatedNumber(12));
  for (std::size_t i = 0; i < 12; ++i) {
    numbers[0][i] = i % 2 == 0 ? 1.0 : 1 - 1e-15;
    numbers[1][i] = (i < 6 ? 1.0 : 100.0) * static_cast<double>(3 + i % 4);
  }
  EXPECT_DOUBLE_EQ(joint_chances(numbers, 6)[1], 2.0 / 924);
}

// Chance gives 50 ± 6.9 of 1000 results with any number at or below 0.05.
TEST(JointTest, TheChanceOfAnyAmongAllIsThatOfTheLevel) {
  std::mt19937_64 noise(3);
  int below = 0;
  for (int trial = 0; trial < 1000; ++trial)
    below += std::ranges::min(joint_chances(chance_numbers(noise, 10), 6)) <= 0.05 ? 1 : 0;
  EXPECT_NEAR(below, 50, 21);
}

}  // namespace
}  // namespace rockstack
