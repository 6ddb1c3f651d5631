#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "analytic/scene/history.hpp"
#include "analytic/scene/scene.hpp"

namespace rockstack {

/// An impact as a comparison sees it.
struct ImpactTime {
  double time = 0;    ///< s
  int interface = 0;  ///< from 1
  /// The side to which the interface leaves: that of its relative angular velocity after the impact, closed
  /// where that is too slow to count.
  Contact side = Contact::closed;
  double approach = 0;  ///< relative angular speed before it, rad/s
};

/// Relative speed in rad/s below which an impact counts as chatter and is not compared: 0.02 √(g/H), H the
/// height of the stack. A flight that starts at this speed stays below about 2e-4 rad.
double chatter_speed(const Scene& scene);

/// How long an interface must stay closed to have settled: 0.1 √(H/g), in s.
double settling_duration(const Scene& scene);

/// The side to which an interface leaves with a relative angular velocity (rad/s); closed below `slowest`.
Contact side_of(double velocity, double slowest);

/// Of an interface from 0, what its block has less what the block below has: of angles or of angular
/// velocities.
double relative_at(std::span<const double> values, std::size_t interface);

/// Those up to a time, s.
std::vector<ImpactTime> up_to(std::vector<ImpactTime> impacts, double time);

/// The impacts that a solver reported, at `slowest` rad/s of relative speed or more.
std::vector<ImpactTime> reported_impacts(const History& history, double slowest);

/// The impacts in sampled motion, read from angles and angular velocities alone. Between two samples an
/// interface impacts where it approaches at `slowest` rad/s or more at the first, and its relative angle has
/// passed zero at the second (the time is interpolated), or would pass zero within a step and the approach
/// has lost more than half its speed (the time is that of the first sample plus angle over speed). Its side
/// is that of the sample after: engines that find contacts by overlap answer one step late.
std::vector<ImpactTime> observed_impacts(const History& history, double slowest);

}  // namespace rockstack
