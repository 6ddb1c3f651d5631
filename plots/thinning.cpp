#include "plots/thinning.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace rockstack::plots {
namespace {

Curve finite_points(const Curve& curve) {
  Curve result;
  for (std::size_t i = 0; i < curve.size(); ++i) {
    if (!std::isfinite(curve.values[i])) continue;
    result.times.push_back(curve.times[i]);
    result.values.push_back(curve.values[i]);
  }
  return result;
}

/// Index of the first point of each bin that holds any, and the number of points at the end.
std::vector<std::size_t> bin_starts(const std::vector<double>& times, std::size_t bins) {
  std::vector<std::size_t> starts;
  if (times.empty()) return starts;
  const double span = times.back() - times.front();
  std::size_t current = bins;
  for (std::size_t i = 0; i < times.size(); ++i) {
    const double place = span > 0 ? (times[i] - times.front()) / span * static_cast<double>(bins) : 0;
    const std::size_t bin = std::min(static_cast<std::size_t>(place), bins - 1);
    if (bin != current) starts.push_back(i);
    current = bin;
  }
  starts.push_back(times.size());
  return starts;
}

Curve pick(const Curve& curve, const std::vector<std::size_t>& indices) {
  Curve result;
  for (const std::size_t i : indices) {
    result.times.push_back(curve.times[i]);
    result.values.push_back(curve.values[i]);
  }
  return result;
}

std::size_t index_in(const std::vector<double>& values, std::vector<double>::const_iterator found) {
  return static_cast<std::size_t>(found - values.begin());
}

}  // namespace

Curve thin(const Curve& curve, std::size_t bins) {
  assert(bins >= 1 && curve.times.size() == curve.values.size());
  Curve points = finite_points(curve);
  if (points.size() <= 2 * bins) return points;
  const std::vector<std::size_t> starts = bin_starts(points.times, bins);
  std::vector<std::size_t> kept{0};
  for (std::size_t bin = 0; bin + 1 < starts.size(); ++bin) {
    const auto begin = points.values.begin();
    const auto [low, high] = std::minmax_element(begin + static_cast<std::ptrdiff_t>(starts[bin]),
                                                 begin + static_cast<std::ptrdiff_t>(starts[bin + 1]));
    kept.push_back(index_in(points.values, std::min(low, high)));
    kept.push_back(index_in(points.values, std::max(low, high)));
  }
  kept.push_back(points.size() - 1);
  kept.erase(std::unique(kept.begin(), kept.end()), kept.end());
  return pick(points, kept);
}

Curve envelope(const Curve& curve, std::size_t bins, double floor) {
  assert(bins >= 1 && floor > 0 && curve.times.size() == curve.values.size());
  Curve points = finite_points(curve);
  for (double& value : points.values) value = std::max(std::abs(value), floor);
  const std::vector<std::size_t> starts = bin_starts(points.times, bins);
  std::vector<std::size_t> kept;
  for (std::size_t bin = 0; bin + 1 < starts.size(); ++bin) {
    const auto begin = points.values.begin();
    kept.push_back(
        index_in(points.values, std::max_element(begin + static_cast<std::ptrdiff_t>(starts[bin]),
                                                 begin + static_cast<std::ptrdiff_t>(starts[bin + 1]))));
  }
  return pick(points, kept);
}

}  // namespace rockstack::plots
