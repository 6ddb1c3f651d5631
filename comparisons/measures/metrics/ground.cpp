#include "comparisons/measures/metrics/ground.hpp"

#include <algorithm>
#include <array>
#include <numbers>
#include <span>

#include "analytic/scene/lists.hpp"

namespace rockstack {
namespace {

/// The ground between two samples: acceleration a line, velocity a parabola, displacement a cubic.
struct Piece {
  double start, length;  ///< s
  double from, slope;    ///< m/s², m/s³
  double velocity, displacement;

  double velocity_at(double t) const { return velocity + t * (from + t * slope / 2); }
  double displacement_at(double t) const {
    return displacement + t * (velocity + t * (from / 2 + t * slope / 6));
  }
};

std::vector<Piece> pieces(const GroundMotion& motion) {
  std::vector<Piece> result;
  double velocity = 0, displacement = 0;
  for (std::size_t i = 0; i + 1 < motion.samples.size(); ++i) {
    const double slope = (motion.samples[i + 1] - motion.samples[i]) / motion.interval;
    result.push_back({motion.interval * static_cast<double>(i), motion.interval, motion.samples[i], slope,
                      velocity, displacement});
    displacement = result.back().displacement_at(motion.interval);
    velocity = result.back().velocity_at(motion.interval);
  }
  return result;
}

void raise(Peak& peak, double value, double time) {
  if (std::abs(value) > std::abs(peak.value)) peak = {value, time};
}

/// The times in a piece at which its velocity is zero, without cancellation; others may come along.
std::array<double, 2> standstills(const Piece& piece) {
  const double root = std::sqrt(std::max(0.0, piece.from * piece.from - 2 * piece.slope * piece.velocity));
  const double sum = -(piece.from + std::copysign(root, piece.from));
  return {sum / piece.slope, 2 * piece.velocity / sum};
}

void raise_within(GroundMeasures& measures, const Piece& piece) {
  const auto inside = [&](double t) { return t > 0 && t <= piece.length; };
  const double turning = -piece.from / piece.slope;
  for (const double t : {turning, piece.length})
    if (inside(t)) raise(measures.velocity, piece.velocity_at(t), piece.start + t);
  const auto [one, other] = standstills(piece);
  for (const double t : {one, other, piece.length})
    if (inside(t)) raise(measures.displacement, piece.displacement_at(t), piece.start + t);
}

/// ∫a² dt over a straight line from a to b.
double square_integral(double a, double b, double length) {
  return length / 3 * (a * a + a * b + b * b);
}

/// ∫a² dt from the start to each sample.
std::vector<double> energies(const GroundMotion& motion) {
  std::vector<double> result{0};
  for (std::size_t i = 0; i + 1 < motion.samples.size(); ++i)
    result.push_back(result.back() +
                     square_integral(motion.samples[i], motion.samples[i + 1], motion.interval));
  return result;
}

/// When the integral passes that share of its end: bisection inside the piece, until a double holds no more.
double time_of_share(const GroundMotion& motion, const std::vector<double>& energy, double share) {
  const double wanted = share * energy.back();
  const auto next = std::lower_bound(energy.begin(), energy.end(), wanted);
  if (next == energy.begin()) return 0;
  const auto piece = static_cast<std::size_t>(next - energy.begin()) - 1;
  const double from = motion.samples[piece];
  const double slope = (motion.samples[piece + 1] - from) / motion.interval;
  double low = 0, high = motion.interval;
  for (double t = high / 2; t > low && t < high; t = (low + high) / 2) {
    const bool passed = energy[piece] + square_integral(from, from + slope * t, t) >= wanted;
    (passed ? high : low) = t;
  }
  return motion.interval * static_cast<double>(piece) + high;
}

/// ∫v t dt and ∫v t²/2 dt over a piece by Gauss's rule of three points, exact up to the fifth power.
std::array<double, 2> velocity_moments(const Piece& piece) {
  const double reach = std::sqrt(0.6);
  std::array<double, 2> moments{};
  for (const auto& [node, weight] : {std::pair{-reach, 5.0}, {0.0, 8.0}, {reach, 5.0}}) {
    const double offset = piece.length / 2 * (1 + node);
    const double t = piece.start + offset;
    const double part = piece.length * weight / 18 * piece.velocity_at(offset);
    moments[0] += part * t;
    moments[1] += part * t * t / 2;
  }
  return moments;
}

struct OscillatorState {
  double displacement = 0, velocity = 0;  ///< from the ground, m and m/s
};

/// An oscillator u'' + 2ζωu' + ω²u = −a and its free motion over one step.
class Oscillator {
 public:
  Oscillator(double period, double damping, double step)
      : omega_(2 * std::numbers::pi / period), damping_(damping), step_(step) {
    const double damped = omega_ * std::sqrt(1 - damping * damping);
    const double decay = std::exp(-damping * omega_ * step);
    cosine_ = decay * std::cos(damped * step);
    sine_ = decay * std::sin(damped * step) / damped;
  }

  /// The state one step on, the ground's acceleration being from + slope t: free motion about the solution
  /// that is itself a straight line.
  OscillatorState after(const OscillatorState& state, double from, double slope) const {
    const double square = omega_ * omega_;
    const double line_velocity = -slope / square;
    const double line = (2 * damping_ * slope / omega_ - from) / square;
    const double u = state.displacement - line;
    const double v = state.velocity - line_velocity;
    const double rate = damping_ * omega_;
    return {u * cosine_ + (v + rate * u) * sine_ + line + line_velocity * step_,
            v * cosine_ - (rate * v + square * u) * sine_ + line_velocity};
  }

