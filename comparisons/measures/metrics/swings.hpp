#pragma once

#include <vector>

#include "analytic/scene/history.hpp"

namespace rockstack {

/// The angle of a block (from 0) at any time, by the straight line between samples, rad; past the end, that
/// line goes on. Precondition: at least two samples.
double angle_at(const History& history, std::size_t block, double time);

/// One swing of a block between two changes of side.
struct Swing {
  double end = 0;        ///< s; 0 for the last
  double peak = 0;       ///< largest absolute angle, rad
  double peak_time = 0;  ///< s
};

/// All swings of a block (from 0) in order.
std::vector<Swing> swings(const History& history, std::size_t block);

/// The one with the largest peak.
Swing largest_swing(const History& history, std::size_t block);

}  // namespace rockstack
