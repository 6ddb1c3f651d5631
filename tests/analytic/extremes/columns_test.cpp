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
TEST(Columns, OfUnequalBlocksAllHaveAnAnswerThatObeys) {
  constexpr std::size_t few_blocks = 9;
  int solved = 0, impacts = 0;
  for (std::uint64_t seed = 0; seed < 60; seed += testing::stride) {
    const Scene scene = testing::unequal_column(seed);
    if (scene.blocks.size() > few_blocks) continue;
    SCOPED_TRACE(seed);
    const History history =
        solve_unilateral(scene, {.sample_times = regular_times(scene.duration / 50, scene.duration)});
    EXPECT_EQ(testing::contact_breaches(scene, history).fault, "");
    const testing::ImpactTally tally = testing::impacts_by_momenta(scene, history);
    EXPECT_EQ(tally.broken, 0);
    impacts += tally.impacts;
    ++solved;
  }
  EXPECT_GT(testing::stride * solved, 20);
  EXPECT_GT(testing::stride * impacts, 100);
}

// A corner that slides off its face parts by the other face, and closures hold nothing that pulls (142). A
// corner in flight may be put a hair below its face by the closures of blocks below: it lands there (737).
TEST(Columns, WhosePartsFlyWhileOthersCloseObeyToo) {
  for (const std::uint64_t seed : {142, 737}) {
    SCOPED_TRACE(seed);
    const Scene scene = testing::unequal_column(seed);
    const History history =
        solve_unilateral(scene, {.sample_times = regular_times(scene.duration / 50, scene.duration)});
    EXPECT_EQ(testing::contact_breaches(scene, history).fault, "");
    EXPECT_EQ(testing::impacts_by_momenta(scene, history).broken, 0);
  }
}

}  // namespace
}  // namespace rockstack
