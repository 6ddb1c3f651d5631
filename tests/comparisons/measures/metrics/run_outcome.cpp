#include "comparisons/measures/metrics/run_outcome.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "analytic/solve.hpp"
#include "comparisons/measures/results/csv.hpp"
#include "tests/comparisons/studies/sweep/sweep_folder.hpp"

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

// Three cubes lean as one, past their balance at atan(1/3) but not past that of a cube: one, side by
// side with others, and with contacts.
TEST(RunOutcome, TellsWhatFallsStillAtTheEnd) {
  Scene scene;
  scene.duration = 0.5;
  scene.blocks.assign(3, make_block(1, 1, 2500));
  const auto falling = [&](double angle) {
    scene.initial = {{angle, angle, angle}, {0, 0, 0}};
    return run_outcome(scene, solve(scene, run_options())).falling;
  };
  for (const Law law : {Law::consistent, Law::unilateral}) {
    scene.law = law;
    EXPECT_EQ(falling(0.4), 1);
    EXPECT_EQ(falling(-0.4), 1);
    EXPECT_EQ(falling(0.3), 0);
  }
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

GroundMotion rectangle(double amplitude) {
  GroundMotion motion;
  motion.pulse = Pulse{.shape = PulseShape::rectangle, .amplitude = amplitude, .period = 0.1};
  return motion;
}

/// A block at rest, r times as high as wide, on ground that is pushed aside by A g and up by V g.
Scene struck(double r, double friction, double push, double lift = 0) {
  Scene scene;
  scene.blocks = {make_block(1, r, 2500)};
  scene.initial = {{0}, {0}};
  scene.duration = 0.01;
  scene.law = Law::unilateral;
  scene.friction = {friction};
  scene.horizontal = rectangle(push * scene.gravity);
  if (lift != 0) scene.vertical = rectangle(lift * scene.gravity);
  return scene;
}

MotionMode onset(const Scene& scene) {
  return onset_mode(scene, solve(scene, {.events = EventsKept::summed}));
}

/// Shenton 1996: the friction above which a tilting block does not slip.
double rocking_friction(double r, double push) {
  return (push * (4 + r * r) + 3 * r) / (1 + 4 * r * r + 3 * push * r);
}

// A hundred-millionth to either side tells the modes apart; closed forms and solver round at 1e-15.
constexpr double below = 1 - 1e-8, above = 1 + 1e-8;

TEST(MotionModes, ABlockSlidesFromAPushOfItsFrictionOn) {
  for (const double r : {1.5, 2.0, 4.0})
    for (const double friction : {0.1, 0.5 / r, 0.9 / r}) {
      EXPECT_EQ(onset(struck(r, friction, friction * below)), MotionMode::rest) << r << ' ' << friction;
      EXPECT_EQ(onset(struck(r, friction, friction * above)), MotionMode::slide) << r << ' ' << friction;
      EXPECT_EQ(onset(struck(r, friction, 3)), MotionMode::slide) << r << ' ' << friction;
    }
}

TEST(MotionModes, ARoughBlockRocksFromAPushOfWidthOverHeightOn) {
  for (const double r : {1.5, 2.0, 4.0}) {
    EXPECT_EQ(onset(struck(r, 1.5 / r, below / r)), MotionMode::rest) << r;
    EXPECT_EQ(onset(struck(r, 1.5 / r, above / r)), MotionMode::rock) << r;
  }
}

TEST(MotionModes, SlideRockLiesBetweenShentonsFrictions) {
  for (const double r : {1.5, 2.0, 4.0})
    for (const double push : {1.2 / r, 1.0, 2.0}) {
      const double sticks = rocking_friction(r, push);
      EXPECT_EQ(onset(struck(r, sticks * above, push)), MotionMode::rock) << r << ' ' << push;
      EXPECT_EQ(onset(struck(r, sticks * below, push)), MotionMode::slide_rock) << r << ' ' << push;
      EXPECT_EQ(onset(struck(r, above / r, push)), MotionMode::slide_rock) << r << ' ' << push;
      EXPECT_EQ(onset(struck(r, below / r, push)), MotionMode::slide) << r << ' ' << push;
    }
}

// On ground that falls with V g a block weighs 1 − V of its weight: all boundaries are those of A/(1 − V).
TEST(MotionModes, OnFallingGroundBoundariesAreThoseOfTheWeightThatIsLeft) {
  const double r = 2, fall = 0.4;
  for (const double push : {0.36, 0.6}) {
    const double sticks = rocking_friction(r, push / (1 - fall));
    EXPECT_EQ(onset(struck(r, sticks * above, push, -fall)), MotionMode::rock) << push;
    EXPECT_EQ(onset(struck(r, sticks * below, push, -fall)), MotionMode::slide_rock) << push;
  }
  EXPECT_EQ(onset(struck(r, 10, 0, -below)), MotionMode::rest);
  EXPECT_EQ(onset(struck(r, 10, 0, -above)), MotionMode::free_flight);
}

TEST(MotionModes, AMotionIsAllThatItComesTo) {
  Scene scene;
  scene.blocks = {make_block(1, 2, 2500)};
  scene.initial = {{0}, {0}};
  History history;
  history.blocks = 1;
  EXPECT_EQ(whole_mode(scene, history), MotionMode::rest);
  const auto add = [&](EventKind kind, Contact contact, std::int8_t slide) {
    Event event;
    event.kind = kind;
    event.to = closed_pattern(1);
    event.to[0] = contact;
    event.to.slides[0] = slide;
    history.events.push_back(event);
    return whole_mode(scene, history);
  };
  EXPECT_EQ(add(EventKind::slip, Contact::closed, 1), MotionMode::slide);
  EXPECT_EQ(add(EventKind::stick, Contact::closed, 0), MotionMode::slide);
  EXPECT_EQ(add(EventKind::opening, Contact::left, 0), MotionMode::slide_rock);
  EXPECT_EQ(add(EventKind::lift_off, Contact::apart, 0), MotionMode::free_flight);
  EXPECT_EQ(add(EventKind::fall, Contact::apart, 0), MotionMode::fall);
  EXPECT_EQ(onset_mode(scene, history), MotionMode::slide);
  history.events.clear();
  scene.initial.angles = {0.1};
  EXPECT_EQ(onset_mode(scene, history), MotionMode::rock);
  scene.initial.slip_velocities = {1};
  EXPECT_EQ(whole_mode(scene, history), MotionMode::slide_rock);
  scene.initial.gaps = {0.1};
  EXPECT_EQ(onset_mode(scene, history), MotionMode::free_flight);
}

// Every cell of a map has the mode of Shenton's diagram at its middle; none of them lies on a boundary.
TEST(MotionModes, AMapOverFrictionAndPushIsShentonsDiagram) {
  const TemporaryFolder folder;
  sweep_into(folder.path(), ensemble_from(R"(title = "map"
[scene]
duration = 0.01
law = "unilateral"
gravity = 10.0
[[scene.blocks]]
width = 1
height = 2
density = 2500
[scene.contact]
friction = 0.5
[scene.ground.horizontal]
pulse = "rectangle"
amplitude = 1
period = 1
[[vary]]
key = "contact.friction"
range = {from = 0.07, to = 1.17, count = 12}
[[vary]]
key = "ground.horizontal.amplitude"
range = {from = 1.3, to = 18.3, count = 12}
[summary]
intensity = "ground.horizontal.amplitude"
friction = "contact.friction"
)"));
  const std::vector<std::string> modes{"onset_rest", "onset_slide", "onset_rock", "onset_slide_rock"};
  const auto places = read_columns(folder.path() / "modes.csv", {"friction", "intensity"});
  const auto counts = read_columns(folder.path() / "modes.csv", modes);
  ASSERT_EQ(places[0].size(), 144u);
  std::array<int, 4> seen{};
  for (std::size_t i = 0; i < 144; ++i) {
    const double friction = places[0][i], push = places[1][i] / 10;
    const bool rests = push < friction && push < 0.5;
    const std::size_t expected = rests                                  ? 0
                                 : friction < 0.5                       ? 1
                                 : friction > rocking_friction(2, push) ? 2
                                                                        : 3;
    EXPECT_EQ(counts[expected][i], 1) << friction << ' ' << push;
    ++seen.at(expected);
  }
  for (const int count : seen) EXPECT_GT(count, 5);
}

}  // namespace
}  // namespace rockstack
