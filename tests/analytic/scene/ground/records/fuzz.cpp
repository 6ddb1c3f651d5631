#include <gtest/gtest.h>

#include <random>

#include "tests/analytic/scene/ground/records/mutations.hpp"

namespace rockstack {
namespace {

TEST(RecordMutations, EveryLayoutIsReadUnharmed) {
  for (const std::string& text : one_of_each_layout()) EXPECT_EQ(outcome_of(text), Outcome::record) << text;
}

TEST(RecordMutations, GiveFiniteSamplesOrAnInputErrorAndNothingElse) {
  constexpr int rounds = 500;
  std::mt19937_64 random(20010117);
  int refused = 0;
  for (int round = 0; round < rounds; ++round) {
    for (const std::string& text : one_of_each_layout()) {
      const std::string wounded = mutated(text, random);
      ASSERT_NO_THROW(refused += outcome_of(wounded) == Outcome::refused ? 1 : 0) << wounded;
    }
  }
  EXPECT_GT(refused, rounds) << "mutations must do harm";
}

TEST(RecordMutations, EveryBeginningOfAFileIsReadOrRefused) {
  for (const std::string& text : one_of_each_layout()) {
    for (std::size_t length = 0; length < text.size(); ++length) {
      ASSERT_NO_THROW(outcome_of(text.substr(0, length))) << text.substr(0, length);
    }
  }
}

}  // namespace
}  // namespace rockstack
