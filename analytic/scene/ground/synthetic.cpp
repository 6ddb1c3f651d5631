#include "analytic/scene/ground/synthetic.hpp"

#include <algorithm>
#include <numbers>
#include <random>

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

struct Wave {
  double frequency;  ///< Hz
  double deviation;  ///< of its amplitude
};

/// The waves that noise of variance 1 is made of. A quarter of the slowest wave fits into the duration, so
/// that the noise does not repeat itself within it.
std::vector<Wave> waves(const SyntheticMotion& motion) {
  const double spacing = 0.5 / motion.duration;
  const auto count = static_cast<std::size_t>(synthetic_cutoff(motion) / spacing);
  std::vector<Wave> result;
  double variance = 0;
  for (std::size_t k = 0; k < count; ++k) {
    const double frequency = spacing * (static_cast<double>(k) + 0.5);
    result.push_back({frequency, std::sqrt(synthetic_spectrum(motion, frequency))});
    variance += result.back().deviation * result.back().deviation;
  }
  for (Wave& wave : result) wave.deviation /= std::sqrt(variance);
  return result;
}

/// TurningWaves whose planes turn side by side: one alone would wait for its last turn.
struct TurningWaves {
  static constexpr std::size_t size = 6;
  using Numbers = std::array<double, size>;
  Numbers cosines{}, sines{};  ///< of a turn
  Numbers first{}, second{};   ///< amplitudes
};

/// Adds first cos + second sin of each wave, one after the other, at every sample: one turn a sample.
void add(std::vector<double>& samples, TurningWaves waves) {
  auto& [cosines, sines, first, second] = waves;
  for (double& sample : samples) {
    for (const double height : first) sample += height;
    for (std::size_t k = 0; k < TurningWaves::size; ++k) {
      const double turned = first[k] * cosines[k] + second[k] * sines[k];
      second[k] = second[k] * cosines[k] - first[k] * sines[k];
      first[k] = turned;
    }
  }
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
  std::mt19937_64 generator(motion.seed);
  std::vector<double> samples(static_cast<std::size_t>(std::lround(motion.duration / motion.interval)) + 1);
  const std::vector<Wave> all = waves(motion);
  for (std::size_t start = 0; start < all.size(); start += TurningWaves::size) {
    TurningWaves group;
    for (std::size_t k = 0; k < std::min(TurningWaves::size, all.size() - start); ++k) {
      const Wave& wave = all[start + k];
      const auto [first, second] = draw_normal(generator);
      const double angle = two_pi * wave.frequency * motion.interval;
      group.cosines[k] = std::cos(angle);
      group.sines[k] = std::sin(angle);
      group.first[k] = wave.deviation * first;
      group.second[k] = wave.deviation * second;
    }
    add(samples, group);
  }
  for (std::size_t i = 0; i < samples.size(); ++i)
    samples[i] *= synthetic_envelope(motion, motion.interval * static_cast<double>(i));
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
