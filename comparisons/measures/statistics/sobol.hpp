#pragma once

#include <vector>

namespace rockstack {

/// The outcomes of one row of Saltelli's design: of two independent draws a and b of all inputs, and for each
/// input of a with that input's value from b.
struct SobolSample {
  double a = 0, b = 0;
  std::vector<double> exchanged;
};

/// A share of an outcome's variance, with its bounds of 95 %.
struct VarianceShare {
  double value = 0, lower = 0, upper = 0;
};

/// The Sobol indices of an input: `first` is the share of the outcome's variance that goes when this input
/// alone is known, `total` the share that remains while all others are known.
struct SobolIndices {
  VarianceShare first, total;
};

/// The standard deviation of all a and b; NaN where there is no row.
double deviation(const std::vector<SobolSample>& samples);

/// The indices of each input, with V the variance of all a and b: the first by the estimator of Saltelli et
/// al. 2010 (Computer Physics Communications 181, 259–270, Table 2 b), the total by that of Jansen 1999
/// (ibid. 117, 35–43). Either is a ratio of two means over the rows; its bounds are those of the delta
/// method, with Student's t, where rows are independent of each other, and wider than need be where they are
/// a Latin hypercube. They may pass 0 and 1, as estimates may. An input that changed no outcome has indices
/// of 0 with bounds of 0. All are NaN where all a and b are equal, there are fewer than two rows,
/// or V is not known, its own bounds reaching nought: as where a handful of hundreds of runs topple.
/// Precondition: rows have so many inputs.
std::vector<SobolIndices> sobol_indices(const std::vector<SobolSample>& samples, std::size_t inputs);

}  // namespace rockstack
