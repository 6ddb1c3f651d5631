#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/analytic/solver/stacks.hpp"

namespace rockstack {
namespace {

TEST(Peaks, EndWhereABlockTopples) {
  int toppled = 0;
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    testing::Draw draw(31000 + seed);
    const Scene scene = testing::random_scene(draw, 1 + draw.below(3), true);
    const History history = solve(scene, {.peaks = true});
    if (history.events.empty() || history.events.back().kind != EventKind::topple) continue;
    const auto block = static_cast<std::size_t>(history.events.back().interface - 1);
    EXPECT_NEAR(history.peaks[block], toppling_angle(scene, static_cast<int>(block)), 1e-13) << seed;
    ++toppled;
  }
  EXPECT_GT(toppled, 20);
}

// After a sample an angle goes no further than an interval at its fastest rate, for which twice the fastest
// of samples stands: the motion may end, by toppling, before the next.
TEST(Peaks, AreThoseOfSamplesAndOfWhatLiesBetween) {
  constexpr double interval = 1e-3;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    testing::Draw draw(32000 + seed);
    Scene scene = testing::random_scene(draw, 1 + draw.below(3), draw.coin());
    scene.duration = 1;
    const History history =
        solve(scene, {.sample_times = regular_times(interval, scene.duration), .peaks = true});
    const auto blocks = static_cast<std::size_t>(history.blocks);
    for (std::size_t k = 0; k < blocks; ++k) {
      double angle = 0;
      double rate = 0;
      for (std::size_t i = k; i < history.angles.size(); i += blocks) {
        angle = std::max(angle, std::abs(history.angles[i]));
        rate = std::max(rate, std::abs(history.velocities[i]));
      }
      EXPECT_GE(history.peaks[k], angle * (1 - 1e-15)) << seed;
      EXPECT_LE(history.peaks[k], angle + 2 * rate * interval + 1e-15) << seed;
    }
  }
}

}  // namespace
}  // namespace rockstack
