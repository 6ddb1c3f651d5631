#include <gtest/gtest.h>

#include "analytic/solve.hpp"
#include "tests/analytic/extremes/laws.hpp"
#include "tests/analytic/extremes/scenes.hpp"
#include "tests/analytic/unilateral/momentum_laws.hpp"
#include "tests/stride.hpp"

namespace rockstack {
namespace {

// Impacts without bounce and with Coulomb's friction always have impulses that end them: their matrix is
// copositive (Stewart & Trinkle 1996; Anitescu & Potra 1997).
TEST(Columns, OfUnequalBlocksAllHaveAnAnswer) {
  constexpr std::size_t few_blocks = 9;
  int solved = 0, impacts = 0;
  for (std::uint64_t seed = 0; seed < 60; seed += testing::stride) {
    const Scene scene = testing::unequal_column(seed);
    if (scene.blocks.size() > few_blocks) continue;
    SCOPED_TRACE(seed);
    const ContactHistory<> history =
        solve_unilateral(scene, {.sample_times = regular_times(scene.duration / 50, scene.duration)});
    EXPECT_EQ(testing::breaches(scene, history).fault, "");
    impacts += testing::impacts_by_momenta(scene, history).impacts;
    ++solved;
  }
  EXPECT_GT(testing::stride * solved, 20);
  EXPECT_GT(testing::stride * impacts, 100);
}

}  // namespace
}  // namespace rockstack
