#include <gtest/gtest.h>

#include "tests/analytic/solver/stacks.hpp"
#include "tests/stride.hpp"

namespace rockstack {
namespace {

void negate(std::vector<double>& values) {
  for (double& value : values) value = -value;
}

Scene mirror_image(Scene scene) {
  negate(scene.initial.angles);
  negate(scene.initial.velocities);
  negate(scene.horizontal.samples);
  if (scene.horizontal.pulse) scene.horizontal.pulse->amplitude *= -1;
  return scene;
}

Pattern mirror_image(Pattern pattern) {
  for (int k = 0; k < pattern.size; ++k) pattern[k] = opposite(pattern[k]);
  return pattern;
}

void expect_mirrored(const History& one, History other) {
  ASSERT_EQ(one.events.size(), other.events.size());
  negate(other.angles);
  negate(other.velocities);
  EXPECT_EQ(one.angles, other.angles);
  EXPECT_EQ(one.velocities, other.velocities);
  for (std::size_t i = 0; i < one.events.size(); ++i) {
    const Event& event = one.events[i];
    Event& image = other.events[i];
    EXPECT_EQ(event.time, image.time);
    EXPECT_EQ(event.kind, image.kind);
    EXPECT_EQ(event.interface, image.interface);
    EXPECT_TRUE(event.to == mirror_image(image.to));
    negate(image.angles);
    negate(image.after);
    EXPECT_EQ(event.angles, image.angles);
    EXPECT_EQ(event.after, image.after);
  }
}

TEST(Mirror, AMirroredSceneHasTheMirroredHistoryBitForBit) {
  for (std::uint64_t seed = 0; seed < 1000; seed += testing::stride) {
    testing::Draw draw(3000 + seed);
    Scene scene = testing::random_scene(draw, 1 + draw.below(4), false);
    if (seed % 4 != 0) testing::shake(draw, scene);
    const SolveOptions options{.sample_times = regular_times(0.01, scene.duration)};
    expect_mirrored(solve(scene, options), solve(mirror_image(scene), options));
  }
}

TEST(Mirror, TheSameSceneGivesTheSameBits) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    testing::Draw draw(3500 + seed);
    const Scene scene = testing::random_scene(draw, 3, true);
    const SolveOptions options{.sample_times = regular_times(0.01, scene.duration)};
    const History one = solve(scene, options);
    const History other = solve(scene, options);
    EXPECT_EQ(one.angles, other.angles);
    EXPECT_EQ(testing::listing(one), testing::listing(other));
  }
}

}  // namespace
}  // namespace rockstack
