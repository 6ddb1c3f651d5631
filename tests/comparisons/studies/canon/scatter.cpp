// What the canon makes of noise: the exact motion, or one by another law, with white noise on each sample.

#include <gtest/gtest.h>

#include <random>

#include "analytic/solve.hpp"
#include "comparisons/studies/canon/canon.hpp"
#include "comparisons/suites/shipped.hpp"

namespace rockstack {
namespace {

/// A motion whose angles are off by 1 mrad, and whose slips and gaps by 1 mm, each sample by itself, and all
/// so many times.
History noisy(History motion, std::uint32_t seed, double times = 1) {
  std::mt19937 generator(seed);
  std::normal_distribution<double> noise(0, 1e-3 * times);
  for (std::vector<double>* values : {&motion.angles, &motion.slips, &motion.gaps})
    for (double& value : *values) value += noise(generator);
  return motion;
}

/// The verdict on what `engine` makes of a scene at given times.
template <class Engine>
CanonAnswer judged(const NamedScene& scene, const Engine& engine) {
  std::vector<CanonErrors> errors;
  for (const double step : canon_steps) {
    const std::vector<double> times = regular_times(step, scene.scene.duration);
    const History exact = solve(scene.scene, {.sample_times = times});
    CanonErrors& at = errors.emplace_back(CanonErrors{step, {}});
    for (std::uint32_t seed = 0; seed < 5; ++seed)
      at.replicates.push_back(deviations(scene.scene, exact, engine(exact, times, seed)));
  }
  return judge_canon(scene.name, errors);
}

std::vector<NamedScene> scenes() {
  return read_suite(find_file("canon", "suites"), {}).scenes;
}

TEST(CanonScatter, WhiteNoiseOnTheExactMotionIsNoLawInAnyScene) {
  for (const NamedScene& scene : scenes()) {
    if (scene.name == "rest") continue;  // as the next one, for a minute
    const CanonAnswer answer = judged(
        scene, [](const History& exact, const auto&, std::uint32_t seed) { return noisy(exact, seed); });
    EXPECT_EQ(answer.verdict, "scatters") << scene.name << ": " << answer.reason;
    EXPECT_NEAR(answer.deviations.back().correlation, 0, 0.3) << scene.name;
  }
}

// Half of the friction: the slip on the slope is off by 61 mm in the end.
TEST(CanonScatter, AnotherLawIsSeenThroughNoiseUnlessThatIsLarger) {
  const NamedScene slope = part_named(scenes(), "slope");
  const auto with_noise_of = [&](double times) {
    return judged(slope, [&](const History&, const std::vector<double>& at, std::uint32_t seed) {
      Scene other = slope.scene;
      other.friction[0] /= 2;
      return noisy(solve(other, {.sample_times = at}), seed, times);
    });
  };
  EXPECT_EQ(with_noise_of(0).verdict, "another law");
  EXPECT_EQ(with_noise_of(1).verdict, "another law");
  const CanonAnswer hidden = with_noise_of(100);
  EXPECT_EQ(hidden.verdict, "scatters") << hidden.reason;
}

// A block that jumps to and fro at each step moves by a law of its own: that is no noise.
TEST(CanonScatter, WhatAlternatesIsNoScatter) {
  const NamedScene slope = part_named(scenes(), "slope");
  const CanonAnswer answer = judged(slope, [](History motion, const std::vector<double>& at, std::uint32_t) {
    for (std::size_t i = 0; i < at.size(); ++i) motion.gaps[i] += i % 2 == 0 ? 2e-3 : -2e-3;
    return motion;
  });
  EXPECT_EQ(answer.verdict, "another law") << answer.reason;
  EXPECT_LT(answer.deviations.back().correlation, -0.9);
}

}  // namespace
}  // namespace rockstack
