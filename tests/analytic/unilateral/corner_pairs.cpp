#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "tests/analytic/unilateral/equal_widths.hpp"
#include "tests/analytic/unilateral/scenes.hpp"
#include "tests/stride.hpp"

namespace rockstack {
namespace {

constexpr double half_width = 0.5;
constexpr double half_height = 1;
constexpr double leaning = 0.2;

/// A block that leans to a side by 0.2 rad on a base as wide as itself, 10⁶ times as heavy, which the ground
/// takes along to that side.
Scene leans(double friction, double along, int side, double duration = 1e-4) {
  const Block block = testing::block(2 * half_width, 2 * half_height);
  Block base = testing::block(2 * half_width, 0.2);
  base.mass *= 1e6;
  base.inertia *= 1e6;
  Scene scene =
      testing::with_friction(testing::released({base, block}, {0, side * leaning}, duration), friction);
  scene.friction[0] = 100;
  scene.horizontal = testing::pulse_of(PulseShape::rectangle, side * along, 2);
  return scene;
}

/// By how much the force on the block, where its corner sticks, leans from the normals of the lower and of
/// the upper face: with the pivot at the right, to the right, as tangents.
struct Ratios {
  double lower, upper;
};

// With x and y from the corner to the centre, and I_O = (4/3)(b² + h²) m, θ̈ = m(gx − Ay)/I_O,
// T = m(A + θ̈y), N = m(g − θ̈x).
Ratios ratios(double along) {
  const double x = -half_width * std::cos(leaning) + half_height * std::sin(leaning);
  const double y = half_height * std::cos(leaning) + half_width * std::sin(leaning);
  const double g = Scene{}.gravity;
  const double turn = (g * x - along * y) / (4.0 / 3 * (half_width * half_width + half_height * half_height));
  const double tangential = along + turn * y;
  const double normal = g - turn * x;
  return {tangential / normal, std::tan(std::atan(tangential / normal) - leaning)};
}

constexpr double near = 1e-4;  // the base gives way by 10⁻⁶, and forces change within the duration

/// Which way, seen from the side of the lean, the block slides at once: 1 outward, −1 inward, 0 where it
/// sticks.
int slides(const Scene& scene, int side, bool several) {
  const History history = solve_unilateral(scene);
  if (history.events.empty()) return 0;
  const Event& event = history.events.front();
  EXPECT_EQ(event.time, 0);
  EXPECT_EQ(event.kind, EventKind::slip);
  EXPECT_EQ(event.consistency, several ? Consistency::several : Consistency::consistent);
  return side * event.to.slides[1];
}

// A block that leans and stands still is about to slide outward: it does where the upper face would let it.
// Where the lower one would not, there are two motions.
TEST(UnilateralCornerPairs, OutwardSlipIsJudgedByTheUpperFace) {
  const Ratios ratio = ratios(0);
  ASSERT_LT(ratio.upper, ratio.lower);
  ASSERT_LT(ratio.lower, 0);
  for (const int side : {-1, 1}) {
    EXPECT_EQ(slides(leans(-ratio.upper * (1 + near), 0, side), side, false), 0);
    EXPECT_EQ(slides(leans(-ratio.upper * (1 - near), 0, side), side, true), 1);
    EXPECT_EQ(slides(leans(-ratio.lower * (1 + near), 0, side), side, true), 1);
    EXPECT_EQ(slides(leans(-ratio.lower * (1 - near), 0, side), side, false), 1);
  }
}

TEST(UnilateralCornerPairs, InwardSlipIsJudgedByTheLowerFace) {
  const double along = 20;
  const Ratios ratio = ratios(along);
  ASSERT_GT(ratio.upper, 0);
  for (const int side : {-1, 1}) {
    EXPECT_EQ(slides(leans(ratio.lower * (1 + near), along, side), side, false), 0);
    EXPECT_EQ(slides(leans(ratio.lower * (1 - near), along, side), side, true), -1);
    EXPECT_EQ(slides(leans(ratio.upper * (1 + near), along, side), side, true), -1);
    EXPECT_EQ(slides(leans(ratio.upper * (1 - near), along, side), side, false), -1);
  }
}

// A force between the normals, by more than friction from either: T > μN, and −T' > μN'.
TEST(UnilateralCornerPairs, WhereBothWaysAreOpenItSlidesInward) {
  const double along = 7;
  const Ratios ratio = ratios(along);
  ASSERT_GT(ratio.lower, 0.02);
  ASSERT_LT(ratio.upper, -0.02);
  for (const int side : {-1, 1}) EXPECT_EQ(slides(leans(0.02, along, side), side, true), -1);
}

TEST(UnilateralCornerPairs, FrictionThatAPairNeedsIsThatOfTheFaceThatNeedsMore) {
  for (const double along : {0.0, 20.0}) {
    const Ratios ratio = ratios(along);
    const History history = solve_unilateral(leans(10, along, 1, 1e-5), {.validity = true});
    EXPECT_NEAR(history.forces[1].friction, std::max(ratio.lower, -ratio.upper), near);
  }
}

// 200 of other widths and 250 by time steps, and more, by the program equal_width_scenes.
TEST(UnilateralCornerPairs, EqualWidthsAreTheLimitOfOthersWhereverTheseAgree) {
  // At 10⁻⁸ corners of flying blocks start beside faces on which they land within the same step.
  for (const double share : {1e-8, 1e-10}) {
    testing::LimitTally tally;
    for (std::uint64_t seed = 0; seed < 200; seed += testing::stride) EXPECT_EQ(tally.add(seed, share), "");
    EXPECT_GT(testing::stride * tally.agree, 150U);
    EXPECT_GT(testing::stride * tally.part, 10U);
  }
}

TEST(UnilateralCornerPairs, TimeStepsOfMoreauComeToTheSame) {
  testing::StepTally tally;
  for (std::uint64_t seed = 0; seed < 40; seed += testing::stride) tally.add(seed, 2e-4);
  EXPECT_EQ(tally.scenes[static_cast<std::size_t>(testing::Reason::unexplained)], 0U) << tally.summary();
  EXPECT_GT(testing::stride * tally.scenes[static_cast<std::size_t>(testing::Reason::agree)], 30U);
}

// Impulses are judged alike: the answer is that of blocks whose widths make the face that the slip goes along
// the one that is met.
TEST(UnilateralCornerPairs, AnImpactIsThatOfTheFaceThatItsSlipMeets) {
  int impacts = 0;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const Scene scene = testing::equal_widths(seed);
    if (scene.blocks.size() != 2) continue;
    for (const Event& event : solve_unilateral(scene).events) {
      if (event.consistency != Consistency::several) continue;
      if (event.kind != EventKind::impact || event.to.slides[1] == 0) break;
      ++impacts;
      const bool outward = event.to.slides[1] == sign(event.to[1]);
      const Scene other = testing::widened(scene, outward ? 1 : 0, 1e-12);
      bool met = false;
      for (const Event& like : solve_unilateral(other).events) {
        if (std::abs(like.time - event.time) > 1e-6 || like.kind != event.kind) continue;
        met = true;
        EXPECT_EQ(like.to, event.to) << seed;
        for (std::size_t k = 0; k < 2; ++k) EXPECT_NEAR(like.after[k], event.after[k], 1e-5);
      }
      EXPECT_TRUE(met) << seed;
      break;
    }
  }
  EXPECT_GT(impacts, 0);
}

// A corner passes the end of a face with some speed: not while a slip from a pair is young.
TEST(UnilateralCornerPairs, APairThatStartsToSlideDoesNotComeBackInTheSameInstant) {
  for (std::uint64_t seed = 0; seed < 200; seed += testing::stride) {
    std::vector<double> slipped(4, -1);  // of each interface, from 1
    for (const Event& event : solve_unilateral(testing::equal_widths(seed)).events) {
      double& time = slipped[static_cast<std::size_t>(event.interface)];
      if (event.kind == EventKind::corner) {
        EXPECT_GT(event.time - time, 1e-6) << seed;
      }
      if (event.kind == EventKind::slip) time = event.time;
    }
  }
}

}  // namespace
}  // namespace rockstack
