#pragma once

#include <string>

namespace rockstack::plots {

/// A scale that is linear up to 10^first and logarithmic beyond, on both sides of zero; one unit a power of
/// ten.
struct SignedLog {
  int first = -6;
  int last = 0;

  double place(double value) const;
  double edge() const { return last - first + 1.5; }  ///< of the axis, on either side

  /// For "set ytics (…)" of a panel that is so many pixels high: as many powers as there is room for.
  std::string tics(double height) const;
};

/// The scale that shows values whose absolute values lie between `low` and `high`; at most eight decades.
SignedLog signed_log(double low, double high);

/// Numbers along a logarithmic axis, "x" or "y", of that many pixels: powers of ten as there is room for, or
/// where there are fewer than three of them round multiples between.
std::string logarithmic_tics(const std::string& axis, double low, double high, double pixels);

/// Numbers along a linear axis, "x" or "y", of that many pixels: as many round ones as there is room for.
std::string linear_tics(const std::string& axis, double low, double high, double pixels);

/// The range of an axis with its numbers, of either kind.
std::string linear_range(const std::string& axis, double low, double high, double pixels);
std::string logarithmic_range(const std::string& axis, double low, double high, double pixels);

}  // namespace rockstack::plots
