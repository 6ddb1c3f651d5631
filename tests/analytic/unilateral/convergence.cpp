#include <gtest/gtest.h>

#include <cmath>

#include "tests/analytic/unilateral/scenes.hpp"
#include "tests/analytic/unilateral/time_stepping.hpp"

namespace rockstack {
namespace {

/// Blocks that slide on a shaken ground which falls away under them for a while, and land.
testing::RubbingScene thrown(std::uint64_t seed) {
  testing::Draw draw(900 + seed);
  const int size = 1 + static_cast<int>(seed % 2);
  testing::RubbingScene result;
  std::vector<Block> blocks;
  blocks.reserve(2);
  for (int k = 0; k < size; ++k)
    blocks.push_back(testing::block(draw.between(0.5, 1), draw.between(0.5, 1.2)));
  Scene& scene = result.scene;
  scene = testing::released(std::move(blocks), std::vector<double>(static_cast<std::size_t>(size), 0), 0.45);
  const double g = scene.gravity;
  scene.horizontal =
      testing::pulse_of(PulseShape::sine, draw.between(0.5, 1) * g * (draw.coin() ? 1 : -1), 0.3, 0.01);
  scene.vertical = testing::pulse_of(PulseShape::half_sine, -draw.between(1.5, 2.5) * g, 0.12, 0.1);
  for (int k = 0; k < size; ++k) result.options.friction.push_back(draw.between(0.1, 0.5));
  return result;
}

double distance(const Bodies& one, const Bodies& other) {
  double largest = 0;
  for (std::size_t k = 0; k < one.at.size(); ++k) {
    largest = std::max({largest, std::abs(one.at[k].x - other.at[k].x), std::abs(one.at[k].y - other.at[k].y),
                        std::abs(one.at[k].angle - other.at[k].angle)});
  }
  return largest;
}

TEST(UnilateralConvergence, TimeStepsOfMoreauApproachItWithOrderOne) {
  double orders = 0;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const testing::RubbingScene drawn = thrown(seed);
    const Scene& scene = drawn.scene;
    const ContactOptions& options = drawn.options;
    const ContactHistory history = solve_unilateral(scene, options);
    bool slips = false;
    bool flies = false;
    for (const ContactEvent& event : history.events) {
      for (const Joint& joint : event.to) {
        slips |= joint.slip != 0;
        flies |= !joint.touches();
      }
    }
    EXPECT_TRUE(slips && flies) << seed;
    ASSERT_EQ(history.end_time, scene.duration) << seed;
    // Where within a step events fall makes errors vary from step to step: the largest of several.
    const auto error = [&](double step) {
      double largest = 0;
      for (const double share : {1.0, 0.8})
        largest =
            std::max(largest, distance(history.last, testing::time_stepped(scene, options, share * step)));
      return largest;
    };
    constexpr double step = 1e-3;
    const double coarse = error(step);
    const double fine = error(step / 8);
    orders += std::log2(coarse / fine) / 3 / 20;
    EXPECT_LT(fine, coarse / 2) << seed;
  }
  EXPECT_NEAR(orders, 1, 0.2);
}

}  // namespace
}  // namespace rockstack
