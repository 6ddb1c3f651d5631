#include "comparisons/measures/metrics/ground/response_spectrum.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "analytic/scene/ground/synthetic.hpp"
#include "comparisons/measures/metrics/ground/ground_measures.hpp"

namespace rockstack {
namespace {

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

}  // namespace
}  // namespace rockstack
