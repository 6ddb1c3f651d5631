#include "analytic/scene/wall.hpp"

#include <gtest/gtest.h>

#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>

#include "analytic/solve.hpp"
#include "tests/analytic/solver/stacks.hpp"

namespace rockstack {
namespace {

using testing::block;
using testing::Draw;
using testing::released;

constexpr double closed_form = 1e-10;

/// A block beside a wall on its left, released away from it.
Scene one_sided(double width, double height, double angle, double ratio, double duration) {
  Scene scene = released({block(width, height)}, {angle}, duration);
  scene.wall = {.side = -1, .restitution = ratio};
  return scene;
}

std::vector<Event> strikes_of(const Scene& scene) {
  return solve(scene).events;
}

/// m g R/I about a corner, 1/s².
double rate_squared(const Scene& scene) {
  const Block& own = scene.blocks[0];
  const double radius = std::hypot(own.half_width, own.half_height);
  return own.mass * scene.gravity * radius / (own.inertia + own.mass * radius * radius);
}

// θ̈ = −p² (α − θ): the quarter cycle takes arcosh(α/(α − θ₀))/p, and of 1 − (1 − θ/α)² a strike leaves r².
TEST(Wall, SmallAnglesHaveHousnersQuarterCyclesAndAmplitudes) {
  Scene scene = one_sided(0.5, 2.5, 0.1, 0.6, 4);
  scene.equations = Equations::small_angle;
  const double p = std::sqrt(rate_squared(scene)), slenderness = std::atan(0.2), ratio = 0.6;
  double share = 1 - std::pow(1 - 0.1 / slenderness, 2), time = 0;
  const auto quarter = [&] { return std::acosh(1 / std::sqrt(1 - share)) / p; };
  time = quarter();
  const std::vector<Event> events = strikes_of(scene);
  ASSERT_GT(events.size(), 6U);
  for (std::size_t n = 0; n < 6; ++n) {
    EXPECT_EQ(events[n].kind, EventKind::impact);
    EXPECT_NEAR(events[n].time, time, closed_form);
    EXPECT_NEAR(events[n].before[0], -p * slenderness * std::sqrt(share), closed_form);
    EXPECT_NEAR(events[n].after[0], ratio * p * slenderness * std::sqrt(share), closed_form);
    share *= ratio * ratio;
    time += 2 * quarter();
  }
}

// With upright geometry the weight has one lever, m g b: flights go with their speeds, and times to rest are
// a geometric sum, √(2θ₀/a) (1 + 2 r/(1 − r)).
TEST(Wall, AnUprightLeverComesToRestAfterAGeometricSum) {
  for (const double ratio : {0.0, 0.3, 0.7, 0.9}) {
    Scene scene = one_sided(0.5, 2.5, 0.05, ratio, 10);
    scene.equations = Equations::linear;
    const Block& own = scene.blocks[0];
    const double b = own.half_width, h = own.half_height;
    const double lever = own.mass * scene.gravity * b / (own.inertia + own.mass * (b * b + h * h));
    const std::vector<Event> events = strikes_of(scene);
    ASSERT_FALSE(events.empty());
    EXPECT_EQ(events.back().kind, ratio > 0 ? EventKind::rest : EventKind::impact);
    // It rests where it would lean by no more than a rounding, as much earlier (events/chatter.hpp).
    const double early = 2 * std::sqrt(2 * std::numeric_limits<double>::epsilon() / lever) / (1 - ratio);
    EXPECT_NEAR(events.back().time, std::sqrt(2 * 0.05 / lever) * (1 + 2 * ratio / (1 - ratio)),
                early + closed_form);
    EXPECT_NEAR(events[0].time, std::sqrt(2 * 0.05 / lever), closed_form);
  }
}

// In full: θ̇² = 2p² (cos(α − θ₀) − cos(α − θ)) for θ below θ₀, so that the quarter is an integral, elliptic;
// with θ = θ₀ (1 − u²) it has no singular end.
TEST(Wall, AQuarterCycleInFullIsItsIntegral) {
  const Scene scene = one_sided(0.5, 2.5, 0.15, 0.5, 3);
  const double slenderness = std::atan(0.2), square = rate_squared(scene);
  const auto quarter = [&](double top) {
    const auto slowness = [&](double u) {
      const double angle = top * (1 - u * u);
      const double half_sum = slenderness - (top + angle) / 2, half_difference = (top - angle) / 2;
      const double sine = half_difference > 0 ? std::sin(half_difference) / half_difference : 1;
      return std::sqrt(2 * top / (square * std::sin(half_sum) * sine));
    };
    return boost::math::quadrature::gauss_kronrod<double, 31>::integrate(slowness, 0.0, 1.0);
  };
  const std::vector<Event> events = strikes_of(scene);
  ASSERT_GT(events.size(), 2U);
  double top = 0.15, time = quarter(top);
  for (std::size_t n = 0; n < 3; ++n) {
    EXPECT_NEAR(events[n].time, time, closed_form);
    const double energy = 0.25 * (std::cos(slenderness - top) - std::cos(slenderness));
    top = slenderness - std::acos(std::cos(slenderness) + energy);
    time += 2 * quarter(top);
  }
}

// Sorrentino, AlShawa & Decanini 2011, of a uniform block.
TEST(Wall, TheRatioLeftOutIsThatOfThreeImpacts) {
  for (const double height : {0.5, 1.2, 2.5, 6.0}) {
    Scene scene = one_sided(1, height, 0, 0, 1);
    scene.wall.restitution.reset();
    const double sine = 1 / std::hypot(1, height), cosine = height * sine;
    const double expected = std::pow(1 - 1.5 * sine * sine, 2) * std::max(0.0, 1.5 * cosine * cosine - 1);
    EXPECT_NEAR(wall_restitution(scene), expected, 1e-14);
  }
}

/// Values between `samples`, `parts` for each interval.
std::vector<double> refined(const std::vector<double>& samples, int parts) {
  std::vector<double> finer;
  for (std::size_t i = 0; i + 1 < samples.size(); ++i)
    for (int part = 0; part < parts; ++part)
      finer.push_back(samples[i] + (samples[i + 1] - samples[i]) * part / parts);
  finer.push_back(samples.back());
  return finer;
}

// Where the ground falls faster than bodies do, and slows down along a line, the block opens as weight comes
// back: its acceleration starts with t, and two of each three orders of its series are zero.
TEST(Wall, OpensAsWeightComesBackOnARampHoweverOftenThatIsSampled) {
  for (const double height : {0.4, 0.7}) {
    Scene scene = one_sided(0.8, height, 0, 0, 0.3);
    scene.vertical = {.interval = 0.05, .samples = {0, -20, 20, 20}};
    const std::vector<Event> coarse = strikes_of(scene);
    scene.vertical = {.interval = 0.05 / 16, .samples = refined({0, -20, 20, 20}, 16)};
    const std::vector<Event> fine = strikes_of(scene);
    ASSERT_GE(coarse.size(), 2U);
    ASSERT_EQ(coarse.size(), fine.size());
    for (std::size_t i = 0; i < coarse.size(); ++i) {
      EXPECT_NEAR(coarse[i].time, fine[i].time, 1e-14) << height << ' ' << i;
      EXPECT_NEAR(coarse[i].before[0], fine[i].before[0], 1e-13) << height << ' ' << i;
    }
  }
}

TEST(Wall, TheOtherSideIsTheMirrorImage) {
  Scene left = one_sided(0.6, 2, 0, 0.4, 4), right = left;
  left.horizontal.pulse = Pulse{.shape = PulseShape::sine, .amplitude = 5, .period = 0.6, .cycles = 3};
  right.horizontal.pulse = Pulse{.shape = PulseShape::sine, .amplitude = -5, .period = 0.6, .cycles = 3};
  right.wall.side = 1;
  const std::vector<Event> expected = strikes_of(left), found = strikes_of(right);
  ASSERT_EQ(found.size(), expected.size());
  ASSERT_GT(found.size(), 4U);
  for (std::size_t n = 0; n < found.size(); ++n) {
    EXPECT_EQ(found[n].time, expected[n].time);
    EXPECT_EQ(found[n].after[0], -expected[n].after[0]);
  }
}

/// Angle and velocity at the end by classical Runge–Kutta steps of the block's own equation, I₀θ̈ = −m R (g
/// sin(α − θ) + ẍg cos(α − θ)), cut at the wall where a chord meets it. Nothing of it is shared with the
/// solver.
std::pair<double, double> stepped_at_wall(const Scene& scene, std::size_t steps) {
  const Block& own = scene.blocks[0];
  const double side = -scene.wall.side, slenderness = std::atan2(own.half_width, own.half_height);
  const double square = rate_squared(scene), length = scene.duration / static_cast<double>(steps);
  double angle = side * scene.initial.angles[0], rate = side * scene.initial.velocities[0];
  const auto pull = [&](double at, double time) {
    const double push = side * acceleration(scene.horizontal, time) / scene.gravity;
    return -square * (std::sin(slenderness - at) + push * std::cos(slenderness - at));
  };
  const auto step = [&](double time, double dt) {
    const double k1 = pull(angle, time), k2 = pull(angle + dt / 2 * rate, time + dt / 2);
    const double k3 = pull(angle + dt / 2 * (rate + dt / 2 * k1), time + dt / 2);
    const double k4 = pull(angle + dt * (rate + dt / 2 * k2), time + dt);
    angle += dt * rate + dt * dt / 6 * (k1 + k2 + k3);
    rate += dt / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
  };
  for (std::size_t n = 0; n < steps; ++n) {
    double time = static_cast<double>(n) * length, left = length;
    for (int strikes = 0; left > 0 && strikes < 50; ++strikes) {
      if (angle <= 0 && rate <= 0 && pull(0, time) <= 0) {  // it stands
        angle = rate = 0;
        break;
      }
      const double from = angle, speed = rate;
      step(time, left);
      if (angle >= 0) break;
      double low = 0, high = left;  // the strike, halved
      for (int i = 0; i < 60; ++i) {
        const double middle = (low + high) / 2;
        angle = from;
        rate = speed;
        step(time, middle);
        (angle < 0 ? high : low) = middle;
      }
      angle = 0;
      rate *= -*scene.wall.restitution;
      if (rate < 1e-9) rate = 0;
      time += high;
      left -= high;
    }
  }
  return {side * angle, side * rate};
}

TEST(Wall, RandomBlocksMoveAsRungeKuttaStepsSay) {
  int moving = 0;
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    Draw draw(seed + 94000);
    const double width = draw.between(0.3, 1), height = width * draw.between(2, 6);
    Scene scene = one_sided(width, height, draw.between(0, 0.4) * std::atan(width / height),
                            draw.between(0.1, 0.8), draw.between(0.5, 2));
    if (draw.coin()) {
      scene.wall.side = 1;
      scene.initial.angles[0] *= -1;
    }
    scene.horizontal.pulse = Pulse{.shape = PulseShape::sine,
                                   .amplitude = scene.gravity * width / height * draw.between(-2, 2),
                                   .period = draw.between(0.2, 1),
                                   .cycles = 2};
    const History history = solve(scene, {.end = true});
    if (!history.events.empty() && ends_motion(history.events.back().kind)) continue;
    const auto [angle, rate] = stepped_at_wall(scene, 4000);
    EXPECT_NEAR(history.angles.back(), angle, 2e-6) << seed;
    EXPECT_NEAR(history.velocities.back(), rate, 2e-5) << seed;
    EXPECT_GE(-scene.wall.side * history.angles.back(), 0) << seed;
    moving += history.angles.back() != 0;
  }
  EXPECT_GT(moving, 30);
}

TEST(Wall, EnergyNeverGrowsAndNothingLeansIntoTheWall) {
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    Draw draw(seed + 95000);
    const double width = draw.between(0.3, 2), height = draw.between(0.5, 4);
    Scene scene = one_sided(width, height, draw.between(0, 0.9) * std::atan(width / height), 0, 5);
    scene.wall.restitution.reset();
    scene.law = draw.coin() ? Law::paper : Law::consistent;
    for (const Event& event : strikes_of(scene)) {
      if (event.kind == EventKind::topple) break;
      EXPECT_LE(std::abs(event.after[0]), std::abs(event.before[0]));
      EXPECT_GE(event.after[0], 0);
    }
  }
}

}  // namespace
}  // namespace rockstack
