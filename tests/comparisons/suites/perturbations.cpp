#include "comparisons/suites/suite.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "analytic/solve.hpp"
#include "comparisons/measures/statistics/distributions.hpp"
#include "tests/free_rocking.hpp"
#include "tests/temporary_folder.hpp"

namespace rockstack {
namespace {

Scene two_blocks() {
  Scene scene = free_rocking(2);
  scene.horizontal = {0.01, {0, 1, -2, 1}, "made up", true, {}};
  scene.vertical.pulse = Pulse{.shape = PulseShape::sine, .amplitude = 0.5, .period = 0.3};
  return scene;
}

TEST(Perturbations, ChangeEveryLengthAngleAndMotionByNoMoreThanTheirSize) {
  Scene scene = two_blocks();
  scene.law = Law::unilateral;
  scene.initial.slip_velocities = {0.5, -0.5};
  const Perturbations around{.runs = 20, .size = 1e-3, .seed = 5};
  for (int run = 0; run < around.runs; ++run) {
    const Scene other = perturbed(scene, around, run);
    const auto expect_near = [&](double changed, double value) {
      EXPECT_NE(changed, value);
      EXPECT_LE(std::abs(changed / value - 1), around.size * (1 + 1e-9));
    };
    for (std::size_t k = 0; k < scene.blocks.size(); ++k) {
      expect_near(other.blocks[k].half_width, scene.blocks[k].half_width);
      expect_near(other.blocks[k].half_height, scene.blocks[k].half_height);
      EXPECT_EQ(other.blocks[k].mass, scene.blocks[k].mass);
    }
    expect_near(other.initial.angles[0], scene.initial.angles[0]);
    expect_near(other.initial.slip_velocities[1], scene.initial.slip_velocities[1]);
    EXPECT_EQ(other.initial.angles[0], other.initial.angles[1]);  // what is closed stays closed
    expect_near(other.horizontal.samples[2], scene.horizontal.samples[2]);
    expect_near(other.vertical.pulse->amplitude, scene.vertical.pulse->amplitude);
    EXPECT_NO_THROW(validate(other));
  }
}

TEST(Perturbations, AreTheSameEachTimeAndOthersForOtherRunsAndSeeds) {
  const Scene scene = two_blocks();
  const auto width = [&](std::uint64_t seed, int run) {
    return perturbed(scene, {.runs = 9, .seed = seed}, run).blocks[0].half_width;
  };
  EXPECT_EQ(width(1, 3), width(1, 3));
  EXPECT_NE(width(1, 3), width(1, 4));
  EXPECT_NE(width(1, 3), width(2, 3));
}

// The upper one of two blocks starts in flight: nothing of it stays zero, and the lower one stands.
TEST(Perturbations, ChangeWhatFliesByAmountsWhereAFactorLeavesZero) {
  Scene scene;
  scene.law = Law::unilateral;
  scene.duration = 1;
  scene.blocks = {make_block(1, 1, 2500), make_block(0.5, 2, 2500)};
  scene.initial = {{0, 0}, {0, 0}};
  scene.initial.gaps = {0, 0.3};
  const Perturbations around{.runs = 20, .size = 1e-3, .seed = 5};
  const double rate = std::sqrt(scene.gravity / 3);
  for (int run = 0; run < around.runs; ++run) {
    const Scene other = perturbed(scene, around, run);
    const InitialState& start = other.initial;
    for (const auto& [values, scale] : {std::pair{&start.angles, std::atan(0.25)},
                                        {&start.velocities, std::atan(0.25) * rate},
                                        {&start.slip_velocities, 2 * rate},
                                        {&start.gap_velocities, 2 * rate}}) {
      EXPECT_EQ(values->at(0), 0);
      EXPECT_NE(values->at(1), 0);
      EXPECT_LE(std::abs(values->at(1)), around.size * (1 + 3 * around.size) * scale);
    }
    EXPECT_EQ(start.gaps[0], 0);
    EXPECT_NE(start.gaps[1], 0.3);
    EXPECT_NO_THROW(validate(other));
  }
}

// Sampled finely, the exact motion observed like an engine's comes to the same.
TEST(MotionTallies, ReportedAndObservedAreTheSame) {
  Scene scene = two_blocks();
  scene.horizontal = scene.vertical = {};
  const MotionTally reported = exact_tally(scene);
  const MotionTally observed =
      observed_tally(scene, solve(scene, {.sample_times = regular_times(1e-4, scene.duration)}));
  EXPECT_EQ(reported.impacts, observed.impacts);
  EXPECT_EQ(reported.topples, observed.topples);
  for (std::size_t k = 0; k < 2; ++k) {
    // A peak is flat: 1e-4 s beside it the angle is lower by half its acceleration, some rad/s², times 1e-8
    // s².
    EXPECT_NEAR(reported.peaks[k], observed.peaks[k], 1e-7);
  }
}

TEST(MotionTallies, ReadBackAsTheyWere) {
  const TemporaryFolder folder;
  const auto file =
      folder.write("perturbed.csv", tallies_csv({{{0.1, 1.0 / 3}, 7, true}, {}, {{0, 0.2}, 0, false}}, 2));
  const auto read = read_tallies(file);
  ASSERT_EQ(read.size(), 3U);
  EXPECT_EQ(read[0].peaks, (std::vector<double>{0.1, 1.0 / 3}));
  EXPECT_EQ(read[0].impacts, 7);
  EXPECT_TRUE(read[0].topples);
  EXPECT_TRUE(read[1].failed());
  EXPECT_FALSE(read[2].failed() || read[2].topples);
}

TEST(Distributions, AreComparedQuantityByQuantity) {
  const std::vector<MotionTally> exact{{{0.1, 0.2}, 3, false}, {{0.2, 0.2}, 4, false}};
  const std::vector<MotionTally> other{{{0.1, 0.3}, 3, true}, {{0.2, 0.3}, 5, false}};
  const auto list = distances(exact, other);
  ASSERT_EQ(list.size(), 4U);
  EXPECT_EQ(list[0].apart.distance, 0);
  EXPECT_EQ(list[1].apart.distance, 1);
  EXPECT_EQ(list[2].apart.distance, 0.5);
  EXPECT_EQ(list[2].other_mean, 4);
  EXPECT_EQ(list[3].quantity, "toppled");
  EXPECT_EQ(list[3].apart.distance, 0.5);
}

}  // namespace
}  // namespace rockstack
