#pragma once

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

/// Whether an event is an impact: those that close an interface for good are.
bool is_impact(EventKind kind);

/// The impacts that a solver reported, at `slowest` rad/s of relative speed or more.
std::vector<ImpactTime> reported_impacts(const History& history, double slowest);

/// The impacts in sampled motion, read from angles and angular velocities alone. Between two samples an
/// interface impacts where it approaches at `slowest` rad/s or more at the first, and its relative angle has
/// passed zero at the second (the time is interpolated), or would pass zero within a step and the approach
/// has lost more than half its speed (the time is that of the first sample plus angle over speed). Its side
/// is that of the sample after: engines that find contacts by overlap answer one step late.
std::vector<ImpactTime> observed_impacts(const History& history, double slowest);

// The patterns of sampled motion, read from angles alone, so that engines and the exact solution are judged
// alike.

/// The relative angle up to which an interface may count as closed, rad. What chatter below chatter_speed()
/// opens, and what engines let blocks sink in and lean, stays below it.
inline constexpr double open_angle = 2e-3;

/// The pattern at each sample. An interface is closed where it stays within open_angle for at least
/// settling_duration(scene), and at the history's ends; in shorter stretches it changes sides as its relative
/// angle reaches the other side, or stays on the one that it comes back to.
std::vector<Pattern> sampled_patterns(const Scene& scene, const History& history);

/// Share of time that both histories spend in a pair of patterns.
struct PatternShare {
  Pattern exact, engine;
  double share = 0;  ///< of 1
};

/// All pairs that occur in patterns at the same times (s), in the order in which they first do.
/// Precondition: at least one sample.
std::vector<PatternShare> pattern_shares(const std::vector<double>& times, const std::vector<Pattern>& exact,
                                         const std::vector<Pattern>& engine);

/// The share of time in which both are equal.
double agreement(const std::vector<PatternShare>& shares);

/// The time until which two histories pass through the same patterns in the same order: the earlier of both
/// times at which the first patterns begin that differ, the last time where none do. s.
double sequence_time(const std::vector<double>& times, const std::vector<Pattern>& exact,
                     const std::vector<Pattern>& engine);

/// When interfaces settle: an interface that has moved comes to stay within open_angle of closed, and slower
/// than chatter_speed(scene), for at least settling_duration(scene). All chatter of an interface is one
/// settling. In order of time.
std::vector<ImpactTime> settlings(const Scene& scene, const History& history);

/// Root of the mean square angular velocity of all blocks of `engine` over the last tenth of its time, rad/s;
/// nothing where `exact` is not at rest all that time. Precondition: the same times; `exact` knows its
/// patterns.
std::optional<double> residual_motion(const History& exact, const History& engine);

}  // namespace rockstack
