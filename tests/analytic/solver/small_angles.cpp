#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "analytic/mechanics/pattern_solution.hpp"
#include "tests/analytic/solver/stacks.hpp"

namespace rockstack {
namespace {

/// The block 0.4 × 1.2 m of Makris & Roussos 2000, at rest.
Scene small_block(double duration) {
  Scene scene = testing::released({testing::block(0.4, 1.2)}, {0}, duration);
  scene.equations = Equations::small_angle;
  return scene;
}

struct Housner {
  double slenderness, rate;  // α, p = √(mgR/I₀)
};

Housner housner(const Scene& scene) {
  const Block& block = scene.blocks[0];
  const double radius = std::hypot(block.half_width, block.half_height);
  const double inertia = block.inertia + block.mass * radius * radius;
  return {std::atan(block.half_width / block.half_height),
          std::sqrt(block.mass * scene.gravity * radius / inertia)};
}

Pulse pulse_of(PulseShape shape, double amplitude, double period) {
  Pulse pulse;
  pulse.shape = shape;
  pulse.amplitude = amplitude;
  pulse.period = period;
  return pulse;
}

/// The least amplitude, in g, from which on the block topples without an impact.
double threshold(PulseShape shape, double period, double low, double high) {
  Scene scene = small_block(8);
  scene.restitution = {0.5};
  while (high - low > 1e-9) {
    const double middle = 0.5 * (low + high);
    scene.horizontal.pulse = pulse_of(shape, middle * scene.gravity, period);
    const History history = solve(scene);
    (history.events.back().kind == EventKind::topple ? high : low) = middle;
  }
  return high;
}

// Housner 1963, Eq. (5): a quarter of the period is acosh(1/(1 − θ₀/α))/p. Nothing is lost at impacts here.
TEST(SmallAngles, AFreeBlockRocksWithHousnersPeriod) {
  for (const double share : {0.1, 0.5, 0.99}) {
    Scene scene = small_block(8);
    const auto [slenderness, rate] = housner(scene);
    scene.initial.angles = {share * slenderness};
    scene.restitution = {1};
    const double quarter = std::acosh(1 / (1 - share)) / rate;
    const History history = solve(scene);
    ASSERT_GE(history.events.size(), 3U);
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_EQ(history.events[i].kind, EventKind::impact);
      EXPECT_NEAR(history.events[i].time, static_cast<double>(2 * i + 1) * quarter, 1e-10);
    }
  }
}

// Housner 1963, Eq. (8): an impact leaves r of the kinetic energy, and of 1 − (1 − θ/α)². Here √r is that of
// the law, 1 − (3/2) sin²α.
TEST(SmallAngles, SwingsDecayAsHousnerHasIt) {
  Scene scene = small_block(3);
  const auto [slenderness, rate] = housner(scene);
  scene.initial.angles = {0.6 * slenderness};
  const History history = solve(scene);
  const double kept = 1 - 1.5 * std::sin(slenderness) * std::sin(slenderness);
  double swing = 0.6;
  double time = std::acosh(1 / (1 - swing)) / rate;
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(history.events.at(i).time, time, 1e-10);
    EXPECT_NEAR(history.events[i].after[0] / history.events[i].before[0], kept, 1e-12);
    swing = 1 - std::sqrt(1 - kept * kept * (1 - (1 - swing) * (1 - swing)));
    time += 2 * std::acosh(1 / (1 - swing)) / rate;
  }
}

TEST(SmallAngles, ABlockRestsUpToItsSlendernessTimesGravity) {
  Scene scene = small_block(2);
  scene.horizontal = {2, {0, 5}};
  const auto [slenderness, rate] = housner(scene);
  const History history = solve(scene);
  ASSERT_EQ(history.events.front().kind, EventKind::opening);
  EXPECT_NEAR(history.events.front().time, slenderness * scene.gravity / 2.5, 1e-12);
}

/// The amplitude at which the growing part of θ vanishes, which decides without an impact: with t₀ the
/// opening and t₁ the end of a sine of angular frequency ω, ∫ exp(−p(t − t₀)) (a sin ωt/g) dt from t₀ to t₁
/// is α/p. In g.
double growing_part_vanishes(const Housner& block, double frequency, double end) {
  const double rate = block.rate;
  const auto excess = [&](double a) {
    const double start = std::asin(block.slenderness / a) / frequency;
    const auto integral = [&](double t) {
      return -std::exp(-rate * (t - start)) *
             (rate * std::sin(frequency * t) + frequency * std::cos(frequency * t)) /
             (rate * rate + frequency * frequency);
    };
    return a * (integral(end) - integral(start)) - block.slenderness / rate;
  };
  double low = block.slenderness;
  double high = 100;
  while (high - low > 1e-13) (excess((low + high) / 2) > 0 ? high : low) = (low + high) / 2;
  return high;
}

// For a half sine of 0.5 s under this block 0.5535 to 0.5545 g are printed in the literature. The linear
// equations have 0.554586 g, by quadrature and by the solver: a last digit above what is printed.
TEST(SmallAngles, AHalfSineTopplesAtTheThresholdOfTheLinearEquations) {
  const double expected = growing_part_vanishes(housner(small_block(1)), 2 * std::numbers::pi, 0.5);
  EXPECT_NEAR(expected, 0.554586, 5e-7);
  EXPECT_NEAR(threshold(PulseShape::half_sine, 1, 0.4, 0.7), expected, 1e-7);
}

