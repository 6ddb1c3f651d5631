#include <gtest/gtest.h>

#include "tests/analytic/solver/stacks.hpp"

namespace rockstack {
namespace {

using Precise = long double;

/// A rectangle of slenderness α and half-diagonal 1 m: p² = 3g/(4R).
Scene slab(double slenderness, double share, double duration) {
  return testing::released({testing::block(2 * std::sin(slenderness), 2 * std::cos(slenderness))},
                           {share * slenderness}, duration);
}

/// The time from rest at θ₀ to the ground, from conservation of energy,
///   θ̇² = 2p² (cos(α − θ₀) − cos(α − θ)) = 4p² sin(α − θ₀ + x/2) sin(x/2),   x = θ₀ − θ.
/// With x = θ₀u² the integrand is smooth; Simpson's rule with 4000 intervals is exact to long double
/// rounding.
Precise quarter_period(const Scene& scene) {
  const Block& block = scene.blocks[0];
  const Precise radius = std::hypot(Precise(block.half_width), Precise(block.half_height));
  const Precise inertia = Precise(block.inertia) + Precise(block.mass) * radius * radius;
  const Precise rate = std::sqrt(Precise(block.mass) * Precise(scene.gravity) * radius / inertia);
  const Precise slenderness = std::atan(Precise(block.half_width) / Precise(block.half_height));
  const Precise start = Precise(scene.initial.angles[0]);
  const auto integrand = [&](Precise u) {
    const Precise half = start * u * u / 2;
    const Precise ratio = half > 0 ? std::sin(half) / half : 1;
    return 2 * start / (2 * rate * std::sqrt(std::sin(slenderness - start + half) * ratio * start / 2));
  };
  const int intervals = 4000;
  Precise sum = integrand(0) + integrand(1);
  for (int i = 1; i < intervals; ++i) sum += (i % 2 == 1 ? 4 : 2) * integrand(Precise(i) / intervals);
  return sum / (3 * intervals);
}

Precise slender_quarter_period(const Scene& scene, double slenderness, double share) {
  return std::acosh(1 / (1 - Precise(share))) / std::sqrt(3 * Precise(scene.gravity) / 4) +
         0 * Precise(slenderness);
}

TEST(SingleBlock, TheFirstImpactComesAfterTheNonlinearQuarterPeriod) {
  for (const double slenderness : {0.05, 0.2, 0.6}) {
    for (const double share : {0.1, 0.5, 0.9}) {
      const Scene scene = slab(slenderness, share, 2);
      const History history = solve(scene);
      ASSERT_FALSE(history.events.empty());
      EXPECT_EQ(history.events[0].kind, EventKind::impact);
      EXPECT_NEAR(history.events[0].time / static_cast<double>(quarter_period(scene)), 1, 1e-10);
    }
  }
}

TEST(SingleBlock, HousnersQuarterPeriodIsTheSlenderLimitWithErrorSlendernessSquared) {
  double last = 0;
  for (const double slenderness : {0.2, 0.1, 0.05, 0.025}) {
    const Scene scene = slab(slenderness, 0.5, 2);
    const double expected = static_cast<double>(slender_quarter_period(scene, slenderness, 0.5));
    const double error = std::abs(solve(scene).events.at(0).time / expected - 1);
    // The next term of an even series is α² times smaller.
    if (last > 0) {
      EXPECT_NEAR(last / error, 4, 40 * slenderness * slenderness);
    }
    last = error;
  }
}

TEST(SingleBlock, EveryImpactKeepsOneShareOfTheVelocity) {
  for (const double slenderness : {0.05, 0.2, 0.6}) {
    const double sine = std::sin(slenderness);
    const double ratio = 1 - 1.5 * sine * sine;
    int impacts = 0;
    for (const Event& event : solve(slab(slenderness, 0.5, 5)).events) {
      if (event.kind != EventKind::impact) continue;
      ++impacts;
      EXPECT_NEAR(event.after[0] / event.before[0], ratio, 1e-14);
    }
    EXPECT_GT(impacts, 3);
  }
}

// θₙ/α = 1 − √(1 − rⁿ(1 − (1 − θ₀/α)²)), Housner 1963, for the slender block: its error is of order α² =
// 1e-4.
TEST(SingleBlock, PeaksFallAsHousnerSays) {
  const double slenderness = 0.01;
  Scene scene = slab(slenderness, 0.6, 6);
  scene.blocks[0].inertia *= 0.5;  // a velocity ratio away from 1
  const double radius_squared = 1;
  const double inertia = scene.blocks[0].inertia + scene.blocks[0].mass * radius_squared;
  const double ratio = 1 - scene.blocks[0].mass * radius_squared / inertia * (1 - std::cos(2 * slenderness));
  const History history = solve(scene, {.sample_times = regular_times(1e-3, 6)});
  std::vector<double> peaks{0};
  std::size_t event = 0;
  for (std::size_t i = 0; i < history.size(); ++i) {
    while (event < history.events.size() && history.events[event].time <= history.times[i]) {
      ++event;
      peaks.push_back(0);
    }
    peaks.back() = std::max(peaks.back(), std::abs(history.angles_at(i)[0]));
  }
  ASSERT_GT(peaks.size(), 3U);
  for (std::size_t n = 0; n + 1 < peaks.size(); ++n) {
    const double share = std::pow(ratio, 2 * static_cast<double>(n)) * (1 - 0.4 * 0.4);
    EXPECT_NEAR(peaks[n] / slenderness, 1 - std::sqrt(1 - share), 3e-4);
  }
}

TEST(SingleBlock, DecayEndsAtRestWithinTheStatedNumberOfImpacts) {
  for (const double slenderness : {0.1, 0.3, 0.7}) {
    const Scene scene = slab(slenderness, 0.7, 60);
    const History history = solve(scene);
    ASSERT_FALSE(history.events.empty());
    EXPECT_EQ(history.events.back().kind, EventKind::rest);
    EXPECT_TRUE(is_closed(history.events.back().to));
    const double sine = std::sin(slenderness);
    const double settling = 500 * std::numeric_limits<double>::epsilon() *
                            std::sqrt(scene.gravity / (2 * scene.blocks[0].half_height));
    const double bound =
        std::log(std::abs(history.events[0].before[0]) / settling) / -std::log(1 - 1.5 * sine * sine);
    EXPECT_LE(static_cast<double>(history.events.size()), bound + 1);
  }
}

// Fast enough to pass the toppling angle in the first step, from the upright or after an impact.
TEST(SingleBlock, TopplesAtTheTopplingAngleToEitherSide) {
  for (const double speed : {20.0, 50.0, 1000.0}) {
    for (const double start : {0.0, 0.1, -0.1}) {
      Scene scene = testing::released({testing::block(1, 2)}, {start}, 1);
      scene.initial.velocities = {speed};
      Scene mirrored = testing::released({testing::block(1, 2)}, {-start}, 1);
      mirrored.initial.velocities = {-speed};
      const History rightward = solve(scene);
      const History leftward = solve(mirrored);
      ASSERT_FALSE(rightward.events.empty() || leftward.events.empty()) << start << ' ' << speed;
      const Event& right = rightward.events.back();
      const Event& left = leftward.events.back();
      ASSERT_EQ(right.kind, EventKind::topple);
      ASSERT_EQ(left.kind, EventKind::topple);
      EXPECT_EQ(right.time, left.time) << start << ' ' << speed;
      EXPECT_EQ(right.angles[0], -left.angles[0]) << start << ' ' << speed;
      EXPECT_NEAR(right.angles[0], toppling_angle(scene, 0), 1e-14 * speed) << start << ' ' << speed;
    }
  }
}

TEST(SingleBlock, LinearEquationsFallWithConstantAcceleration) {
  Scene scene = slab(0.2, 0.5, 2);
  scene.equations = Equations::linear;
  const double acceleration =
      0.75 * scene.gravity * std::sin(0.2);  // m g w / I_O, Spanos et al. 2001, Eq. (25)
  EXPECT_NEAR(solve(scene).events.at(0).time, std::sqrt(2 * 0.1 / acceleration), 1e-12);
}

}  // namespace
}  // namespace rockstack
