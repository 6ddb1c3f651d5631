#include "comparisons/measures/metrics/rest.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "analytic/solve.hpp"

namespace rockstack {
namespace {

Scene released_block() {
  Scene scene;
  scene.duration = 8;
  scene.blocks = {make_block(1, 3, 2500)};
  scene.initial = {{0.1}, {0}};
  return scene;
}

// A block that comes to rest has one settling, and its last chatter lies in it.
TEST(Settlings, AllChatterOfABlockIsOne) {
  const Scene scene = released_block();
  const History history = solve(scene, {.sample_times = regular_times(1e-3, scene.duration)});
  ASSERT_EQ(history.events.back().kind, EventKind::rest);
  const auto list = settlings(scene, history);
  ASSERT_EQ(list.size(), 1U);
  EXPECT_EQ(list[0].interface, 1);
  EXPECT_LT(list[0].time, history.events.back().time);
  const auto inside = std::count_if(history.events.begin(), history.events.end(), [&](const Event& event) {
    return event.kind == EventKind::impact && event.time > list[0].time;
  });
  EXPECT_GT(inside, 10);
}

TEST(Settlings, NoneOfAStackThatNeverMoves) {
  Scene scene = released_block();
  scene.initial.angles = {0};
  EXPECT_TRUE(settlings(scene, solve(scene, {.sample_times = regular_times(1e-2, scene.duration)})).empty());
}

/// Samples of one block every 0.1 s for 1 s.
History moving_at(double velocity, const Pattern& pattern) {
  History history;
  history.blocks = 1;
  for (int i = 0; i <= 10; ++i) history.times.push_back(0.1 * i);
  history.angles.assign(11, 0);
  history.velocities.assign(11, velocity);
  history.patterns.assign(11, pattern);
  return history;
}

TEST(ResidualMotion, IsTheEnginesSpeedWhereTheExactSolutionRests) {
  const History engine = moving_at(-3e-4, {});
  EXPECT_NEAR(residual_motion(moving_at(0, closed_pattern(1)), engine).value(), 3e-4, 1e-18);
}

TEST(ResidualMotion, IsNotGivenWhereTheExactSolutionMoves) {
  History exact = moving_at(0, closed_pattern(1));
  exact.patterns.back()[0] = Contact::left;
  EXPECT_FALSE(residual_motion(exact, moving_at(0, {})));
}

}  // namespace
}  // namespace rockstack
