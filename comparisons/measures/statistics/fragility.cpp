#include "comparisons/measures/statistics/fragility.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "comparisons/measures/statistics/samples.hpp"

namespace rockstack {
namespace {

constexpr double two_sided = 1.959963984540054;  // Φ of it = 0.975

double normal_cdf(double x) {
  return 0.5 * std::erfc(-x / std::numbers::sqrt2);
}

double normal_density(double x) {
  return std::exp(-x * x / 2) / std::sqrt(2 * std::numbers::pi);
}

constexpr double far_tail = -30;  // beyond it the leading term is exact to 1e-3, and no fit ends there

double log_normal_cdf(double x) {
  if (x > far_tail) return std::log(normal_cdf(x));
  return -x * x / 2 - std::log(-x * std::sqrt(2 * std::numbers::pi));
}

/// φ(x)/Φ(x), the derivative of log Φ.
double mills(double x) {
  if (x < far_tail) return -x;
  return normal_density(x) / normal_cdf(x);
}

/// A straight line a + b x of the normal quantile.
struct Line {
  double a = 0, b = 1;
};

/// The log-likelihood of a line with its gradient and Fisher information; x is ln(intensity) in deviations.
struct Likelihood {
  double value = 0;
  double by_a = 0, by_b = 0;
  double aa = 0, ab = 0, bb = 0;
};

Likelihood likelihood(const std::vector<Level>& levels, const std::vector<double>& x, const Line& line) {
  Likelihood sum;
  for (std::size_t i = 0; i < levels.size(); ++i) {
    const auto hits = static_cast<double>(levels[i].toppled);
    const auto misses = static_cast<double>(levels[i].runs) - hits;
    const double eta = line.a + line.b * x[i];
    sum.value += hits * log_normal_cdf(eta) + misses * log_normal_cdf(-eta);
    const double slope = hits * mills(eta) - misses * mills(-eta);
    sum.by_a += slope;
    sum.by_b += slope * x[i];
    const double weight = (hits + misses) * mills(eta) * mills(-eta);
    sum.aa += weight;
    sum.ab += weight * x[i];
    sum.bb += weight * x[i] * x[i];
  }
  return sum;
}

/// Some topple at a lower intensity than some that stand: without that the likelihood has no maximum.
bool overlap(const std::vector<Level>& levels) {
  double lowest_toppled = std::numeric_limits<double>::infinity();
  double highest_standing = 0;
  for (const Level& level : levels) {
    if (level.toppled > 0) lowest_toppled = std::min(lowest_toppled, level.intensity);
    if (level.toppled < level.runs) highest_standing = std::max(highest_standing, level.intensity);
  }
  return lowest_toppled < highest_standing;
}

/// Newton's method with the Fisher information, halving steps that go downhill.
std::optional<Line> climb(const std::vector<Level>& levels, const std::vector<double>& x) {
  constexpr int most_steps = 200;
  constexpr double rounding = 1e-13;
  Line line;
  Likelihood here = likelihood(levels, x, line);
  for (int step = 0; step < most_steps; ++step) {
    const double determinant = here.aa * here.bb - here.ab * here.ab;
    if (!(determinant > 0)) return std::nullopt;
    double da = (here.bb * here.by_a - here.ab * here.by_b) / determinant;
    double db = (here.aa * here.by_b - here.ab * here.by_a) / determinant;
    const auto small = [&] {
      return std::abs(da) + std::abs(db) <= rounding * (1 + std::abs(line.a) + std::abs(line.b));
    };
    Line next{line.a + da, line.b + db};
    Likelihood there = likelihood(levels, x, next);
    while (!(there.value >= here.value) && !small()) {
      da /= 2;
      db /= 2;
      next = {line.a + da, line.b + db};
      there = likelihood(levels, x, next);
    }
    line = next;
    here = there;
    if (small()) return line;
  }
  return std::nullopt;
}

}  // namespace

Bounds wilson_bounds(std::size_t hits, std::size_t trials) {
  if (trials == 0) return {};
  constexpr double z = two_sided;
  const auto n = static_cast<double>(trials);
  const double share = static_cast<double>(hits) / n;
  const double scale = 1 / (1 + z * z / n);
  const double centre = scale * (share + z * z / (2 * n));
  const double half = scale * z * std::sqrt(share * (1 - share) / n + z * z / (4 * n * n));
  return {hits == 0 ? 0 : centre - half, hits == trials ? 1 : centre + half};
}

std::optional<Fragility> fit_fragility(const std::vector<Level>& all) {
  std::vector<Level> levels = all;  // ln 0 is sure to stand, whatever the curve
  std::erase_if(levels, [](const Level& level) { return level.intensity == 0 && level.toppled == 0; });
  std::vector<double> x;
  double sum = 0, squares = 0, runs = 0;
  for (const Level& level : levels) {
    if (!(level.intensity > 0)) return std::nullopt;
    const double log = std::log(level.intensity);
    x.push_back(log);
    const auto n = static_cast<double>(level.runs);
    runs += n;
    sum += n * log;
    squares += n * log * log;
  }
  if (!overlap(levels)) return std::nullopt;
  const double mean = sum / runs;
  const double deviation = std::sqrt(squares / runs - mean * mean);
  if (!(deviation > 0)) return std::nullopt;
  for (double& each : x) each = (each - mean) / deviation;
  const auto line = climb(levels, x);
  if (!line || !(line->b > 0)) return std::nullopt;
  return Fragility{std::exp(mean - deviation * line->a / line->b), deviation / line->b,
                   likelihood(levels, x, *line).value};
}

double probability(const Fragility& curve, double intensity) {
  return normal_cdf(std::log(intensity / curve.median) / curve.beta);
}

std::vector<RunGroup> single_runs(const std::vector<Level>& levels) {
  std::vector<RunGroup> groups;
  for (const Level& level : levels)
    for (std::size_t i = 0; i < level.runs; ++i)
      groups.push_back({{level.intensity, 1, i < level.toppled ? std::size_t{1} : std::size_t{0}}});
  return groups;
}

FragilityBounds::FragilityBounds(const Fragility& curve, const std::vector<RunGroup>& groups)
    : curve_(curve) {
  using Eigen::Matrix2d, Eigen::Vector2d;
  Matrix2d information = Matrix2d::Zero(), squares = Matrix2d::Zero();
  for (const RunGroup& group : groups) {
    Vector2d slope = Vector2d::Zero();
    for (const Level& level : group) {
      const double z = std::log(level.intensity / curve.median) / curve.beta, p = normal_cdf(z);
      if (!(p > 0 && p < 1)) continue;
      const auto runs = static_cast<double>(level.runs);
      // Slopes of z are −1/β along ln median and −z/β along β.
      const Vector2d rise = Vector2d(-1, -z) * (normal_density(z) / curve.beta);
      information += runs / (p * (1 - p)) * rise * rise.transpose();
      slope += (static_cast<double>(level.toppled) - runs * p) / (p * (1 - p)) * rise;
    }
    squares += slope * slope.transpose();
  }
  const auto count = static_cast<double>(groups.size());
  if (groups.size() > 1) reach_ = reach_of_interval(groups.size() - 1);
  const Matrix2d inverse = information.inverse();
  const Matrix2d covariance = count / (count - 1) * inverse * squares * inverse;
  variance_median_ = covariance(0, 0);
  variance_beta_ = covariance(1, 1);
  covariance_ = covariance(0, 1);
}

Bounds FragilityBounds::at(double intensity) const {
  const double z = std::log(intensity / curve_.median) / curve_.beta;
  const double variance = variance_median_ + 2 * z * covariance_ + z * z * variance_beta_;
  const double half = reach_ * std::sqrt(variance) / curve_.beta;
  return std::isfinite(variance) ? Bounds{normal_cdf(z - half), normal_cdf(z + half)} : Bounds{};
}

Bounds FragilityBounds::of_median() const {
  const double factor = std::exp(reach_ * std::sqrt(variance_median_));
  return {curve_.median / factor, curve_.median * factor};
}

}  // namespace rockstack
