#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

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

// A block let go from rest at an angle never comes further: its far corner is (b + b) sin θ₀ above the ground
// then. Rounding of the sine and of the product: 4 units in the last place.
TEST(Peaks, ABlockLetGoHasItsUpliftAtTheStart) {
  for (const double angle : {0.15, -0.05, 0.01}) {
    const History history = solve(testing::released({testing::block(1, 4)}, {angle}, 3), {.peaks = true});
    const double expected = std::sin(std::abs(angle));
    EXPECT_NEAR(history.uplifts[0], expected, 4 * std::numeric_limits<double>::epsilon() * expected);
  }
}

// The corner of a wider block on a narrower one, which it pivots about, is b + w from the pivot.
TEST(Peaks, AWiderBlockRisesByItsCornerBesideTheFace) {
  Scene scene = testing::released({testing::block(1, 1), testing::block(3, 1)}, {0, 0.02}, 0.01);
  EXPECT_NEAR(solve(scene, {.peaks = true}).uplifts[1], (1.5 + 0.5) * std::sin(0.02), 1e-15);
}

// Relative angles at their largest: no sample is larger, and a dense one comes as near as its fastest rate
// lets it go within an interval, for which twice the fastest of samples and events stands.
TEST(Peaks, UpliftsAreThoseOfSamplesAndOfWhatLiesBetween) {
  constexpr double interval = 1e-3;
  int above_ground = 0;
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    testing::Draw draw(33000 + seed);
    Scene scene = testing::random_scene(draw, 2 + draw.below(3), draw.coin());
    scene.duration = 1;
    const History history =
        solve(scene, {.sample_times = regular_times(interval, scene.duration), .peaks = true});
    const auto blocks = static_cast<std::size_t>(history.blocks);
    for (std::size_t k = 0; k < blocks; ++k) {
      double angle = 0, rate = 0;
      const auto relative = [&](std::span<const double> row) {
        return std::abs(row[k] - (k > 0 ? row[k - 1] : 0));
      };
      for (std::size_t i = 0; i < history.size(); ++i) {
        angle = std::max(angle, relative(history.angles_at(i)));
        rate = std::max(rate, relative(history.velocities_at(i)));
      }
      for (const Event& event : history.events) {
        angle = std::max(angle, relative(event.angles));
        rate = std::max({rate, relative(event.before), relative(event.after)});
      }
      const double width = scene.blocks[k].half_width + interface_half_width(scene, static_cast<int>(k));
      const double rise = width * std::sin(std::min(angle, std::numbers::pi / 2));  // at most width
      EXPECT_GE(history.uplifts[k], rise * (1 - 1e-14)) << seed;
      EXPECT_LE(history.uplifts[k], rise + width * 2 * rate * interval + 1e-15) << seed;
      if (k > 0 && angle > 0) ++above_ground;
    }
  }
  EXPECT_GT(above_ground, 50);
}

}  // namespace
}  // namespace rockstack
