#include "analytic/scene/ground/synthetic.hpp"

#include <algorithm>
#include <bit>
#include <numbers>
#include <random>
#include <unsupported/Eigen/FFT>

#include "analytic/scene/messages/input_error.hpp"
#include "analytic/scene/messages/number_text.hpp"

namespace rockstack {
namespace {

constexpr double two_pi = 2 * std::numbers::pi;

/// Two independent standard normal numbers (Box & Muller 1958); the library's own may differ by compiler.
std::array<double, 2> draw_normal(std::mt19937_64& generator) {
  const auto uniform = [&] { return (static_cast<double>(generator() >> 11U) + 0.5) * 0x1p-53; };
  const double radius = std::sqrt(-2 * std::log(uniform()));
  const double angle = two_pi * uniform();
  return {radius * std::cos(angle), radius * std::sin(angle)};
}

/// The standard deviations of the amplitudes of the waves that noise of variance 1 is made of. A quarter of
/// the slowest wave fits into the duration, so that the noise does not repeat itself within it.
std::vector<double> deviations(const SyntheticMotion& motion) {
  const double spacing = 0.5 / motion.duration;
  const auto count = static_cast<std::size_t>(synthetic_cutoff(motion) / spacing);
  std::vector<double> result;
  double variance = 0;
  for (std::size_t k = 0; k < count; ++k) {
    result.push_back(std::sqrt(synthetic_spectrum(motion, spacing * (static_cast<double>(k) + 0.5))));
    variance += result.back() * result.back();
  }
  for (double& deviation : result) deviation /= std::sqrt(variance);
  return result;
}

/// Where straight lines between samples lead from rest, with 1 as the interval.
struct End {
  double velocity = 0, displacement = 0;
};

End end_of(const std::vector<double>& samples) {
  End end;
  for (std::size_t i = 0; i + 1 < samples.size(); ++i) {
    end.displacement += end.velocity + samples[i] / 3 + samples[i + 1] / 6;
    end.velocity += (samples[i] + samples[i + 1]) / 2;
  }
  return end;
}

/// Takes off the combination of two shapes, the envelope and that times time, that leaves the end at rest.
void correct_base_line(const SyntheticMotion& motion, std::vector<double>& samples) {
  std::vector<double> flat, rising;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double t = motion.interval * static_cast<double>(i);
    flat.push_back(synthetic_envelope(motion, t));
    rising.push_back(flat.back() * t / motion.duration);
  }
  const End end = end_of(samples), one = end_of(flat), other = end_of(rising);
  const double determinant = one.velocity * other.displacement - other.velocity * one.displacement;
  const double flat_part =
      (end.velocity * other.displacement - other.velocity * end.displacement) / determinant;
  const double rising_part =
      (one.velocity * end.displacement - end.velocity * one.displacement) / determinant;
  for (std::size_t i = 0; i < samples.size(); ++i)
    samples[i] -= flat_part * flat[i] + rising_part * rising[i];
}

}  // namespace

double synthetic_spectrum(const SyntheticMotion& motion, double frequency) {
  constexpr double slowness = 0.1, high_pass_damping = 0.6;
  const auto square = [](double x) { return x * x; };
  const double r = square(frequency / motion.frequency);
  const double damped = 4 * square(motion.damping) * r;
  const double layer = (1 + damped) / (square(1 - r) + damped);
  const double s = r / square(slowness);
  return layer * s * s / (square(1 - s) + 4 * square(high_pass_damping) * s);
}

double synthetic_envelope(const SyntheticMotion& motion, double t) {
  const double s = 5 * t / motion.duration;
  return s * s * std::exp(2 * (1 - s));
}

std::vector<double> modulated_noise(const SyntheticMotion& motion) {
  const std::vector<double> waves = deviations(motion);
  const auto intervals = static_cast<std::size_t>(std::lround(motion.duration / motion.interval));
  // At sample j wave k has turned by (2k + 1) j of so many parts of a turn, and (2k + 1) j = k (k + 1) + j² −
  // (k − j) (k − j + 1): a convolution, by transforms of 2ⁿ numbers (Bluestein 1970, IEEE Transactions on
  // Audio and Electroacoustics 18, 451–455).
  const std::size_t whole = 4 * intervals;
  const auto turned = [&](std::size_t parts) {
    return std::polar(1.0, two_pi * static_cast<double>(parts % whole) / static_cast<double>(whole));
  };
  const std::size_t length = std::bit_ceil(waves.size() + intervals);
  std::vector<std::complex<double>> noise(length), chirp(length), spectrum, other;
  for (std::size_t j = 1; j <= intervals; ++j) chirp[j] = conj(turned(j * (j - 1)));
  std::mt19937_64 generator(motion.seed);
  for (std::size_t k = 0; k < waves.size(); ++k) {
    const auto [cosine, sine] = draw_normal(generator);
    noise[k] = waves[k] * std::complex(cosine, -sine) * conj(chirp[k + 1]);
    chirp[(length - k) % length] = chirp[k + 1];
  }
  Eigen::FFT<double> transform;
  transform.fwd(spectrum, noise);
  transform.fwd(other, chirp);
  for (std::size_t k = 0; k < length; ++k) spectrum[k] *= other[k];
  transform.inv(noise, spectrum);
  std::vector<double> samples;
  for (std::size_t j = 0; j <= intervals; ++j)
    samples.push_back(synthetic_envelope(motion, motion.interval * static_cast<double>(j)) *
                      (turned(j * j) * noise[j]).real());
  return samples;
}

GroundMotion make_synthetic(const SyntheticMotion& motion) {
  validate(motion);
  GroundMotion result{motion.interval, modulated_noise(motion),
                      "synthetic motion, seed " + std::to_string(motion.seed), true};
  correct_base_line(motion, result.samples);
  const double largest = peak(result);
  // Divided first, so that the largest sample comes out as the peak to the last bit.
  for (double& sample : result.samples) sample = sample / largest * motion.peak;
  return result;
}

void validate(const SyntheticMotion& motion, const std::string& key) {
  require_positive(key + ".peak", motion.peak);
  if (!(motion.duration > 0 && motion.duration <= 1000))
    throw FieldError(key + ".duration", motion.duration, "a number > 0 and at most 1000");
  const double shortest = motion.duration / 20000, longest = motion.duration / 16;
  if (!(motion.interval >= shortest && motion.interval <= longest))
    throw FieldError(key + ".interval", motion.interval,
                     "from " + number_text(shortest) + " to " + number_text(longest) +
                         ", the duration in 20000 to 16 parts");
  const double least = 1 / motion.duration, most = synthetic_cutoff(motion);
  if (!(motion.frequency >= least && motion.frequency <= most))
    throw FieldError(
        key + ".frequency", motion.frequency,
        "from " + number_text(least) + ", one cycle in the duration, to " + number_text(most) + " Hz");
  if (!(motion.damping > 0 && motion.damping <= 1))
    throw FieldError(key + ".damping", motion.damping, "a number > 0 and at most 1");
}

}  // namespace rockstack
