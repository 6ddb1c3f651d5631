#pragma once

#include <utility>

#include "analytic/scene/lists.hpp"
#include "comparisons/measures/metrics/impacts.hpp"

namespace rockstack {

/// The quantile of a share from 0, the least value, to 1, the greatest: straight lines between the values in
/// their order (definition 7 of Hyndman & Fan 1996, The American Statistician 50, 361; what NumPy and R do
/// unless told otherwise). The median of {1, 2, 3, 4} is 2.5. Between a finite and an infinite value lies the
/// infinite one. All quantiles and medians of the project are these. Precondition: there are values, and all
/// are numbers.
inline double quantile(std::vector<double> values, double share) {
  std::sort(values.begin(), values.end());
  const double place = share * static_cast<double>(values.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const double part = place - static_cast<double>(below), low = values[below];
  if (part == 0 || low == values[below + 1]) return low;
  return low + part * (values[below + 1] - low);
}

/// Half of the values lie on either side. Precondition: likewise.
inline double median(std::vector<double> values) {
  return quantile(std::move(values), 0.5);
}

/// The 97.5 % point of Student's distribution with that many degrees of freedom, > 0: an interval of 95 %
/// reaches so many standard deviations to either side.
double reach_of_interval(std::size_t freedom);

/// What one of many tests says.
struct TestChance {
  double p_value = 1;
  double least_p_value = 1;  ///< the least that its samples could have had, whatever the test says
};

/// Many tests at once.
struct AdjustedTests {
  std::vector<double> p_values;  ///< of each: the level from which on it is shown; 1 where it cannot be
  std::size_t counted = 0;       ///< tests that could show anything at the level
};

/// p-values for many tests, such that where nothing has changed the chance that any is at or below `level` is
/// at most `level`, however the tests hang together (S. Holm, "A simple sequentially rejective multiple test
/// procedure", Scand. J. Statist. 6, 1979). Tests whose samples could never reach their share of the level do
/// not count (R. E. Tarone, "A modified Bonferroni method for discrete data", Biometrics 46, 1990).
AdjustedTests adjust(const std::vector<TestChance>& tests, double level);

/// Which of many tests could show a change at a level over all of them, had each the least p-value of its
/// samples.
std::vector<bool> could_show(std::vector<TestChance> tests, double level);

/// Two samples compared by the Kolmogorov–Smirnov distance.
struct KolmogorovSmirnov {
  double distance = 0;  ///< the largest difference between both shares of values at or below any number
  double p_value = 1;   ///< the chance of that distance or more between samples of one distribution
  double critical = 0;  ///< the distance with a chance of 5 %
};

/// By the limiting distribution with the correction for small samples of M. A. Stephens, "Use of the
/// Kolmogorov–Smirnov, Cramér–von Mises and related statistics without extensive tables", J. Royal
/// Statistical Society B 32 (1970). Where values are tied, as counts are, the true chance is smaller.
/// Precondition: neither sample is empty.
KolmogorovSmirnov kolmogorov_smirnov(std::vector<double> first, std::vector<double> second);

/// Two samples compared by the ranks of their values: the p-value is the chance of a superiority as far from
/// one half, or further, on either side, and the least one that of any samples of these sizes and these
/// values in common.
struct MannWhitney : TestChance {
  double superiority = 0.5;  ///< share of pairs in which the second sample's value is the greater; ties half
};

/// The test of H. B. Mann & D. R. Whitney, "On a test of whether one of two random variables is
/// stochastically larger than the other", Ann. Math. Statist. 18 (1947). Equal values share their ranks. Up
/// to 50 values together the chance is exact, over all ways to share them out; of more it is the normal
/// limit, with the corrections for ties and for steps of one half. Twice the smaller tail, at most 1.
/// Precondition: neither sample is empty, no value is NaN.
MannWhitney mann_whitney(const std::vector<double>& first, const std::vector<double>& second);

/// Two samples of one stratum: what is compared within a scene and step, and nowhere else.
struct Stratum {
  std::vector<double> first, second;
};

/// Tests over several strata: ranks are those within each, and their sums are added up (Ph. van Elteren,
/// "On the combination of independent two-sample tests of Wilcoxon", Bull. Inst. Int. Statist. 37, 1960,
/// whose weights are one where strata are of one size). The superiority is a share of all pairs.
/// Precondition: at least one stratum, each as above.
MannWhitney mann_whitney(const std::vector<Stratum>& strata);

/// How many impacts match that have nothing to do with the exact motion: medians over draws.
struct ChanceMatches {
  int random = 0;   ///< the engine's impacts, each at a time drawn anew from the whole duration
  int shifted = 0;  ///< the engine's impacts, all of them later by the same time, drawn from a tenth of the
                    ///< duration to nine tenths; those that pass the end start over
};

/// Precondition: as many windows as exact impacts.
ChanceMatches chance_matches(const std::vector<ImpactTime>& exact, const std::vector<ImpactTime>& engine,
                             const std::vector<double>& windows, double duration);

}  // namespace rockstack
