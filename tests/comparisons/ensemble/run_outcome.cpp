#include "comparisons/ensemble/run_outcome.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace rockstack {
namespace {

TEST(RunOutcome, SumsUpAHistory) {
  Scene scene;
  scene.blocks = {make_block(1, 2, 2500),
                  make_block(3, 4, 2500)};  // the upper one stands on half a metre either side
  History history;
  history.blocks = 2;
  history.peaks = {0.1, 0.2};
  double time = 0;
  for (const EventKind kind :
       {EventKind::opening, EventKind::impact, EventKind::closure, EventKind::rest, EventKind::topple}) {
    history.events.push_back({});
    history.events.back().kind = kind;
    history.events.back().interface = 2;
    history.events.back().time = time += 0.1;
  }
  history.forces = {{5, 0, 0.3, 0}, {-2, 0, 0.1, 0}};
  history.impulses = {{7, 0, 0.2, 0}, {9, 0, 0.6, 0}};
  const RunOutcome outcome = run_outcome(scene, history);
  EXPECT_EQ(outcome.peaks, history.peaks);
  EXPECT_DOUBLE_EQ(outcome.peak_ratio, 0.2 / std::atan2(0.5, 2));
  EXPECT_EQ(outcome.toppled, 2);
  EXPECT_EQ(outcome.topple_time, time);
  EXPECT_EQ(outcome.last_event_time, time);
  EXPECT_EQ(outcome.impacts, 3u) << "closure and rest are impacts that end chatter";
  EXPECT_EQ(outcome.events, 5u);
  EXPECT_EQ(outcome.force.least_normal, -2);
  EXPECT_EQ(outcome.force.friction, 0.3);
  EXPECT_EQ(outcome.impulse.least_normal, 7);
  EXPECT_EQ(outcome.impulse.friction, 0.6);
}

}  // namespace
}  // namespace rockstack
