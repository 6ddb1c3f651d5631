#include <gtest/gtest.h>

#include <random>

#include "tests/analytic/scene/ground/records/mutations.hpp"
#include "tests/analytic/scene/input/scene_mutations.hpp"

namespace rockstack {
namespace {

TEST(SceneMutations, GiveAValidSceneOrAnInputErrorAndNothingElse) {
  const TemporaryFolder folder;
  std::mt19937_64 random(1963);
  int refused = 0;
  constexpr int rounds = 500;
  for (int round = 0; round < rounds; ++round) {
    for (const std::string& text : scenes_with_every_key()) {
      const std::string wounded = mutated(text, random);
      ASSERT_NO_THROW(refused += is_read(folder, wounded) ? 0 : 1) << wounded;
    }
  }
  EXPECT_GT(refused, rounds) << "mutations must do harm";
}

TEST(SceneMutations, UnharmedScenesAreReadButForTheMissingRecord) {
  const TemporaryFolder folder;
  int read = 0;
  for (const std::string& text : scenes_with_every_key()) read += is_read(folder, text) ? 1 : 0;
  EXPECT_EQ(read, 3);
}

}  // namespace
}  // namespace rockstack
