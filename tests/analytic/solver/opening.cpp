#include <gtest/gtest.h>

#include "tests/analytic/solver/stacks.hpp"

namespace rockstack {
namespace {

// After an impact that joins blocks, the accelerations may open an interface at once. That is an event too:
// each event starts from the pattern the one before ended with.
TEST(Opening, EveryChangeOfPatternIsAnEvent) {
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    testing::Draw draw(6000 + seed);
    const Scene scene = testing::random_scene(draw, 2 + draw.below(3), seed % 2 == 1);
    const History history = solve(scene);
    for (std::size_t i = 1; i < history.events.size(); ++i) {
      ASSERT_TRUE(history.events[i - 1].to == history.events[i].from) << "seed " << seed << '\n'
                                                                      << testing::listing(history);
    }
  }
}

TEST(Opening, AnOpeningAtTheStartIsAnEvent) {
  Scene scene = testing::released({testing::block(1, 1), testing::block(0.2, 2)}, {0.2, 0.2}, 0.01);
  const History history = solve(scene, {.sample_times = {0.005}});
  ASSERT_EQ(history.events.size(), 1U);
  EXPECT_EQ(history.events[0].time, 0);
  EXPECT_EQ(history.events[0].kind, EventKind::opening);
  EXPECT_EQ(history.events[0].interface, 2);
  EXPECT_TRUE(history.events[0].to == history.patterns[0]);
}

// A ground acceleration exactly at the threshold opens for no time at all; while that is being settled, an
// opening to the other side within the same straight line must not be lost.
TEST(Opening, TheThresholdItselfHidesNoLaterOpening) {
  for (const double width : {0.3, 0.5, 0.7}) {
    for (const double share : {1 - 1e-16, 1.0, 1 + 1e-15}) {
      Scene scene = testing::released({testing::block(width, 2)}, {0}, 1);
      const double threshold = scene.gravity * width / 2 * share;
      scene.horizontal = {1.0, {threshold, -2 * threshold}, {}, {}};
      const History history = solve(scene);
      ASSERT_FALSE(history.events.empty());
      bool found = false;
      for (const Event& event : history.events) {
        if (event.kind != EventKind::opening || event.to[0] != Contact::right) continue;
        // Falls through −threshold at 2/3 s. An opening to rounding at t = 0 may delay its watch by one step.
        EXPECT_NEAR(event.time, 2.0 / 3, 1e-13) << testing::listing(history);
        found = true;
        break;
      }
      EXPECT_TRUE(found) << testing::listing(history);
    }
  }
}

}  // namespace
}  // namespace rockstack
