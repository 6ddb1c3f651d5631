#include "plots/drawing/thinning.hpp"

#include <cassert>

namespace rockstack::plots {
namespace {

Curve pick(const Curve& curve, const std::vector<std::size_t>& indices) {
  Curve result;
  for (const std::size_t i : indices) result.add(curve.times[i], curve.values[i]);
  return result;
}

constexpr double endless = std::numeric_limits<double>::infinity();

/// The finite points up to an end, and the next one, to which a line leaves the axis.
Curve shown_points(const Curve& curve, double end) {
  std::vector<std::size_t> shown;
  for (std::size_t i = 0; i < curve.size(); ++i)
    if (std::isfinite(curve.values[i])) {
      shown.push_back(i);
      if (curve.times[i] > end) break;
    }
  return pick(curve, shown);
}

/// Calls `keep` with the range of the values of each bin that holds any.
template <class Keep>
void for_bins(const Curve& points, std::size_t bins, const Keep& keep) {
  const std::vector<double>& times = points.times;
  const auto bin_of = [&](std::size_t i) {
    const double span = times.back() - times.front();
    const double place = span > 0 ? (times[i] - times.front()) / span * static_cast<double>(bins) : 0;
    return place > 0 ? static_cast<std::size_t>(std::min(place, static_cast<double>(bins - 1))) : 0;
  };
  const double* const values = points.values.data();
  for (std::size_t begin = 0, end = 0; begin < points.size(); begin = end) {
    const std::size_t bin = bin_of(begin);
    while (end < points.size() && bin_of(end) == bin) ++end;
    keep(values + begin, values + end);
  }
}

/// In shares of the curve's extent.
Curve scaled(Curve curve) {
  for (std::vector<double>* values : {&curve.times, &curve.values}) {
    const auto [low, high] = std::ranges::minmax_element(*values);
    const double extent = *high - *low, share = extent > 0 ? 1 / extent : 0;
    for (double& value : *values) value *= share;
  }
  return curve;
}

/// Distance of a point from the line between two others.
double distance(const Curve& points, std::size_t of, std::size_t from, std::size_t to) {
  const std::vector<double>&x = points.times, &y = points.values;
  const double dx = x[to] - x[from], dy = y[to] - y[from], length_squared = dx * dx + dy * dy;
  const double along =
      length_squared > 0
          ? std::clamp(((x[of] - x[from]) * dx + (y[of] - y[from]) * dy) / length_squared, 0.0, 1.0)
          : 0;
  return std::hypot(x[of] - x[from] - along * dx, y[of] - y[from] - along * dy);
}

/// On a straight line between points. Precondition: there are some.
double value_at(const Curve& curve, double time) {
  const auto after = std::ranges::upper_bound(curve.times, time);
  if (after == curve.times.begin()) return curve.values.front();
  if (after == curve.times.end()) return curve.values.back();
  const auto i = static_cast<std::size_t>(after - curve.times.begin());
  const double part = (time - curve.times[i - 1]) / (curve.times[i] - curve.times[i - 1]);
  return std::lerp(curve.values[i - 1], curve.values[i], part);
}

}  // namespace

bool lies_on(const Curve& curve, const Curve& other, double share) {
  if (curve.size() == 0 || other.size() == 0) return true;
  const auto [low, high] = std::ranges::minmax_element(other.values);
  const double room = share * (*high - *low);
  for (std::size_t i = 0; i < curve.size(); ++i)
    if (!(std::abs(curve.values[i] - value_at(other, curve.times[i])) <= room)) return false;
  return true;
}

Curve thin(const Curve& curve, double end, std::size_t bins) {
  assert(bins >= 1 && curve.times.size() == curve.values.size());
  Curve points = shown_points(curve, end);
  if (points.size() <= 2 * bins) return points;
  std::vector<std::size_t> kept{0};
  for_bins(points, bins, [&](const double* first, const double* past) {
    const auto [low, high] = std::minmax_element(first, past);
    for (const double* found : {std::min(low, high), std::max(low, high)})
      kept.push_back(static_cast<std::size_t>(found - points.values.data()));
  });
  kept.push_back(points.size() - 1);
  kept.erase(std::unique(kept.begin(), kept.end()), kept.end());
  return pick(points, kept);
}

Curve simplified(const Curve& curve, double tolerance) {
  assert(tolerance > 0 && curve.times.size() == curve.values.size());
  Curve points = shown_points(curve, endless);
  if (points.size() < 3) return points;
  const Curve shares = scaled(points);
  std::vector<std::size_t> kept{0, points.size() - 1};
  std::vector<std::pair<std::size_t, std::size_t>> open{{0, points.size() - 1}};
  while (!open.empty()) {
    const auto [first, last] = open.back();
    open.pop_back();
    double furthest = tolerance;
    std::size_t at = first;
    for (std::size_t i = first + 1; i < last; ++i)
      if (const double away = distance(shares, i, first, last); away > furthest) furthest = away, at = i;
    if (at == first) continue;
    kept.push_back(at);
    open.emplace_back(first, at);
    open.emplace_back(at, last);
  }
  std::ranges::sort(kept);
  return pick(points, kept);
}

Curve from_time(const Curve& curve, double begin) {
  const auto after = std::ranges::upper_bound(curve.times, begin) - curve.times.begin();
  const auto skipped = std::max<std::ptrdiff_t>(after - 1, 0);
  return {{curve.times.begin() + skipped, curve.times.end()},
          {curve.values.begin() + skipped, curve.values.end()}};
}

Curve envelope(const Curve& curve, double end, std::size_t bins, double floor) {
  assert(bins >= 1 && floor > 0 && curve.times.size() == curve.values.size());
  Curve points = shown_points(curve, end);
  for (double& value : points.values) value = std::max(std::abs(value), floor);
  std::vector<std::size_t> kept;
  for_bins(points, bins, [&](const double* first, const double* past) {
    kept.push_back(static_cast<std::size_t>(std::max_element(first, past) - points.values.data()));
  });
  return pick(points, kept);
}

}  // namespace rockstack::plots
