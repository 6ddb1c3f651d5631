#include "analytic/scene/ground/synthetic.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <random>

#include "analytic/scene/scene.hpp"

namespace rockstack {
namespace {

using Complex = std::complex<double>;

constexpr double two_pi = 2 * std::numbers::pi;
constexpr int seeds = 400;
// Squares of normal numbers, and squared moduli of sums of them, have a standard deviation of at most √2
// times their mean; five of those, for the mean over all seeds.
const double five_deviations = 5 * std::sqrt(2.0 / seeds);

SyntheticMotion motion_of(std::uint64_t seed) {
  return {.seed = seed, .peak = 6.97};
}

/// Coarse and short, so that many can be made.
SyntheticMotion small_motion(std::uint64_t seed) {
  return {.seed = seed, .peak = 1, .duration = 10, .interval = 0.02, .frequency = 2, .damping = 0.4};
}

/// The spectrum as the squared modulus of the two filters' transfer functions.
double target(const SyntheticMotion& motion, double frequency) {
  const Complex i(0, 1);
  const double r = frequency / motion.frequency;
  const Complex layer = (1.0 + 2.0 * i * motion.damping * r) / (1 - r * r + 2.0 * i * motion.damping * r);
  const double s = 10 * r;
  return std::norm(layer * s * s / (1 - s * s + 2.0 * i * 0.6 * s));
}

/// ∫ of the envelope times exp(−2πift), as a sum over samples.
Complex envelope_transform(const SyntheticMotion& motion, double frequency) {
  Complex sum = 0;
  for (int k = 0; k <= std::lround(motion.duration / motion.interval); ++k) {
    const double t = k * motion.interval;
    sum += synthetic_envelope(motion, t) * std::polar(1.0, -two_pi * frequency * t);
  }
  return sum;
}

/// The mean of the periodogram of enveloped noise: every wave's share of the variance, half of it at plus and
/// half at minus its frequency, spread by the envelope.
double expected_periodogram(const SyntheticMotion& motion, double frequency) {
  double sum = 0, variance = 0;
  const int waves = static_cast<int>(std::lround(2 * 25 * motion.duration));
  for (int wave = 0; wave < waves; ++wave) {
    const double each = (0.5 * wave + 0.25) / motion.duration;
    const double share = target(motion, each);
    variance += share;
    sum += share / 2 *
           (std::norm(envelope_transform(motion, frequency - each)) +
            std::norm(envelope_transform(motion, frequency + each)));
  }
  return sum / variance;
}

Complex transform(const std::vector<double>& samples, double interval, double frequency) {
  Complex sum = 0;
  for (std::size_t k = 0; k < samples.size(); ++k) {
    sum += samples[k] * std::polar(1.0, -two_pi * frequency * interval * static_cast<double>(k));
  }
  return sum;
}

struct End {
  double velocity, displacement;
};

/// Straight lines between samples integrated from rest.
End end_of(const std::vector<double>& samples, double interval) {
  End end{0, 0};
  for (std::size_t k = 0; k + 1 < samples.size(); ++k) {
    end.displacement += interval * end.velocity + interval * interval * (2 * samples[k] + samples[k + 1]) / 6;
    end.velocity += interval * (samples[k] + samples[k + 1]) / 2;
  }
  return end;
}

TEST(Synthetic, TheSameSeedGivesTheSameBits) {
  EXPECT_EQ(make_synthetic(motion_of(7)).samples, make_synthetic(motion_of(7)).samples);
}

TEST(Synthetic, AnotherSeedGivesAMotionThatHasNothingToDoWithTheFirst) {
  const std::vector<double> one = modulated_noise(motion_of(7));
  const std::vector<double> other = modulated_noise(motion_of(8));
  double product = 0, square = 0;
  for (std::size_t k = 0; k < one.size(); ++k) {
    product += one[k] * other[k];
    square += one[k] * one[k];
  }
  // Some 2 × 10 s × 2.5 Hz independent numbers leave a correlation of about 1/√50.
  EXPECT_LT(std::abs(product / square), 5 / std::sqrt(50.0));
}

/// Each wave by itself, in the order of its draws: in 1009 intervals, a prime number, and up to half the
/// sampling rate.
TEST(Synthetic, TheNoiseIsTheSumOfItsWaves) {
  for (const SyntheticMotion& motion :
       {SyntheticMotion{.seed = 3, .peak = 1, .duration = 10.09, .interval = 0.01},
        SyntheticMotion{.seed = 4, .peak = 1, .duration = 2, .interval = 0.05}}) {
    const double spacing = 0.5 / motion.duration;
    const int count = static_cast<int>(std::lround(synthetic_cutoff(motion) / spacing - 0.4));
    std::mt19937_64 generator(motion.seed);
    const auto uniform = [&] { return (static_cast<double>(generator() >> 11U) + 0.5) / 9007199254740992.0; };
    const std::vector<double> noise = modulated_noise(motion);
    std::vector<double> sum(noise.size());
    double variance = 0, squares = 0;
    for (int k = 0; k < count; ++k) {
      const double frequency = spacing * (k + 0.5), share = target(motion, frequency);
      const double radius = std::sqrt(-2 * share * std::log(uniform())), phase = two_pi * uniform();
      for (std::size_t i = 0; i < sum.size(); ++i)
        sum[i] += radius * std::cos(two_pi * frequency * motion.interval * static_cast<double>(i) - phase);
      variance += share;
      squares += radius * radius / 2;
    }
    double off = 0;
    for (std::size_t i = 0; i < sum.size(); ++i) {
      const double envelope = synthetic_envelope(motion, motion.interval * static_cast<double>(i));
      off += std::pow(noise[i] - envelope * sum[i] / std::sqrt(variance), 2);
    }
    // Each of three transforms of a length is off by at most 4 roundings for each time that it is halved
    // (Higham 2002, Theorem 24.2: half of 1 + 4 √2), of all that the convolution adds up; each wave of the
    // sum here by the roundings of its angle, count π at most.
    const auto length = static_cast<double>(std::bit_ceil(sum.size() + static_cast<std::size_t>(count)));
    const double roundings =
        12 * std::log2(length) * length + 2 * std::numbers::pi * count * std::sqrt(length);
    EXPECT_LT(std::sqrt(off),
              roundings * std::numeric_limits<double>::epsilon() * std::sqrt(2 * squares / variance));
  }
}

TEST(Synthetic, HasTheSamplesThatItsDurationAsksFor) {
  const GroundMotion motion = make_synthetic(motion_of(1));
  EXPECT_EQ(motion.samples.size(), 2001U);
  EXPECT_EQ(motion.interval, 0.01);
  EXPECT_EQ(motion.samples.front(), 0);
  EXPECT_EQ(motion.source, "synthetic motion, seed 1");
}

TEST(Synthetic, ThePeakIsReachedToTheLastBit) {
  for (const double wanted : {0.1, 6.97, 6.9651}) {
    for (std::uint64_t seed = 0; seed < 10; ++seed) {
      SyntheticMotion motion = small_motion(seed);
      motion.peak = wanted;
      EXPECT_EQ(peak(make_synthetic(motion)), wanted);
    }
  }
}

TEST(Synthetic, EndsAtRest) {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    const SyntheticMotion motion = motion_of(seed);
    const GroundMotion made = make_synthetic(motion);
    const End end = end_of(made.samples, made.interval);
    // Both sums, in the correction and here, have one rounding a sample, of terms whose sum is at most
    // peak × duration, or times its square for the displacement; scaling adds two more to each sample.
    const double rounding = 3 * static_cast<double>(made.samples.size()) *
                            std::numeric_limits<double>::epsilon() * motion.peak * motion.duration;
    EXPECT_NEAR(end.velocity, 0, rounding);
    EXPECT_NEAR(end.displacement, 0, rounding * motion.duration);
    // Without correction there is drift that the bounds above would see.
    const End noise = end_of(modulated_noise(motion), motion.interval);
    EXPECT_GT(std::abs(noise.velocity), 1e3 * rounding);
    EXPECT_GT(std::abs(noise.displacement), 1e3 * rounding * motion.duration);
  }
}

TEST(Synthetic, TheVarianceFollowsTheEnvelope) {
  std::vector<double> squares;
  for (std::uint64_t seed = 0; seed < seeds; ++seed) {
    const std::vector<double> noise = modulated_noise(small_motion(seed));
    squares.resize(noise.size());
    for (std::size_t k = 0; k < noise.size(); ++k) squares[k] += noise[k] * noise[k] / seeds;
  }
  EXPECT_EQ(squares[0], 0);
  for (std::size_t k = 1; k < squares.size(); k += 10) {
    const double envelope = synthetic_envelope(small_motion(0), 0.02 * static_cast<double>(k));
    EXPECT_NEAR(squares[k] / (envelope * envelope), 1, five_deviations);
  }
}

TEST(Synthetic, TheEnvelopeHasItsPeakAfterAFifthOfTheDuration) {
  const SyntheticMotion motion = motion_of(0);
  EXPECT_EQ(synthetic_envelope(motion, 0), 0);
  EXPECT_DOUBLE_EQ(synthetic_envelope(motion, 4), 1);
  EXPECT_LT(synthetic_envelope(motion, 3.9), 1);
  EXPECT_LT(synthetic_envelope(motion, 4.1), 1);
  EXPECT_NEAR(synthetic_envelope(motion, 20), 25 * std::exp(-8), 1e-15);
}

TEST(Synthetic, TheMeanPeriodogramIsTheFiltersSpectrum) {
  const std::vector<double> frequencies{0.2, 0.5, 1, 2, 4, 8, 16, 24};
  std::vector<double> means(frequencies.size());
  for (std::uint64_t seed = 0; seed < seeds; ++seed) {
    const std::vector<double> noise = modulated_noise(small_motion(seed));
    for (std::size_t k = 0; k < means.size(); ++k) {
      means[k] += std::norm(transform(noise, 0.02, frequencies[k])) / seeds;
    }
  }
  for (std::size_t k = 0; k < means.size(); ++k) {
    EXPECT_NEAR(means[k] / expected_periodogram(small_motion(0), frequencies[k]), 1, five_deviations)
        << frequencies[k] << " Hz";
  }
}

TEST(Synthetic, TheSpectrumIsThatOfTheTwoFilters) {
  const SyntheticMotion motion = small_motion(0);
  for (const double frequency : {0.01, 0.2, 1.0, 2.0, 10.0, 25.0}) {
    // A score of operations, each within one rounding.
    EXPECT_NEAR(synthetic_spectrum(motion, frequency) / target(motion, frequency), 1,
                20 * std::numeric_limits<double>::epsilon() * 10);
  }
}

TEST(Synthetic, NumbersOutOfRangeAreRefusedByName) {
  const auto key_of = [](SyntheticMotion motion) -> std::string {
    try {
      make_synthetic(motion);
    } catch (const FieldError& error) {
      return error.key;
    }
    return "";
  };
  EXPECT_EQ(key_of({.peak = 0}), "synthetic.peak");
  EXPECT_EQ(key_of({.peak = 1, .duration = 1001}), "synthetic.duration");
  EXPECT_EQ(key_of({.peak = 1, .duration = std::nan("")}), "synthetic.duration");
  EXPECT_EQ(key_of({.peak = 1, .interval = 0.0009}), "synthetic.interval");
  EXPECT_EQ(key_of({.peak = 1, .interval = 1.3}), "synthetic.interval");
  EXPECT_EQ(key_of({.peak = 1, .frequency = 26}), "synthetic.frequency");
  EXPECT_EQ(key_of({.peak = 1, .frequency = 0.04}), "synthetic.frequency");
  EXPECT_EQ(key_of({.peak = 1, .damping = 0}), "synthetic.damping");
  EXPECT_EQ(key_of({.peak = 1, .damping = 1.1}), "synthetic.damping");
  EXPECT_EQ(key_of({.peak = 1}), "");
}

}  // namespace
}  // namespace rockstack