TEST(SmallAngles, AWholeSineTopplesWithoutImpactAtTheThresholdOfTheLinearEquations) {
  const double frequency = 15.7;
  const double period = 2 * std::numbers::pi / frequency;
  const double expected = growing_part_vanishes(housner(small_block(1)), frequency, period);
  EXPECT_NEAR(threshold(PulseShape::sine, period, expected - 0.05, expected + 0.05), expected, 1e-7);
}

// For Zhang & Makris' block, p = 2.14 rad/s and α = 0.25, the same quadrature gives 3.230 g at ω_p = 15.7
// rad/s, and 3.218 to 3.242 g for what p may stand for, 2.135 to 2.145. The 3.24 g that is printed lies
// within that, at its upper end; the data do not determine a third digit.
TEST(SmallAngles, ThePrintedThresholdOfZhangAndMakrisLiesWithinItsData) {
  const auto at = [](double rate) {
    return growing_part_vanishes({0.25, rate}, 15.7, 2 * std::numbers::pi / 15.7);
  };
  EXPECT_NEAR(at(2.14), 3.2301, 1e-4);
  EXPECT_GT(at(2.135), 3.24);
  EXPECT_LT(at(2.145), 3.22);
}

// What is left out is of second order in slenderness and angles: of an acceleration, halving both leaves a
// quarter.
TEST(SmallAngles, StacksApproachTheFullEquationsWithTheSquareOfTheirSlenderness) {
  for (const Contact lower : {Contact::left, Contact::closed, Contact::right}) {
    for (const Contact upper : {Contact::left, Contact::right}) {
      std::vector<double> errors;
      for (const double slender : {0.02, 0.01}) {
        Scene scene = testing::released(
            {testing::block(2.2 * slender, 2), testing::block(1.8 * slender, 1.5)}, {0, 0}, 1);
        State<double> state{{}, Vector<double>(2), Vector<double>(2)};
        state.pattern.size = 2;
        state.pattern[0] = lower;
        state.pattern[1] = upper;
        state.angles << 0.3 * slender * sign(lower), 0.2 * slender * sign(upper);
        state.velocities << 0.5 * slender * sign(lower), -0.4 * slender;
        const Point<double> ground{0.7 * slender * 9.81, 0.1 * 9.81};
        const auto full = accelerate(make_model<double>(scene), state, ground);
        scene.equations = Equations::small_angle;
        const auto small = accelerate(make_model<double>(scene), state, ground);
        errors.push_back((small.relative - full.relative).norm() / full.relative.norm());
        // Forces along the faces are of first order themselves.
        errors.back() += (small.reactions.tangential - full.reactions.tangential).norm() /
                         full.reactions.tangential.norm();
        EXPECT_LT(errors.back(), 20 * slender * slender);
      }
      EXPECT_NEAR(errors[0] / errors[1], 4, 0.2) << sign(lower) << ' ' << sign(upper);
    }
  }
}

/// A stack of two that rocks in several patterns.
Scene small_stack() {
  Scene scene = testing::released({testing::block(0.8, 3), testing::block(0.6, 2)}, {0.05, 0.09}, 2.5);
  scene.equations = Equations::small_angle;
  return scene;
}

TEST(SmallAngles, FreeMotionKeepsItsEnergyBetweenEvents) {
  const Scene scene = small_stack();
  const auto model = make_model<double>(scene);
  const History history = solve(scene);
  ASSERT_GE(history.events.size(), 4U);
  const auto energy_of = [&](const Pattern& pattern, const Event& event,
                             const std::vector<double>& velocities) {
    const auto vector = [](const std::vector<double>& values) -> Vector<double> {
      return Vector<double>::Map(values.data(), static_cast<Eigen::Index>(values.size()));
    };
    return energy(model,
                  State<double>{pattern, relative(vector(event.angles)), relative(vector(velocities))});
  };
  const double scale = model.stack.mass.sum() * scene.gravity * 0.05;
  for (std::size_t i = 0; i + 1 < history.events.size(); ++i) {
    const Event &one = history.events[i], &next = history.events[i + 1];
    if (next.kind != EventKind::impact && next.kind != EventKind::opening) break;
    EXPECT_NEAR(energy_of(one.to, one, one.after), energy_of(next.from, next, next.before), 1e-10 * scale);
  }
}

// The series and the general rule share no line of the equations of motion.
TEST(SmallAngles, SeriesAgreeWithRungeAndKutta) {
  Scene scene = small_stack();
  scene.duration = 1.5;
  scene.horizontal.pulse = pulse_of(PulseShape::cosine, 1.5, 0.9);
  scene.vertical.pulse = pulse_of(PulseShape::sine, 2, 0.7);
  SolveOptions options{.sample_times = regular_times(0.05, scene.duration), .validity = true};
  const History series = solve(scene, options);
  options.integrator = Integrator::rk4;
  const History steps = solve(scene, options);
  ASSERT_EQ(series.events.size(), steps.events.size());
  for (std::size_t i = 0; i < series.angles.size(); ++i) EXPECT_NEAR(series.angles[i], steps.angles[i], 1e-9);
  for (std::size_t k = 0; k < 2; ++k) {
    // Runge and Kutta's demands are those at the starts of steps.
    EXPECT_NEAR(series.forces[k].least_normal / steps.forces[k].least_normal, 1, 1e-3);
    EXPECT_NEAR(series.forces[k].friction / steps.forces[k].friction, 1, 1e-2);
  }
}

}  // namespace
}  // namespace rockstack
