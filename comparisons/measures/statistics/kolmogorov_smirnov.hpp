#pragma once

#include <cstddef>
#include <vector>

namespace rockstack {

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

}  // namespace rockstack
