#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace rockstack {

/// The runs at one level of intensity.
struct Level {
  double intensity = 0;
  std::size_t runs = 0;  ///< without those that failed
  std::size_t toppled = 0;
  std::size_t failed = 0;
};

/// Limits of a probability.
struct Bounds {
  double lower = 0, upper = 1;
};

/// The 95 % confidence interval of Wilson 1927 (Journal of the American Statistical Association 22, 209–212)
/// for a probability of which `hits` of `trials` are known; from 0 to 1 where trials = 0.
Bounds wilson_bounds(std::size_t hits, std::size_t trials);

/// The probability Φ(ln(x/median)/beta) of toppling at intensity x.
struct Fragility {
  double median = 0;  ///< in the intensity's unit
  double beta = 0;    ///< standard deviation of the logarithm
  double log_likelihood = 0;
};

/// The curve of greatest likelihood (Baker 2015, Earthquake Spectra 31, 579–599). None where there is none:
/// where one intensity parts all that topple from all that do not, toppling does not grow with intensity, or
/// an intensity is negative, or zero and some topple. At zero none topples of any curve.
std::optional<Fragility> fit_fragility(const std::vector<Level>& all);

double probability(const Fragility& curve, double intensity);

/// Runs that depend on each other, as those of one motion that is scaled up; runs of other groups do not.
using RunGroup = std::vector<Level>;

/// Each run by itself.
std::vector<RunGroup> single_runs(const std::vector<Level>& levels);

/// What the runs leave open of a fitted curve, with 95 % confidence: by the covariance of ln median and β,
/// A⁻¹BA⁻¹ with A Fisher's information and B the sum over groups of the squares of their slopes of the
/// likelihood, times G/(G − 1) of G groups (Liang & Zeger 1986, Biometrika 73, 13–22). Precondition: median
/// and β > 0.
class FragilityBounds {
 public:
  FragilityBounds(const Fragility& curve, const std::vector<RunGroup>& groups);

  /// Bounds of the curve at an intensity; 0 and 1 where the runs fix none.
  Bounds at(double intensity) const;
  Bounds of_median() const;

 private:
  Fragility curve_;
  double variance_median_ = 0, variance_beta_ = 0, covariance_ = 0;
  double reach_ = 0;  ///< of an interval, in standard errors: Student's t of G − 1
};

}  // namespace rockstack
