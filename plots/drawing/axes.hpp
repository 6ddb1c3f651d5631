#pragma once

#include "plots/data/results.hpp"
#include "plots/drawing/layout.hpp"

namespace rockstack::plots {

/// Where values lie.
struct Extent {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();

  void add(double value) { low = std::min(low, value), high = std::max(high, value); }
  /// With room on a linear axis.
  Extent wider(double margin) const { return {low - margin, high + margin}; }
  /// With room on a logarithmic axis: a factor.
  Extent wider_times(double factor) const { return {low / factor, high * factor}; }
  /// Where a value is on a logarithmic axis of so many pixels.
  double place(double value, double pixels) const {
    return pixels * std::log(value / low) / std::log(high / low);
  }
};

/// Numbers along a logarithmic axis, "x", "x2" or "y", of that many pixels: powers of ten as there is room
/// for, or where there are fewer than three of them round multiples between.
std::string logarithmic_tics(const std::string& axis, double low, double high, double pixels);

/// Numbers along a linear axis, "x", "x2" or "y", of that many pixels: as many round ones as there is room
/// for; upwards those that would have exponents in units of a power of ten.
std::string linear_tics(const std::string& axis, double low, double high, double pixels);

/// A unit of angles, and how many of it are 1 rad.
struct AngleUnit {
  const char* name;
  double scale;
};

/// The unit of an axis up to a size, rad, that was asked for; of itself that in which small numbers need no
/// exponents.
AngleUnit angle_unit(double largest, PrintStyle::Unit asked = PrintStyle::Unit::automatic);

/// Curves in that unit.
void scale(std::vector<Curve>& curves, double by);

/// How many letters the longest of the numbers up a linear axis has.
std::size_t longest_tic(double low, double high, double pixels);

/// The range of an axis with its numbers, of either kind.
std::string linear_range(const std::string& axis, double low, double high, double pixels);
std::string logarithmic_range(const std::string& axis, double low, double high, double pixels);

/// The time that the figures of a scene show: its motion, without the rest after it.
struct TimeAxis {
  double end = 0;  ///< s
  /// After it motions diverge by nature, s; infinite where they can be compared to the end.
  double horizon = std::numeric_limits<double>::infinity();
  double begin = 0;  ///< s

  /// Whether there is something beyond the horizon to be seen.
  bool is_shaded() const { return horizon < end; }
};

/// Up to when one of some motions still moves: until then an angle is further from where it ends than a small
/// part of what the first motion, the exact one where there is one, goes through.
TimeAxis time_axis(const ComparedScene& scene, const std::vector<Run>& runs);

/// The part of a curve that an axis shows, in fewer points, as thin().
Curve thin(const Curve& curve, const TimeAxis& axis, std::size_t bins);

/// What lies beyond the horizon, shaded in a panel over time.
std::string shade_beyond(const TimeAxis& axis);

/// The range of a panel over time, `room` times as long, with what lies beyond the horizon shaded.
std::string time_range(const TimeAxis& axis, double room = 1);

/// Adds what the shade means, where there is one.
void explain_shade(const TimeAxis& axis, Legend& legend);

}  // namespace rockstack::plots
