#pragma once

#include "comparisons/measures/statistics/samples.hpp"

namespace rockstack::plots {

/// Points of a curve, times ascending.
struct Curve {
  std::vector<double> times;   ///< s
  std::vector<double> values;  ///< as many as times

  std::size_t size() const { return times.size(); }
  void add(double time, double value) { times.push_back(time), values.push_back(value); }
  /// The largest magnitude; 0 of no values.
  double largest() const { return largest_magnitude(values); }
};

/// Whether a curve lies on another wherever it has values: no further away than that share of the other's
/// extent. True where one has none.
bool lies_on(const Curve& curve, const Curve& other, double share);

/// The part of a curve that an axis shows up to `end`, with the point behind it, in fewer points: its time is
/// cut into `bins` equal bins and each keeps its smallest and its largest value at their own times, so that
/// no peak is hidden; the first and the last point stay. A part of at most 2 × bins points stays as it is.
/// Values that are not finite are dropped. Precondition: bins ≥ 1.
Curve thin(const Curve& curve, double end, std::size_t bins);

/// The part from another time on, with the sample before it.
Curve from_time(const Curve& curve, double begin);

/// The largest absolute value of each of `bins` equal bins of the time that an axis shows up to `end`, at its
/// own time, but not under `floor`: a logarithmic axis can show that of a curve that crosses zero.
/// Preconditions: bins ≥ 1, floor > 0.
Curve envelope(const Curve& curve, double end, std::size_t bins, double floor);

/// Path in fewer points, for curves that turn back: without those nearer than `tolerance` to the
/// line between the points kept around them, as a share of the curve's extent along either axis. Values that
/// are not finite are dropped. Precondition: tolerance > 0. (Ramer 1972, Douglas & Peucker 1973.)
Curve simplified(const Curve& curve, double tolerance);

}  // namespace rockstack::plots
