#pragma once

#include <fmt/core.h>

#include "comparisons/measures/results/sentences.hpp"
#include "plots/data/results.hpp"

namespace rockstack::plots {

/// A uniform block at rest that a rectangular pulse of horizontal acceleration a strikes, and in step with it
/// a vertical one of `vertical` times a, up positive.
struct StruckBlock {
  double slenderness_ratio = 0;  ///< r, height over width
  double gravity = 0;            ///< m/s²
  double vertical = 0;
};

/// The least friction coefficient with which a block of ratio r that a pulse of A times gravity tilts does
/// not slip: [A (4 + r²) + 3 r] / [1 + 4 r² + 3 A r]. Shenton 1996, Journal of Engineering Mechanics 122,
/// 690–693.
inline double rocking_friction(double slenderness_ratio, double push) {
  const double r = slenderness_ratio;
  return (push * (4 + r * r) + 3 * r) / (1 + 4 * r * r + 3 * push * r);
}

/// The boundaries between rest, slide, rock, slide-rock and free flight over a, in m/s², and friction, up to
/// either's largest value: gnuplot's lines of points, an empty one between lines. Vertical motion changes
/// gravity to g + `vertical` a.
std::string initiation_boundaries(const StruckBlock& block, double largest_acceleration,
                                  double largest_friction);

/// What figures of a sweep say beside their data.
struct SweepFacts {
  std::string title;
  std::string intensity;  ///< title of its axis
  /// Facts of a scene of one block, whose intensity is an acceleration: g tan α, m/s², and p, rad/s; else 0.
  double least_acceleration = 0, frequency_parameter = 0;
  std::optional<StruckBlock> struck = {};  ///< where a map over friction is of one under such pulses
  std::string decisive = {};               ///< which input decides most over the first outcome
  std::size_t cut_short = 0;               ///< runs that count as standing and whose ground moves on

  /// What that means, or nothing.
  std::string caution() const {
    return cut_short == 0 ? ""
                          : fmt::format("{} end while the ground moves on, and count as standing",
                                        counted(cut_short, "run"));
  }
};

/// From sweep.json. @throws InputError naming the file that is missing or malformed.
SweepFacts sweep_facts(const fs::path& results);

/// The end of an axis of peak angle over slenderness, and where on it blocks that topple are drawn.
inline constexpr double last_ratio = 1.2, edge = 1.14;

/// Room for a second axis along the upper edge of a panel, pixels.
inline constexpr double axis_above = 52;

/// A second axis, "x2" or "y2", opposite of "x" or "y" with its range, on which values are divided by `unit`;
/// nothing where that is 0.
std::string dimensionless_axis(const std::string& axis, double low, double high, double unit,
                               const std::string& words = "over g tan α");

}  // namespace rockstack::plots
