#include "comparisons/measures/metrics/toppling.hpp"

#include <gtest/gtest.h>

#include "analytic/solve.hpp"

namespace rockstack {
namespace {

TEST(Toppling, ReportedAndObservedInSamplesNameTheSameBlockAndTime) {
  Scene scene;
  scene.duration = 5;
  scene.blocks = {make_block(1, 4, 2500)};
  scene.initial = {{0.3}, {0}};  // past its balance at atan(1/4)
  History history = solve(scene);
  const double end = history.events.back().time;
  history = solve(scene, {.sample_times = regular_times(1e-3, scene.duration)});
  EXPECT_EQ(reported_toppling(history).rfind("block 1 at ", 0), 0U);
  EXPECT_EQ(observed_toppling(scene, history), "");
  history.times.push_back(end);
  history.angles.push_back(1.001 * toppling_angle(scene, 0));
  history.velocities.push_back(0);
  EXPECT_EQ(observed_toppling(scene, history), reported_toppling(history));
}

TEST(Toppling, VerdictNamesWhoTopples) {
  EXPECT_EQ(toppling_verdict(false, false), TopplingVerdict::neither);
  EXPECT_EQ(toppling_verdict(true, true), TopplingVerdict::both);
  EXPECT_EQ(toppling_verdict(true, false), TopplingVerdict::exact_alone);
  EXPECT_EQ(toppling_verdict(false, true), TopplingVerdict::engine_alone);
}

}  // namespace
}  // namespace rockstack
