#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/analytic/solver/stacks.hpp"
#include "tests/stride.hpp"

namespace rockstack {
namespace {

using testing::Draw;

/// Per interface the mass above it, kg, and the critical tilt of what stands on it as one body.
struct RestingParts {
  std::vector<double> mass, critical_tilt;
};

RestingParts resting_parts(const Scene& scene) {
  const std::size_t size = scene.blocks.size();
  RestingParts result{std::vector<double>(size), std::vector<double>(size)};
  for (std::size_t k = 0; k < size; ++k) {
    double bottom = 0;  // of a block, above interface k
    double moment = 0;
    for (std::size_t j = k; j < size; ++j) {
      result.mass[k] += scene.blocks[j].mass;
      moment += scene.blocks[j].mass * (bottom + scene.blocks[j].half_height);
      bottom += 2 * scene.blocks[j].half_height;
    }
    const double half_width = interface_half_width(scene, static_cast<int>(k));
    result.critical_tilt[k] = result.mass[k] * half_width / moment;
  }
  return result;
}

struct Extremes {
  double least_gravity, largest_tilt;
};

/// Extremes of g + ÿ and |ẍ| / (g + ÿ); straight lines between samples have both at samples.
Extremes extremes(const Scene& scene) {
  Extremes result{1e9, 0};
  for (std::size_t i = 0; i < scene.horizontal.samples.size(); ++i) {
    const double effective_gravity = scene.gravity + scene.vertical.samples[i];
    result.least_gravity = std::min(result.least_gravity, effective_gravity);
    result.largest_tilt =
        std::max(result.largest_tilt, std::abs(scene.horizontal.samples[i]) / effective_gravity);
  }
  return result;
}

/// A stack at rest on ground that shakes it to `tilt` times the least critical tilt of any interface.
Scene shaken_to(Draw& draw, double tilt) {
  Scene scene = testing::random_stack(draw, 1 + draw.below(4));
  scene.duration = 1;
  scene.horizontal.interval = scene.vertical.interval = 0.01;
  for (int i = 0; i < 100; ++i) {
    scene.horizontal.samples.push_back(draw.between(-1, 1));
    scene.vertical.samples.push_back(draw.between(-5, 5));
  }
  const std::vector<double> critical_tilt = resting_parts(scene).critical_tilt;
  const double least = *std::min_element(critical_tilt.begin(), critical_tilt.end());
  const double factor = tilt * least / extremes(scene).largest_tilt;
  for (double& sample : scene.horizontal.samples) sample *= factor;
  return scene;
}

// West's condition on every interface: what stands above it stands while |ẍ| / (g + ÿ) is below its
// critical tilt.
TEST(Rest, EndsWhereTheGroundPassesTheLeastCriticalTilt) {
  Draw draw(51);
  for (int i = 0; i < 200; ++i) {
    EXPECT_TRUE(solve(shaken_to(draw, 1 - 1e-9)).events.empty()) << i;
    const History history = solve(shaken_to(draw, 1 + 1e-9));
    ASSERT_FALSE(history.events.empty()) << i;
    EXPECT_EQ(history.events[0].kind, EventKind::opening) << i;
  }
}

// Newton's second law for all above an interface: N = m (g + ÿ), T = m ẍ. Demands are kept to 1024 roundings
// of the stack's weight.
TEST(Rest, BearsItsWeightAndInertia) {
  Draw draw(52);
  for (int i = 0; i < 200; ++i) {
    const Scene scene = shaken_to(draw, draw.between(0.1, 0.9));
    const History history = solve(scene, {.validity = true});
    const RestingParts stands = resting_parts(scene);
    const auto [least_gravity, largest_tilt] = extremes(scene);
    const double rounding =
        1024 * std::numeric_limits<double>::epsilon() * stands.mass[0] * scene.gravity * (1 + largest_tilt);
    for (std::size_t k = 0; k < scene.blocks.size(); ++k) {
      const double normal = stands.mass[k] * least_gravity;
      EXPECT_NEAR(history.forces[k].least_normal, normal, rounding) << i;
      EXPECT_NEAR(history.forces[k].friction, largest_tilt, rounding / normal) << i;
    }
  }
}

// Samples make the solver look at every stretch of rest; what happens must not depend on whether it does.
// Events part by the roundings of steps of other lengths, amplified: less than 10⁶-fold in these half
// seconds.
TEST(Rest, LeadsToTheSameMotionWhetherLookedAtOrNot) {
  Draw draw(53);
  for (int i = 0; i < 100; i += testing::stride) {
    Scene scene = shaken_to(draw, draw.between(1.01, 1.5));
    scene.duration = 0.5;
    if (i % 2 > 0) scene.vertical = {};  // samples of one component are passed by themselves
    const History passed = solve(scene, {.validity = true});
    const History seen = solve(scene, {.sample_times = {0, scene.duration}, .validity = true});
    ASSERT_EQ(passed.events.size(), seen.events.size()) << i;
    for (std::size_t e = 0; e < passed.events.size(); ++e) {
      EXPECT_EQ(passed.events[e].to, seen.events[e].to) << i;
      EXPECT_NEAR(passed.events[e].time, seen.events[e].time, 1e-10) << i;
    }
    for (std::size_t k = 0; k < scene.blocks.size(); ++k) {
      EXPECT_NEAR(passed.forces[k].least_normal, seen.forces[k].least_normal,
                  1e-10 * resting_parts(scene).mass[k] * scene.gravity)
          << i;
    }
  }
}

}  // namespace
}  // namespace rockstack