 private:
  double omega_, damping_, step_, cosine_ = 0, sine_ = 0;
};

/// The largest acceleration from a time on, m/s²; of pulses at the ends of a thousand parts of what is left.
/// For steps of velocity, the last, m/s.
double largest_after(const GroundMotion& motion, double time) {
  if (!motion.steps.empty()) return std::abs(motion.steps.back().size);
  if (!motion.pulse) {
    const auto first = static_cast<std::size_t>(std::ceil(time / motion.interval));
    return largest_magnitude(std::span(motion.samples).subspan(std::min(first, motion.samples.size())));
  }
  constexpr int parts = 1000;
  double largest = 0;
  for (int i = 0; i <= parts; ++i)
    largest = std::max(largest, std::abs(acceleration(
                                    motion, std::lerp(time, motion.end(), static_cast<double>(i) / parts))));
  return largest;
}

}  // namespace

GroundMeasures measure_ground(const GroundMotion& motion) {
  GroundMeasures measures;
  measures.points = motion.samples.size();
  measures.interval = motion.interval;
  measures.duration = motion.end();
  for (std::size_t i = 0; i < motion.samples.size(); ++i)
    raise(measures.acceleration, motion.samples[i], motion.interval * static_cast<double>(i));
  for (const Piece& piece : pieces(motion)) raise_within(measures, piece);
  const GroundIntegrals path = ground_integrals(motion);
  measures.final_velocity = path.velocities.back();
  measures.final_displacement = path.displacements.back();
  const std::vector<double> energy = energies(motion);
  const auto passes = [&](double share) { return time_of_share(motion, energy, share); };
  measures.arias_intensity = std::numbers::pi / (2 * standard_gravity) * energy.back();
  measures.significant_5_95 = {passes(0.05), passes(0.95)};
  measures.significant_5_75 = {passes(0.05), passes(0.75)};
  return measures;
}

GroundIntegrals ground_integrals(const GroundMotion& motion) {
  GroundIntegrals path{{0}, {0}};
  for (const Piece& piece : pieces(motion)) {
    path.velocities.push_back(piece.velocity_at(piece.length));
    path.displacements.push_back(piece.displacement_at(piece.length));
  }
  return path;
}

std::vector<double> husid(const GroundMotion& motion) {
  std::vector<double> shares = energies(motion);
  const double total = shares.back();
  for (double& share : shares) share = total > 0 ? share / total : 0;
  return shares;
}

BaseLine fitted_base_line(const GroundMotion& motion) {
  const double end = motion.end();
  if (end == 0) return {};
  double first = 0, second = 0;
  for (const Piece& piece : pieces(motion)) {
    const auto [with_t, with_square] = velocity_moments(piece);
    first += with_t;
    second += with_square;
  }
  // Least squares of v − c₀ t − c₁ t²/2: with u = ∫v t / T³ and w = ∫v t²/2 / T⁴ the normal equations are
  // u = c₀/3 + c₁T/8 and w = c₀/8 + c₁T/20.
  const double u = first / std::pow(end, 3);
  const double w = second / std::pow(end, 4);
  return {48 * u - 120 * w, (320 * w - 120 * u) / end};
}

GroundMotion without(const GroundMotion& motion, const BaseLine& line) {
  GroundMotion result = motion;
  for (std::size_t i = 0; i < result.samples.size(); ++i)
    result.samples[i] -= line.value + line.slope * (motion.interval * static_cast<double>(i));
  return result;
}

Response response(const GroundMotion& motion, double period, double damping) {
  constexpr int steps_in_period = 50;
  const int parts = std::max(1, static_cast<int>(std::ceil(motion.interval * steps_in_period / period)));
  const double step = motion.interval / parts;
  const Oscillator oscillator(period, damping, step);
  OscillatorState state;
  double largest = 0;
  for (std::size_t i = 0; i + 1 < motion.samples.size(); ++i) {
    const double slope = (motion.samples[i + 1] - motion.samples[i]) / motion.interval;
    for (int part = 0; part < parts; ++part) {
      state = oscillator.after(state, motion.samples[i] + slope * (part * step), slope);
      largest = std::max(largest, std::abs(state.displacement));
    }
  }
  const Oscillator free(period, damping, period / steps_in_period);
  for (int i = 0; i < steps_in_period; ++i) {
    state = free.after(state, 0, 0);
    largest = std::max(largest, std::abs(state.displacement));
  }
  const double omega = 2 * std::numbers::pi / period;
  return {period, omega * omega * largest};
}

std::vector<Response> response_spectrum(const GroundMotion& motion, double damping) {
  constexpr int count = 201;
  const double shortest = std::max(0.02, motion.interval);
  const double longest = 500 * shortest;
  std::vector<Response> spectrum;
  for (int i = 0; i < count; ++i) {
    const double period = shortest * std::pow(longest / shortest, i / (count - 1.0));
    spectrum.push_back(response(motion, period, damping));
  }
  return spectrum;
}

double ground_left(const Scene& scene) {
  constexpr double told = 1e-3, rounding = 1e-9;
  double left = 0;
  for (const GroundMotion* motion : {&scene.horizontal, &scene.vertical}) {
    const double end = motion->end();
    if (!(end > scene.duration * (1 + rounding)) || std::isinf(end)) continue;
    const double largest = motion->pulse ? std::abs(motion->pulse->amplitude) : peak(*motion);
    if (largest_after(*motion, scene.duration) > told * largest) left = std::max(left, end - scene.duration);
  }
  return left;
}

}  // namespace rockstack
