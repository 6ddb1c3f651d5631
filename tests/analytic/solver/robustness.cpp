#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <span>

#include "analytic/solver/solver.hpp"
#include "tests/analytic/solver/stacks.hpp"
#include "tests/stride.hpp"

namespace rockstack {
namespace {

/// Contacts and angles agree: closed interfaces are exactly zero, open ones on their side. Relative angles
/// are differences of absolute ones here: a few roundings of angles below 2 rad.
void expect_sides(const History& history, std::uint64_t seed) {
  const double rounding = 1e-15;
  for (std::size_t i = 0; i < history.size(); ++i) {
    for (int k = 0; k < history.blocks; ++k) {
      const auto index = static_cast<std::size_t>(k);
      const auto between = [&](std::span<const double> row) {
        return row[index] - (k > 0 ? row[index - 1] : 0);
      };
      const double angle = between(history.angles_at(i));
      const Contact contact = history.patterns[i][k];
      ASSERT_TRUE(std::isfinite(angle)) << seed;
      if (contact == Contact::closed) {
        ASSERT_EQ(angle, 0) << seed;
        ASSERT_EQ(between(history.velocities_at(i)), 0) << seed;
      } else {
        ASSERT_GE(sign(contact) * angle, -rounding) << "seed " << seed << " at " << history.times[i];
      }
    }
  }
}

void expect_events(const Scene& scene, const History& history, std::uint64_t seed) {
  double time = 0;
  for (const Event& event : history.events) {
    ASSERT_GE(event.time, time) << seed;
    time = event.time;
    double below = 0;
    for (int k = 0; k < history.blocks; ++k) {
      const double velocity = event.after[static_cast<std::size_t>(k)];
      ASSERT_TRUE(std::isfinite(velocity)) << seed;
      if (event.to[k] == Contact::closed) {
        ASSERT_EQ(velocity, below) << seed;
      }
      below = velocity;
    }
    const double before = testing::energy_above_rest(scene, event.from, event.angles, event.before);
    const double after = testing::energy_above_rest(scene, event.to, event.angles, event.after);
    double weight = 0;
    for (const Block& block : scene.blocks) weight += block.mass * scene.gravity * block.half_height;
    ASSERT_LE(after, before + 1e-13 * (weight + std::abs(before))) << seed;  // rounding of both sums
  }
}

TEST(Robustness, TwoThousandRandomStacksMoveByTheRules) {
  for (std::uint64_t seed = 0; seed < 2000; seed += testing::stride) {
    testing::Draw draw(7000 + seed);
    const bool shaken = draw.coin();
    const Scene scene = testing::random_scene(draw, 1 + draw.below(4), shaken);
    History history;
    ASSERT_NO_THROW(history = solve(scene, {.sample_times = regular_times(0.005, scene.duration)})) << seed;
    expect_sides(history, seed);
    expect_events(scene, history, seed);
  }
}

// Two interfaces that chatter in the same instant push each other open with ever less speed, in ever less
// time: the clock stands still long before both are so slow that one of them would close. The draw is the
// first of 10,000 in which a solver that takes them one by one never ends.
TEST(Robustness, ChatterOfTwoInterfacesInOneInstantEnds) {
  testing::Draw draw(10134);
  const bool shaken = draw.coin();
  const Scene scene = testing::random_scene(draw, 1 + draw.below(4), shaken);
  EXPECT_NO_THROW(solve(scene));
}

TEST(Robustness, EqualBlocksReleasedByANanoRadianComeToRest) {
  for (const int size : {1, 2, 4}) {
    const auto count = static_cast<std::size_t>(size);
    Scene scene = testing::released(std::vector<Block>(count, testing::block(0.5, 1)),
                                    std::vector<double>(count, 1e-9), 0.5);
    for (const Law law : {Law::paper, Law::consistent}) {
      scene.law = law;
      const History history = solve(scene, {.sample_times = {0.5}});
      EXPECT_TRUE(is_closed(history.patterns.at(0))) << testing::listing(history);
    }
  }
}

TEST(Robustness, ABlockThatStartsTowardsTheGroundMovesOnWithWhatTheImpactLeaves) {
  Scene scene = testing::released({testing::block(0.5, 2)}, {1e-12}, 0.01);
  scene.initial.velocities = {-0.1};
  const Event event = solve(scene).events.at(0);
  EXPECT_EQ(event.kind, EventKind::impact);
  EXPECT_NEAR(event.time, 1e-11, 1e-20);
  EXPECT_EQ(event.to[0], Contact::left);
}

TEST(Robustness, AColumnOfEightDrumsIsFollowedUnderBothLaws) {
  Scene scene =
      testing::released(std::vector<Block>(8, testing::block(1, 0.8)), std::vector<double>(8, 0), 1.5);
  testing::Draw draw(71);
  scene.horizontal.interval = 0.02;
  for (int i = 0; i < 60; ++i) scene.horizontal.samples.push_back(draw.between(-6, 6));
  for (const Law law : {Law::paper, Law::consistent}) {
    scene.law = law;
    const History history = solve(scene, {.sample_times = regular_times(0.01, 1.5)});
    EXPECT_FALSE(history.events.empty());
    expect_sides(history, 71);
  }
}

TEST(Robustness, WhatLeavesTheRangeOfNumbersIsDiagnosed) {
  for (const double speed : {1e154, -1e200}) {
    Scene scene = testing::released({testing::block(1, 2)}, {0}, 1);
    scene.initial.velocities = {speed};
    EXPECT_THROW(Solver<double>(scene, {}).run(), std::runtime_error) << speed;
  }
}

// Numbers of any size that a scene may have: what is solved has none that is no number.
TEST(Robustness, NumbersOfAllSizesGiveNumbersOrADiagnosis) {
  testing::Draw draw(20);
  const auto any = [&] { return std::pow(10, draw.between(-20, 20)); };
  int solved = 0;
  for (int i = 0; i < 2000; i += testing::stride) {
    Scene scene = testing::released({}, {}, any());
    scene.gravity = any();
    for (int k = draw.below(3); k >= 0; --k) {
      scene.blocks.push_back(make_block(any(), any(), any()));
      scene.initial.angles.push_back(draw.coin() ? 0 : draw.between(-0.1, 0.1));
      scene.initial.velocities.push_back(draw.coin() ? 0 : any());
    }
    scene.horizontal = draw.coin() ? GroundMotion{any(), {any(), -any(), any()}, {}, {}} : GroundMotion{};
    scene.vertical = draw.coin() ? GroundMotion{any(), {any(), -any(), any()}, {}, {}} : GroundMotion{};
    try {
      const History history = solve(scene, {.sample_times = {0, scene.duration}, .peaks = true});
      ++solved;
      for (const auto* values : {&history.angles, &history.velocities, &history.peaks})
        for (const double value : *values) ASSERT_TRUE(std::isfinite(value)) << i;
    } catch (const FieldError&) {
    } catch (const IllConditioned&) {
    } catch (const Unfinished&) {
    }
  }
  EXPECT_GT(testing::stride * solved, 20);
}

// At no resolution to speak of, chatter has too many events to wait for.
TEST(Robustness, AMotionThatIsGivenUpIsKnownUpToThere) {
  Scene scene = testing::released({testing::block(0.1, 2)}, {1e-6}, 2);
  SolveOptions options{.sample_times = regular_times(1e-3, 2), .resolution = 1e-100};
  try {
    solve(scene, options);
    FAIL() << "not given up";
  } catch (const Unfinished& unfinished) {
    const History& known = unfinished.history;
    ASSERT_GT(known.size(), 1000U);
    scene.duration = known.times.back();
    options.sample_times.resize(known.size());
    const History whole = solve(scene, options);
    ASSERT_EQ(known.size(), whole.size());
    // Steps of other lengths round otherwise: angles of 1e-6 by 1e-22 each, thousands of times.
    for (std::size_t i = 0; i < known.size(); ++i) EXPECT_NEAR(known.angles[i], whole.angles[i], 1e-18) << i;
    EXPECT_GE(known.events.back().time, known.times.back());
  }
}

// Columns of 20 equal blocks have been seen to come to rest after 25,000 events in a thousandth of √(H/g).
TEST(Robustness, EventsThatMayComeTogetherGoWithTheNumberOfBlocks) {
  for (const int blocks : {1, 20}) {
    EventLimit<double> limit(blocks, 1);
    for (int i = 0; i < 10000 * blocks; ++i) limit.note_event(0, 0);
    EXPECT_THROW(limit.note_event(0, 0), std::runtime_error) << blocks;
  }
}

TEST(Robustness, NoMotionAsksForMemoryWithoutEnd) {
  EventLimit<double> limit(1, 1, 1);
  for (std::size_t kept = 0; kept < 500000; ++kept) limit.note_event(0, kept);
  EXPECT_THROW(limit.note_event(1, 500000), std::runtime_error);
}

TEST(Robustness, OptionsOutOfRangeAreRefused) {
  const Scene scene = testing::paper_example();
  const double none = std::numeric_limits<double>::quiet_NaN();
  const double infinite = std::numeric_limits<double>::infinity();
  for (const double wrong : {-1.0, none}) {
    EXPECT_THROW(solve(scene, {.resolution = wrong}), std::invalid_argument);
    EXPECT_THROW(solve(scene, {.tolerance = wrong}), std::invalid_argument);
    EXPECT_THROW(solve(scene, {.integrator = Integrator::rk4, .step = wrong}), std::invalid_argument);
    EXPECT_THROW(regular_times(wrong, 1), std::invalid_argument);
  }
  EXPECT_THROW(regular_times(0, 1), std::invalid_argument);
  EXPECT_THROW(solve(scene, {.integrator = Integrator::rk4, .step = 1e-300}), std::invalid_argument);
  for (const std::vector<double>& wrong :
       {std::vector{-1.0}, {0.0, none, 1.0}, {0.0, infinite}, {0.2, 0.1}}) {
    EXPECT_THROW(solve(scene, {.sample_times = wrong}), std::invalid_argument);
  }
}

}  // namespace
}  // namespace rockstack
