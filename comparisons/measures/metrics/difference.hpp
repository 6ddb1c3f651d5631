#pragma once

#include <optional>
#include <vector>

#include "analytic/scene/history.hpp"

namespace rockstack {

/// Angle differences between two histories at the same times, over the time that both cover.
struct Difference {
  std::size_t blocks = 0;
  std::vector<double> times;   ///< s
  std::vector<double> angles;  ///< second minus first, rad, times.size() × blocks
};

/// @throws std::invalid_argument where the histories are of different stacks or their common times differ.
Difference difference(const History& first, const History& second);

/// Largest absolute difference of any block, rad.
double largest(const Difference& difference);

/// Root of the mean square over all samples and blocks, rad.
double root_mean_square(const Difference& difference);

/// The first time at which a block differs by more than `tolerance` rad; the last time where none does. s.
double agreement_time(const Difference& difference, double tolerance);

/// How far slips differ, m: of all interfaces that touch in the first history, at any time and at the last
/// common one.
struct SlipDifference {
  double largest = 0;
  std::optional<double> last;  ///< nothing where none touches then
};

/// Nothing where either history tells no slips.
/// @throws std::invalid_argument as difference().
std::optional<SlipDifference> slip_difference(const History& first, const History& second);

}  // namespace rockstack
