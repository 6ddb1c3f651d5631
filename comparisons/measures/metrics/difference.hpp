#pragma once

#include <optional>
#include <vector>

#include "analytic/scene/history.hpp"

namespace rockstack {

/// What two histories differ by at the same times, over the time that both cover: angles, or places of
/// centres.
struct Difference {
  std::size_t blocks = 0;
  std::vector<double> times;   ///< s
  std::vector<double> values;  ///< second minus first, rad; or distances, m; times.size() × blocks
};

/// Of angles. @throws std::invalid_argument where the histories are of different stacks or their common times
/// differ.
Difference difference(const History& first, const History& second);

/// The samples of a difference up to a time, s, the first one in any case.
Difference up_to(Difference difference, double time);

/// Those of a history, and its events.
History up_to(History history, double time);

/// Largest absolute difference of any block.
double largest(const Difference& difference);

/// Root of the mean square over all samples and blocks.
double root_mean_square(const Difference& difference);

/// The first time at which a block differs by more than `tolerance`; the last time where none does. s.
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
