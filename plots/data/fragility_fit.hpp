#pragma once

#include <vector>

namespace rockstack::plots {

/// How many runs of one intensity were solved.
struct TestedLevel {
  double intensity = 0, runs = 0;
};

/// A lognormal curve fitted by maximum likelihood, with what the runs leave open: the covariance of ln median
/// and β by Fisher's information.
class FragilityFit {
 public:
  /// Preconditions: median > 0, β > 0.
  FragilityFit(double median, double beta, const std::vector<TestedLevel>& levels);

  double probability(double intensity) const;
  /// Bounds of the curve at an intensity with 95 % confidence; 0 and 1 where the runs fix none.
  double lower(double intensity) const { return bound(intensity, -1); }
  double upper(double intensity) const { return bound(intensity, 1); }
  /// Bounds of the median likewise.
  double median_lower() const;
  double median_upper() const;

 private:
  double bound(double intensity, double side) const;

  double log_median_, beta_;
  double variance_median_ = 0, variance_beta_ = 0, covariance_ = 0;
};

}  // namespace rockstack::plots
