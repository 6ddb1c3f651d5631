#include "comparisons/measures/metrics/ground.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "analytic/scene/ground/records/record_file.hpp"
#include "analytic/scene/ground/synthetic.hpp"

namespace rockstack {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double rounding = std::numeric_limits<double>::epsilon();

GroundMotion motion_of(std::vector<double> samples, double interval) {
  return {interval, std::move(samples), "a test"};
}

/// Two periods of A sin(2πt/T) with A = 3 m/s², T = 1 s.
GroundMotion sine_record(int samples_in_period) {
  std::vector<double> samples;
  for (int k = 0; k <= 2 * samples_in_period; ++k)
    samples.push_back(3 * std::sin(2 * pi * k / samples_in_period));
  return motion_of(samples, 1.0 / samples_in_period);
}

TEST(GroundMeasures, OfAConstantAcceleration) {
  // a = 2 for 4 s: v = 8, d = 16, ∫a² = 16, which grows evenly. All are powers of two and exact.
  const GroundMeasures measures = measure_ground(motion_of({2, 2, 2, 2, 2}, 1));
  EXPECT_EQ(measures.points, 5U);
  EXPECT_EQ(measures.duration, 4);
  EXPECT_EQ(measures.acceleration.value, 2);
  EXPECT_EQ(measures.acceleration.time, 0);
  EXPECT_EQ(measures.velocity.value, 8);
  EXPECT_EQ(measures.velocity.time, 4);
  EXPECT_EQ(measures.displacement.value, 16);
  EXPECT_EQ(measures.final_velocity, 8);
  EXPECT_EQ(measures.final_displacement, 16);
  EXPECT_DOUBLE_EQ(measures.arias_intensity, pi / (2 * 9.80665) * 16);
  EXPECT_NEAR(measures.significant_5_95.begin, 0.2, 4 * rounding);
  EXPECT_NEAR(measures.significant_5_95.end, 3.8, 4 * rounding);
  EXPECT_NEAR(measures.significant_5_75.length(), 2.8, 8 * rounding);
}

TEST(GroundMeasures, OfElCentroAreThosePublished) {
  // A. K. Chopra, Dynamics of Structures, Sections 6.1 and 6.4: the peak to three digits, the duration, and
  // the largest deformations of oscillators with 2 % of critical damping to the hundredth of an inch.
  const Record record = read_record(ROCKSTACK_SUITES "/../scenes/records/el-centro-1940.csv");
  EXPECT_EQ(record.samples.size(), 1559U);
  const GroundMotion motion = motion_of(record.samples, record.interval);
  const GroundMeasures measures = measure_ground(motion);
  EXPECT_NEAR(std::abs(measures.acceleration.value), 0.319 * standard_gravity, 0.0005 * standard_gravity);
  EXPECT_NEAR(measures.acceleration.time, 2.02, 1e-12);
  EXPECT_NEAR(measures.duration, 31.16, 1e-12);
  constexpr double inch = 0.0254, published_interval = 0.02;
  struct Published {
    double period, deformation;
  };
  for (const auto& [period, deformation] : {Published{0.5, 2.67}, Published{1, 5.97}, Published{2, 7.47}}) {
    const double frequency = 2 * pi / period;
    const double computed = response(motion, period, 0.02).pseudo_acceleration / (frequency * frequency);
    // Half a step beside a peak a harmonic has fallen by 1 − cos; response() itself is within 0.2 %.
    const double between = 1 - std::cos(frequency * published_interval / 2);
    EXPECT_NEAR(computed / inch, deformation, 0.005 + (between + 0.002) * deformation) << period;
  }
}

TEST(GroundMeasures, OfARamp) {
  // a = −3t for 2 s: v = −6, d = −4, ∫a² = 24, of which (t/2)³ is reached at t. Few samples or many.
  for (const int pieces : {1, 2, 8}) {
    std::vector<double> samples;
    for (int k = 0; k <= pieces; ++k) samples.push_back(-6.0 * k / pieces);
    const GroundMeasures measures = measure_ground(motion_of(samples, 2.0 / pieces));
    EXPECT_EQ(measures.acceleration.value, -6);
    EXPECT_DOUBLE_EQ(measures.velocity.value, -6);
    EXPECT_DOUBLE_EQ(measures.displacement.value, -4);
    EXPECT_DOUBLE_EQ(measures.arias_intensity, pi / (2 * standard_gravity) * 24);
    // The cube root spreads the roundings of the sums by no more than 2/(3 · 0.05^(2/3)) < 5.
    EXPECT_NEAR(measures.significant_5_95.begin, 2 * std::cbrt(0.05), 40 * rounding);
    EXPECT_NEAR(measures.significant_5_95.end, 2 * std::cbrt(0.95), 40 * rounding);
  }
}

TEST(GroundMeasures, PeaksBetweenSamplesAreFound) {
  // a = 1 − t from 0 to 3 in one piece: v = t − t²/2 is largest, 1/2, at t = 1 but −3/2 at the end; d = t²/2
  // − t³/6 is largest, 2/3, at t = 2, where v = 0.
  const GroundMeasures measures = measure_ground(motion_of({1, -2}, 3));
  EXPECT_NEAR(measures.velocity.value, -1.5, 4 * rounding);
  EXPECT_EQ(measures.velocity.time, 3);
  EXPECT_NEAR(measures.displacement.value, 2.0 / 3, 4 * rounding);
  EXPECT_NEAR(measures.displacement.time, 2, 8 * rounding);
  const GroundMeasures shorter = measure_ground(motion_of({1, -0.5}, 1.5));
  EXPECT_NEAR(shorter.velocity.value, 0.5, 4 * rounding);
  EXPECT_NEAR(shorter.velocity.time, 1, 8 * rounding);
}

TEST(GroundMeasures, OfASine) {
  // v = AT/2π (1 − cos 2πt/T), at most AT/π; d grows by AT²/2π a period; ∫a² = A² · 2T/2. The chord of a sine
  // lies below it by at most (2π/T h)²/8 of A, here 1.2e-5, and takes the same share from the integrals,
  // twice that from the one of the square.
  const int samples_in_period = 640;
  const double chord = std::pow(2 * pi / samples_in_period, 2) / 8;
  const GroundMeasures measures = measure_ground(sine_record(samples_in_period));
  EXPECT_DOUBLE_EQ(measures.acceleration.value, 3);
  EXPECT_DOUBLE_EQ(measures.acceleration.time, 0.25);
  EXPECT_NEAR(measures.velocity.value, 3 / pi, chord * 3 / pi);
  EXPECT_NEAR(std::fmod(measures.velocity.time, 1.0), 0.5, 1e-12);
  EXPECT_NEAR(measures.displacement.value, 3 / pi, chord * 3 / pi);
  EXPECT_NEAR(measures.arias_intensity, pi / (2 * standard_gravity) * 9,
              2 * chord * pi / (2 * standard_gravity) * 9);
  // Half of the energy of a period falls into each half of it: shares of 2 periods are passed at
  // t/2 − sin(4πt)/8π = share · 1.
  const double t = measures.significant_5_95.begin;
  EXPECT_NEAR(t / 2 - std::sin(4 * pi * t) / (8 * pi), 0.05, 2 * chord);
  EXPECT_NEAR(measures.significant_5_95.begin + measures.significant_5_95.end, 2, 1e-12);
}

TEST(GroundMeasures, AScaledMotionScalesThem) {
  const GroundMotion motion = make_synthetic({.seed = 5, .peak = 2});
  GroundMotion twice = motion;
  for (double& sample : twice.samples) sample *= -2;
  const GroundMeasures one = measure_ground(motion);
  const GroundMeasures two = measure_ground(twice);
  // A power of two changes no rounding.
  EXPECT_EQ(two.acceleration.value, -2 * one.acceleration.value);
  EXPECT_EQ(two.velocity.value, -2 * one.velocity.value);
  EXPECT_EQ(two.displacement.value, -2 * one.displacement.value);
  EXPECT_EQ(two.arias_intensity, 4 * one.arias_intensity);
  EXPECT_EQ(two.significant_5_95.begin, one.significant_5_95.begin);
  EXPECT_EQ(two.significant_5_95.end, one.significant_5_95.end);
}

TEST(GroundMeasures, FinerSamplesOnTheSameLinesChangeNothing) {
  const GroundMotion motion = make_synthetic({.seed = 5, .peak = 2});
  GroundMotion finer{motion.interval / 2, {motion.samples[0]}, ""};
  for (std::size_t k = 1; k < motion.samples.size(); ++k) {
    finer.samples.push_back((motion.samples[k - 1] + motion.samples[k]) / 2);
    finer.samples.push_back(motion.samples[k]);
  }
  const GroundMeasures one = measure_ground(motion);
  const GroundMeasures two = measure_ground(finer);
  // One rounding a sample of sums no larger than peak × duration, and its square for the displacement.
  const double sums = 4000 * rounding * 2 * 20;
  EXPECT_NEAR(two.velocity.value, one.velocity.value, sums);
  EXPECT_NEAR(two.displacement.value, one.displacement.value, 20 * sums);
  EXPECT_NEAR(two.arias_intensity / one.arias_intensity, 1, 4000 * rounding);
}

TEST(GroundMeasures, StillGroundHasNone) {
  for (const auto& samples : {std::vector<double>{0}, std::vector<double>{0, 0, 0}}) {
    const GroundMeasures measures = measure_ground(motion_of(samples, 0.5));
    EXPECT_EQ(measures.acceleration.value, 0);
    EXPECT_EQ(measures.velocity.value, 0);
    EXPECT_EQ(measures.displacement.value, 0);
    EXPECT_EQ(measures.arias_intensity, 0);
    EXPECT_EQ(measures.significant_5_95.length(), 0);
    EXPECT_EQ(husid(motion_of(samples, 0.5)), std::vector<double>(samples.size()));
  }
}

TEST(GroundIntegrals, IsTheIntegralAtTheSamples) {
  const GroundIntegrals path = ground_integrals(motion_of({0, 6, 6}, 1));
  EXPECT_EQ(path.velocities, (std::vector<double>{0, 3, 9}));
  EXPECT_EQ(path.displacements, (std::vector<double>{0, 1, 7}));
}

TEST(Husid, GrowsFromZeroToOne) {
  const std::vector<double> shares = husid(sine_record(16));
  EXPECT_EQ(shares.front(), 0);
  EXPECT_EQ(shares.back(), 1);
  for (std::size_t k = 1; k < shares.size(); ++k) EXPECT_GT(shares[k], shares[k - 1]);
}

TEST(BaseLine, OfALineIsTheLine) {
  std::vector<double> samples;
  for (int k = 0; k <= 400; ++k) samples.push_back(0.3 - 0.02 * (0.05 * k));
  const BaseLine line = fitted_base_line(motion_of(samples, 0.05));
  // The normal equations magnify the rounding of their two sums of 400 terms by their condition, below 1000.
  EXPECT_NEAR(line.value, 0.3, 1000 * 400 * rounding);
  EXPECT_NEAR(line.slope, -0.02, 1000 * 400 * rounding);
}

TEST(BaseLine, AddedToAMotionIsTakenOffAgain) {
  const GroundMotion motion = make_synthetic({.seed = 5, .peak = 2});
  const GroundMotion tilted = without(motion, {-0.1, 0.01});
  const BaseLine own = fitted_base_line(motion);
  const BaseLine found = fitted_base_line(tilted);
  EXPECT_NEAR(found.value - own.value, 0.1, 1000 * 2000 * rounding);
  EXPECT_NEAR(found.slope - own.slope, -0.01, 1000 * 2000 * rounding);
}

TEST(BaseLine, LeavesTheLeastVelocity) {
  const GroundMotion motion = without(make_synthetic({.seed = 5, .peak = 2}), {-0.1, 0.01});
  const BaseLine best = fitted_base_line(motion);
  const auto velocity = [&](const BaseLine& line) {
    double sum = 0;
    for (const double v : ground_integrals(without(motion, line)).velocities) sum += v * v;
    return sum;
  };
  // Away from the best line the sum grows by 1 % of its square and more; sums over samples differ from the
  // integral by far less.
  for (const double step : {-0.01, 0.01}) {
    EXPECT_GT(velocity({best.value + step, best.slope}), velocity(best));
    EXPECT_GT(velocity({best.value, best.slope + step / 10}), velocity(best));
  }
}

// Steps of a fiftieth of the period miss a peak by at most half a step: 1 − cos(π/50).
const double missed = 1 - std::cos(std::numbers::pi / 50);

TEST(Response, ToASuddenConstantAccelerationOvershootsByTheDamping) {
  // u = a/ω² (1 − exp(−ζωt) …) peaks after half a damped period at a/ω² (1 + exp(−πζ/√(1 − ζ²))).
  const GroundMotion step{0.01, std::vector<double>(301, 2.0), ""};
  for (const double damping : {0.0, 0.05, 0.3}) {
    for (const double period : {0.015, 0.2, 1.7}) {
      const double exact = 2 * (1 + std::exp(-std::numbers::pi * damping / std::sqrt(1 - damping * damping)));
      const double found = response(step, period, damping).pseudo_acceleration;
      EXPECT_LE(found, exact * (1 + 1e-11));
      EXPECT_GE(found, exact * (1 - missed));
    }
  }
}

TEST(Response, ToAnUndampedRampIsTheRampAndItsRipple) {
  // a = t for 1 s from rest, T = 1 s: ω²u = −(t − sin(ωt)/ω), largest during the ramp at its end, 1; then
  // free motion from ω²u = −1 with zero velocity, since 1 − cos ω = 0.
  const GroundMotion ramp{1, {0, 1}, ""};
  EXPECT_NEAR(response(ramp, 1, 0).pseudo_acceleration, 1, 1e-12);
}

TEST(Response, InResonanceGrowsByTheKnownStep) {
  // Undamped at its own period: u = A/2ω² (ωt cos ωt − sin ωt), A/ω² πn after n whole periods. Chords of the
  // sine take off at most (2π/N)²/8 of the load.
  constexpr int samples = 400, periods = 5;
  GroundMotion sine{1.0 / samples, {}, ""};
  for (int k = 0; k <= periods * samples; ++k)
    sine.samples.push_back(std::sin(2 * std::numbers::pi * k / samples));
  const double exact = std::numbers::pi * periods;
  EXPECT_NEAR(response(sine, 1, 0).pseudo_acceleration, exact,
              exact * std::pow(2 * std::numbers::pi / samples, 2) / 8);
}

TEST(Response, OfAStiffOscillatorIsTheGroundsAcceleration) {
  // Follows the ground with an overshoot below ζ- and slope-sized terms: T/2π times the steepest slope,
  // twice.
  const GroundMotion motion = make_synthetic({.seed = 2, .peak = 3});
  double steepest = 0;
  for (std::size_t k = 1; k < motion.samples.size(); ++k) {
    steepest = std::max(steepest, std::abs(motion.samples[k] - motion.samples[k - 1]) / motion.interval);
  }
  const double period = 1e-4;
  EXPECT_NEAR(response(motion, period, 0.05).pseudo_acceleration, 3,
              4 * period / (2 * std::numbers::pi) * steepest);
}

TEST(Response, OfASoftOscillatorIsTheGroundsDisplacement) {
  // Undamped, it stays at rest in space while the ground moves under it, but for a motion of its own of at
  // most ω²t²/2 of the largest displacement.
  const GroundMotion motion = make_synthetic({.seed = 2, .peak = 3});
  const double ground = std::abs(measure_ground(motion).displacement.value);
  const double period = 3000;
  const double omega = 2 * std::numbers::pi / period;
  const double found = response(motion, period, 0).pseudo_acceleration / (omega * omega);
  const double turn = omega * motion.end();
  // The displacement is taken at samples: between them it passes its peak by at most A h²/8.
  EXPECT_NEAR(found, ground, ground * turn * turn / 2 + 3 * 0.01 * 0.01 / 8);
}

TEST(ResponseSpectrum, CoversFromAFiftiethOfASecondToTen) {
  const std::vector<Response> spectrum = response_spectrum(make_synthetic({.seed = 2, .peak = 3}), 0.05);
  EXPECT_DOUBLE_EQ(spectrum.front().period, 0.02);
  EXPECT_DOUBLE_EQ(spectrum.back().period, 10);
  for (std::size_t k = 1; k < spectrum.size(); ++k) EXPECT_GT(spectrum[k].period, spectrum[k - 1].period);
}

// The record's last tenth of a second is silence; the sine ends, or never does.
TEST(GroundLeft, IsTheTimeThatAShakenSceneLeavesOut) {
  Scene scene;
  scene.horizontal = motion_of({0, 1, -1, 0.5, 0, 0}, 0.1);
  const auto left = [&](double duration) {
    scene.duration = duration;
    return ground_left(scene);
  };
  EXPECT_NEAR(left(0.2), 0.3, 4 * rounding);
  EXPECT_EQ(left(0.4), 0);
  EXPECT_EQ(left(0.5), 0);
  scene.horizontal = {};
  EXPECT_EQ(left(0.2), 0);
  scene.vertical.pulse = Pulse{.shape = PulseShape::sine, .amplitude = 2, .period = 1, .start = 1};
  EXPECT_EQ(left(0.2), 1.8);
  EXPECT_EQ(left(2), 0);
  scene.vertical.pulse->cycles = std::numeric_limits<double>::infinity();
  EXPECT_EQ(left(0.2), 0);
  // A Ricker wavelet, 4 s long, is (1 − 2z²) exp(−z²) with z = π at 3 s: less than a thousandth.
  scene.vertical.pulse = Pulse{.shape = PulseShape::ricker, .amplitude = 2, .period = 1};
  EXPECT_NEAR(left(2.9), 1.1, 4 * rounding);
  EXPECT_EQ(left(3), 0);
}

}  // namespace
}  // namespace rockstack
