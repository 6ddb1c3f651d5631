#include "comparisons/studies/lessons/inside-a-solver/sweeps.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "analytic/solve.hpp"
#include "comparisons/suites/suite.hpp"

namespace rockstack {
namespace {

constexpr double sweep_rounding = 1e-13;  // of a few hundred sweeps, on impulses of some units

SweptStack swept(SweptStack stack, int sweeps, bool from_below) {
  begin_step(stack, 1, 0);
  for (int i = 0; i < sweeps; ++i) sweep(stack, from_below);
  return stack;
}

TEST(Sweeps, OneBlockIsSolvedByOneSweep) {
  SweptStack block = equal_blocks(1);
  block.masses = {7};
  const SweptStack after = swept(block, 1, true);
  EXPECT_DOUBLE_EQ(after.impulses[0], 7);
  EXPECT_EQ(after.velocities[0], 0);
  EXPECT_EQ(sweeps_until(block, 1e-12), 1);
}

// From below each contact halves what its lower block still has to fall; from above nothing approaches yet.
TEST(Sweeps, TheFirstSweepKnowsOnlyOneBlock) {
  const SweptStack up = swept(equal_blocks(5), 1, true), down = swept(equal_blocks(5), 1, false);
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_DOUBLE_EQ(up.impulses[i], std::pow(0.5, i));
    EXPECT_EQ(down.impulses[i], i == 0 ? 1 : 0);
  }
}

TEST(Sweeps, ImpulsesComeToTheWeightAboveThem) {
  for (const bool from_below : {true, false}) {
    SweptStack stack = equal_blocks(4);
    stack.masses = {1, 3, 0.5, 2};
    const std::vector<double> exact = carrying_impulses(stack, 1);
    const SweptStack after = swept(stack, 1000, from_below);
    for (std::size_t i = 0; i < 4; ++i) {
      EXPECT_NEAR(exact[i],
                  std::accumulate(stack.masses.begin() + static_cast<long>(i), stack.masses.end(), 0.0),
                  sweep_rounding);
      EXPECT_NEAR(after.impulses[i], exact[i], sweep_rounding);
      EXPECT_NEAR(after.velocities[i], 0, sweep_rounding);
    }
  }
}

TEST(Sweeps, EachLeavesTheShareOfTheClosedForm) {
  for (const std::size_t blocks : {2U, 3U, 5U, 10U})
    for (const bool from_below : {true, false}) {
      const auto lacks = [&](int sweeps) {
        return static_cast<double>(blocks) - swept(equal_blocks(blocks), sweeps, from_below).impulses[0];
      };
      EXPECT_NEAR(lacks(41) / lacks(40), left_by_sweep(blocks), 1e-3) << blocks;
    }
  EXPECT_NEAR(left_by_sweep(1), 0, sweep_rounding);
  EXPECT_DOUBLE_EQ(left_by_sweep(2), 0.5);
}

// A steady speed u is what sweeps leave of u and of the share 1 − w of a step's gravity that is not carried
// from the start: it is in proportion to that share.
TEST(Sweeps, AStackSinksInProportionToWhatIsNotKept) {
  const auto speed = [](double kept) {
    const auto sunk = [&](double time) { return sinking(equal_blocks(5), 5, kept, 0.01, time, 9.81); };
    return (sunk(4) - sunk(3.99)) / 0.01;
  };
  EXPECT_GT(speed(0), 0.1);
  EXPECT_NEAR(speed(0.85), 0.15 * speed(0), 1e-9);
  EXPECT_NEAR(speed(1), 0, 1e-9);
}

TEST(Sweeps, TheLessonsStackBearsWhatTheExactSolverSays) {
  const Suite suite = read_suite(std::filesystem::path(ROCKSTACK_LESSONS) / "inside-a-solver/suite.toml", {});
  const Scene& scene = suite.scenes.front().scene;
  SweptStack stack = equal_blocks(scene.blocks.size());
  for (std::size_t i = 0; i < scene.blocks.size(); ++i) stack.masses[i] = scene.blocks[i].mass;
  const History history = solve(scene, {.sample_times = {0, scene.duration}});
  const std::vector<double> weights = carrying_impulses(stack, scene.gravity);
  for (std::size_t i = 0; i < history.reactions.size(); ++i)
    EXPECT_NEAR(history.reactions[i].normal, weights[i % weights.size()], 1e-9 * weights[0]);
}

}  // namespace
}  // namespace rockstack
