#pragma once

#include <vector>

namespace rockstack {

/// Two samples compared by the ranks of their values.
struct MannWhitney {
  double superiority = 0.5;  ///< share of pairs in which the second sample's value is the greater; ties half
  double p_value = 1;        ///< the chance of a superiority as far from one half, or further, on either side
  double least_p_value = 1;  ///< of any samples of these sizes and these values in common
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

/// The same over several strata: ranks are those within each, and their sums are added up (Ph. van Elteren,
/// "On the combination of independent two-sample tests of Wilcoxon", Bull. Inst. Int. Statist. 37, 1960,
/// whose weights are one where strata are of one size). The superiority is a share of all pairs.
/// Precondition: at least one stratum, each as above.
MannWhitney mann_whitney(const std::vector<Stratum>& strata);

}  // namespace rockstack
