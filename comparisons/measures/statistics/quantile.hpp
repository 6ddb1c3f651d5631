#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

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

}  // namespace rockstack
