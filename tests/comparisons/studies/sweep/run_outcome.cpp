#include "comparisons/studies/sweep/run_outcome.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "analytic/solve.hpp"

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

/// A low block on ground that for half a second is pushed aside, or falls away, with some share of gravity.
Scene pushed(double aside, double down) {
  const auto rectangle = [](double amplitude) {
    GroundMotion motion;
    motion.pulse = Pulse{.shape = PulseShape::rectangle, .amplitude = amplitude, .period = 0.5};
    return motion;
  };
  Scene scene;
  scene.blocks = {make_block(4, 0.5, 2500)};
  scene.initial = {{0}, {0}};
  scene.duration = 4;
  scene.law = Law::unilateral;
  scene.friction = {0.4};
  if (aside > 0) scene.horizontal = rectangle(aside * scene.gravity);
  if (down > 0) scene.vertical = rectangle(-down * scene.gravity);
  return scene;
}

// A push of A g over the time t leaves the slip A g t² (A/μ − 1)/2. Ground that falls at a for the time t,
// and then goes on down at its speed, is left by a − g, and caught up with at g: (a − g) t² a/(2 g) away at
// most.
TEST(RunOutcome, SlipLeftAndHighestLiftAreThoseOfClosedForms) {
  const auto outcome = [](const Scene& scene) { return run_outcome(scene, solve(scene, run_options())); };
  const Scene slides = pushed(1.0, 0);
  const double g = slides.gravity;
  EXPECT_NEAR(*outcome(slides).slip, 0.5 * g * 0.25 * (1 / 0.4 - 1), 1e-12);
  EXPECT_EQ(*outcome(slides).lift, 0);
  const Scene flies = pushed(0, 1.5);
  EXPECT_NEAR(*outcome(flies).lift, 0.5 * g * 0.25 * 0.5 * 1.5, 1e-12);
  EXPECT_NEAR(*outcome(flies).slip, 0, 1e-12);
  Scene closed = slides;
  closed.law = Law::consistent;
  EXPECT_FALSE(outcome(closed).slip || outcome(closed).lift);
}

}  // namespace
}  // namespace rockstack
