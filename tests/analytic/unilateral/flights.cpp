// Blocks that fly and bounce flat, with no force between them, against closed forms and a program of their
// own.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "analytic/solve.hpp"
#include "tests/analytic/unilateral/bouncing.hpp"

namespace rockstack {
namespace {

using testing::block;
using testing::bouncing;
using testing::gains;
using testing::released;

constexpr double exactly = 1e-10;
constexpr double height = 0.1;

Scene with_law(Scene scene, RestitutionLaw law) {
  scene.restitution_law = law;
  return scene;
}

/// A flat stack that starts above the ground, block on block.
Scene flat_drop(const std::vector<Block>& blocks, double restitution, double duration,
                double friction = 0.3) {
  Scene scene =
      bouncing(released(blocks, std::vector<double>(blocks.size(), 0), duration), restitution, friction);
  scene.initial.gaps.assign(blocks.size(), 0);
  scene.initial.gaps[0] = height;
  return scene;
}

const std::vector<Block> three{block(1.4, 0.5), block(1.1, 0.8), block(0.7, 0.3)};

TEST(Flights, BlocksThrownTogetherFlyAsOneWithNoForceBetweenThem) {
  for (const double along : {0.0, 0.2}) {
    Scene scene = flat_drop(three, 0.5, 1);
    scene.initial.gap_velocities = {2, 0, 0};
    scene.initial.slip_velocities = {0, along, 0};
    const double g = scene.gravity, landing = (2 + std::sqrt(4 + 2 * g * height)) / g;
    scene.duration = 0.9 * landing;
    const std::vector<double> times = regular_times(scene.duration / 7, scene.duration);
    const History history = solve_unilateral(scene, {.sample_times = times});
    EXPECT_TRUE(history.events.empty());
    for (const Sample& sample : samples_of(history)) {
      const double t = sample.time;
      EXPECT_NEAR(sample.gaps[0], height + 2 * t - g * t * t / 2, exactly);
      EXPECT_NEAR(sample.slips[1], along * t, exactly);
      EXPECT_NEAR(sample.slips[2], 0, exactly);
      for (std::size_t k = 0; k < three.size(); ++k)
        EXPECT_NEAR(sample.bodies.velocity[k].angle, 0, testing::round_off);
    }
    for (const Reaction& force : history.reactions) {
      EXPECT_NEAR(force.normal, 0, exactly);
      EXPECT_NEAR(force.tangential, 0, exactly);
    }
  }
}

// Falls of t₀, 2 e t₀, 2 e² t₀, …, as of one block, down to speeds of 500 ε √(g/H), with no event between.
TEST(Flights, AFlatStackBouncesAsOneBlockDoes) {
  for (const RestitutionLaw law : {RestitutionLaw::newton, RestitutionLaw::poisson}) {
    for (const double e : {0.3, 0.7, 0.95}) {
      Scene scene = with_law(flat_drop(three, e, 1), law);
      const double fall = std::sqrt(2 * height / scene.gravity), end = fall * (1 + e) / (1 - e);
      scene.duration = end + 0.1;
      const History history = solve_unilateral(scene);
      double time = fall;
      for (std::size_t n = 0; n < 8; ++n) {
        EXPECT_NEAR(history.events.at(n).time, time, exactly) << e;
        EXPECT_EQ(name(history.events[n].to), "-CC");
        time += 2 * std::pow(e, n + 1.0) * fall;
      }
      const Event& last = history.events.back();
      EXPECT_EQ(last.kind, EventKind::rest);
      EXPECT_NEAR(last.time, end, exactly) << e;
      EXPECT_LE(history.events.size(), 2 + std::log(1e-14) / std::log(e)) << e;
    }
  }
}

// The upper block slides until the landing takes its slip; then both fly for 2 e t₀ with nothing between.
TEST(Flights, ASlidingBlockThatTheLandingStopsStaysOnItsFaceInFlight) {
  const double e = 0.7;
  Scene scene = flat_drop({block(1, 0.5), block(0.8, 0.5)}, e, 2);
  scene.initial.slip_velocities = {0, -0.2};
  const double fall = std::sqrt(2 * height / scene.gravity);
  const History history = solve_unilateral(scene);
  ASSERT_GT(history.events.size(), 3U);
  EXPECT_NEAR(history.events[0].time, fall, exactly);
  EXPECT_EQ(name(history.events[0].from), "-C<");
  EXPECT_EQ(name(history.events[0].to), "-C");
  EXPECT_NEAR(history.events[1].time, fall * (1 + 2 * e), exactly);
  for (const Event& event : history.events) EXPECT_FALSE(gains(scene, event)) << event.time;
  EXPECT_EQ(history.events.back().kind, EventKind::rest);
  EXPECT_NEAR(history.events.back().time, fall * (1 + e) / (1 - e), exactly);
}

// Impacts of two that fly as one and of a third that comes down on them: what each keeps, in one dimension.
TEST(Flights, ThreeBlocksThatKeepAllOfTheirEnergyHaveFewImpacts) {
  Scene scene = flat_drop({block(1, 0.5), block(1, 2), block(1, 0.5)}, 1, 2, 0.7);
  scene.blocks[2].mass *= 20;
  scene.blocks[2].inertia *= 20;
  scene.restitution_law = RestitutionLaw::poisson;
  scene.initial.gaps = {0.1, 0, 0.3};
  scene.initial.gap_velocities = {-0.94, 0, 0.52};
  const History history = solve_unilateral(scene);
  EXPECT_LT(history.events.size(), 100U);
  const double start = energy(scene, bodies_before(history.events.at(0)));
  EXPECT_NEAR(energy(scene, bodies_at_end(history)), start, 1e-9 * start);
  for (const Event& event : history.events) EXPECT_EQ(name(event.to), "-C-");
}

/// Impacts until all is slow, and when it is, s.
struct Chatter {
  int impacts = 0;
  double time = 0;
};
/// Two bodies over the ground in one dimension, by gaps of their own, which so keep their digits: impacts,
/// each of one gap, until both are slower than `slow`, m/s.
Chatter chatter(double light, double heavy, double restitution, double gravity, std::array<double, 2> gaps,
                double slow) {
  Chatter result;
  std::array<double, 2> speeds{};  // of gaps
  const double share = heavy / (light + heavy);
  for (; result.impacts < 100000; ++result.impacts) {
    // The lower one falls, the upper one with it.
    const double root = std::sqrt(speeds[0] * speeds[0] + 2 * gravity * gaps[0]);
    const double ground = (speeds[0] + root) / gravity;
    const double meeting = speeds[1] < 0 ? -gaps[1] / speeds[1] : std::numeric_limits<double>::infinity();
    const double t = std::min(ground, meeting);
    result.time += t;
    gaps[0] += (speeds[0] - gravity * t / 2) * t;
    gaps[1] += speeds[1] * t;
    speeds[0] -= gravity * t;
    gaps[t == ground ? 0 : 1] = 0;
    const double change = (1 + restitution) * (t == ground ? speeds[0] : speeds[1]);
    if (t == ground) {
      speeds[0] -= change;
      speeds[1] += change;
    } else {
      speeds[1] -= change;
      speeds[0] += share * change;
    }
    if (std::abs(speeds[0]) < slow && std::abs(speeds[1]) < slow) break;
  }
  return result;
}

// A light block between the ground and a heavy one is struck by turns, ever faster, and stops it: gaps are
// below roundings of places long before speeds are.
TEST(Flights, ChatterOfTwoContactsEndsBySpeedNotByHeight) {
  Scene scene = flat_drop({block(1, 0.5), block(1, 0.5)}, 0.5, 1, 0);
  scene.blocks[1].mass *= 100;
  scene.blocks[1].inertia *= 100;
  scene.initial.gaps = {0.3, 0.1};
  const Chatter expected =
      chatter(scene.blocks[0].mass, scene.blocks[1].mass, 0.5, scene.gravity, {0.3, 0.1}, 1e-6);
  const History history = solve_unilateral(scene);
  const auto impacts = std::ranges::count(history.events, EventKind::impact, &Event::kind);
  EXPECT_GE(impacts, expected.impacts);
  EXPECT_EQ(history.events.back().kind, EventKind::rest);
  EXPECT_NEAR(history.events.back().time, expected.time, 1e-6);
  for (const Event& event : history.events) EXPECT_FALSE(gains(scene, event)) << event.time;
}

/// Velocities after all impacts of a landing on either corner in turn, tilted by so little that nothing moves
/// between them: the corner that is lower first, then whichever comes down.
Pose<> landed_in_turn(const Block& block, double angle, double speed, double e, double friction) {
  const std::array<testing::LowCorner, 2> corners{{{block, angle}, {block, -angle}}};
  Pose<> rate{0, -speed, 0};
  for (std::size_t impact = 0; corners[impact % 2].up(rate) < -exactly; ++impact) {
    const testing::LowCorner& corner = corners[impact % 2];
    rate = corner.after(rate, corner.newton(rate, e, friction));
  }
  return rate;
}

/// What a landing leaves of a block that falls by `height`, its impacts within a microsecond together.
Pose<> landed(const Scene& scene) {
  const History history = solve_unilateral(scene);
  const double end = history.events.at(0).time + 1e-6;
  const auto after = std::ranges::find_if(history.events, [&](const Event& event) {
    return event.time > end || event.kind != EventKind::impact;
  });
  return bodies_after(*std::prev(after)).velocity[0];
}

// Which of both a law means where a block lands flat is a choice: no number there tells laws apart.
TEST(Flights, ATiltOfABillionthMakesAFlatLandingAnotherMotion) {
  const double e = 0.8, tilt = 1e-9, close = 1e-5;  // what gravity gives in a microsecond, in m/s
  for (const Block& one : {block(1, 0.5), block(1, 0.4), block(0.8, 0.8)}) {
    for (const double friction : {0.2, 0.5, 1.0}) {
      Scene scene = flat_drop({one}, e, 0.25, friction);
      const double speed = std::sqrt(2 * scene.gravity * height);
      EXPECT_NEAR(landed(scene).y, e * speed, exactly);
      for (const double angle : {tilt, -tilt}) {
        scene.initial.angles = {angle};
        const Pose<> found = landed(scene), expected = landed_in_turn(one, angle, speed, e, friction);
        SCOPED_TRACE(::testing::Message() << one.half_height << ' ' << friction << ' ' << angle);
        EXPECT_NEAR(found.x, expected.x, close);
        EXPECT_NEAR(found.y, expected.y, close);
        EXPECT_NEAR(found.angle, expected.angle, close);
        EXPECT_GT(std::abs(found.angle), 0.1);
      }
    }
  }
  // Numbers of comparisons/findings.md.
  const Block low = block(1, 0.5);
  const Pose<> kept = landed_in_turn(low, tilt, 1, e, 0.5);
  EXPECT_NEAR(kept.y, 0.616, 5e-4);
  EXPECT_NEAR(testing::LowCorner(low, tilt).up(kept), 0.021, 5e-4);
  EXPECT_NEAR(testing::LowCorner(low, -tilt).up(kept), 1.211, 5e-4);
}

}  // namespace
}  // namespace rockstack
