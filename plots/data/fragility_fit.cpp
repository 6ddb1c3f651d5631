#include "plots/data/fragility_fit.hpp"

#include <cmath>
#include <numbers>

namespace rockstack::plots {
namespace {

constexpr double two_sided = 1.959964;  // quantile of 97.5 %

double cumulative(double z) {
  return 0.5 * std::erfc(-z / std::numbers::sqrt2);
}

double density(double z) {
  return std::exp(-z * z / 2) / std::sqrt(2 * std::numbers::pi);
}

}  // namespace

FragilityFit::FragilityFit(double median, double beta, const std::vector<TestedLevel>& levels)
    : log_median_(std::log(median)), beta_(beta) {
  // Of z = (ln x − ln median)/β the slopes are −1/β along ln median and −z/β along β.
  double along_median = 0, along_beta = 0, mixed = 0;
  for (const TestedLevel& level : levels) {
    const double z = (std::log(level.intensity) - log_median_) / beta_;
    const double p = cumulative(z);
    if (!(p > 0 && p < 1)) continue;
    const double weight = level.runs * density(z) * density(z) / (p * (1 - p)) / (beta_ * beta_);
    along_median += weight;
    along_beta += weight * z * z;
    mixed += weight * z;
  }
  const double determinant = along_median * along_beta - mixed * mixed;
  variance_median_ = along_beta / determinant;
  variance_beta_ = along_median / determinant;
  covariance_ = -mixed / determinant;
}

double FragilityFit::probability(double intensity) const {
  return cumulative((std::log(intensity) - log_median_) / beta_);
}

double FragilityFit::median_lower() const {
  return std::exp(log_median_ - two_sided * std::sqrt(variance_median_));
}

double FragilityFit::median_upper() const {
  return std::exp(log_median_ + two_sided * std::sqrt(variance_median_));
}

double FragilityFit::bound(double intensity, double side) const {
  const double z = (std::log(intensity) - log_median_) / beta_;
  const double variance = (variance_median_ + 2 * z * covariance_ + z * z * variance_beta_) / (beta_ * beta_);
  if (!std::isfinite(variance)) return side < 0 ? 0 : 1;
  return cumulative(z + side * two_sided * std::sqrt(variance));
}

}  // namespace rockstack::plots
