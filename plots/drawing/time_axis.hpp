#pragma once

#include <limits>
#include <string>
#include <vector>

#include "plots/data/results.hpp"
#include "plots/drawing/layout.hpp"

namespace rockstack::plots {

/// The time that the figures of a scene show: its motion, without the rest after it.
struct TimeAxis {
  double end = 0;  ///< s
  /// After it motions part by nature, s; infinite where they can be compared to the end.
  double horizon = std::numeric_limits<double>::infinity();

  /// Whether there is something beyond the horizon to be seen.
  bool is_shaded() const { return horizon < end; }
};

/// Up to when one of some motions still moves: until then an angle is further from where it ends than a small
/// part of what the first motion, the exact one where there is one, goes through.
TimeAxis time_axis(const ComparedScene& scene, const std::vector<Run>& runs);

/// The range of a panel over time, `room` times as long, with what lies beyond the horizon shaded.
std::string time_range(const TimeAxis& axis, double room = 1);

/// Adds what the shade means, where there is one.
void explain_shade(const TimeAxis& axis, Legend& legend);

}  // namespace rockstack::plots
