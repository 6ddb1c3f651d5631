#pragma once

#include "analytic/scene/scene.hpp"
#include "comparisons/measures/metrics/difference.hpp"

namespace rockstack {

/// An impact as a comparison sees it.
struct ImpactTime {
  double time = 0;    ///< s
  int interface = 0;  ///< from 1
  /// The side to which the interface leaves: that of its relative angular velocity after the impact, closed
  /// where that is too slow to count.
  Contact side = Contact::closed;
  double approach = 0;  ///< speed at which the gap closes where it strikes, m/s
  bool lands = false;   ///< from flight, not by turning about a pivot
};

/// Speed below which an impact counts as chatter and is not compared, m/s for each metre of the interface's
/// width, rad/s where it rocks: 0.02 √(g/H), H the height of the stack. A flight that starts at this speed
/// stays below about 2e-4 rad.
double chatter_speed(const Scene& scene);

/// Width of the faces that meet at an interface, from 0, m.
double interface_width(const Scene& scene, std::size_t interface);

/// Speed at which the gap closes where an impact strikes, m/s: the one that the solver reports, or that of an
/// interface of this width which turns about its pivot.
double approach_speed(const Event& event, double width);

/// How long an interface must stay closed to have settled: 0.1 √(H/g), in s.
double settling_duration(const Scene& scene);

/// The side to which an interface leaves with a relative angular velocity (rad/s); closed below `slowest`.
Contact side_of(double velocity, double slowest);

/// Relative value at an interface from 0, its block's less that of the block below: of angles or of angular
/// velocities.
double relative_at(std::span<const double> values, std::size_t interface);

/// Those up to a time, s.
std::vector<ImpactTime> up_to(std::vector<ImpactTime> impacts, double time);

/// Whether an event is an impact: those that close an interface for good are.
bool is_impact(EventKind kind);

/// The impacts that a solver reported, whose gaps close at `slowest` times the interface's width or more,
/// as chatter_speed() counts it.
std::vector<ImpactTime> reported_impacts(const Scene& scene, const History& history, double slowest);

/// The impacts in sampled motion, at `slowest` times the width or more, likewise. Between two samples an
/// interface that is not in flight impacts where its relative angle approaches zero at the first, and has
/// passed it at the second (the time is interpolated), or would pass it within a step and the approach has
/// lost more than half its speed (the time is that of the first sample plus angle over speed). What flies
/// lands where its gap does so; engines may stop it above zero by what open_angle makes of the width. The
/// side is that of the sample after: engines that find contacts by overlap answer one step late.
std::vector<ImpactTime> observed_impacts(const Scene& scene, const History& history, double slowest);

/// Whether an interface, from 0, is apart at a sample by more than blocks may hover, and goes up or down; of
/// laws that leave pivots, and of motions that tell gaps.
bool flies(const Scene& scene, const History& history, std::size_t interface, std::size_t sample);

/// Time of the last landing of a block on its whole face up to a time, s: tilted by however little before, it
/// would have turned there.
std::optional<double> flat_landing(const History& history, double end);

/// How far apart the gaps of interfaces that close may be in two motions, m: by what their relative angles
/// differ across the width, and by how high they are where the first one flies.
/// @throws std::invalid_argument as difference().
Difference gap_difference(const Scene& scene, const History& first, const History& second);

/// The relative angle up to which an interface may count as closed, rad. What chatter below chatter_speed()
/// opens, and what engines let blocks sink in and lean, stays below it.
inline constexpr double open_angle = 2e-3;

/// When interfaces settle: an interface that has moved comes to stay within open_angle of closed, and slower
/// than chatter_speed(scene), for at least settling_duration(scene). All chatter of an interface is one
/// settling. In order of time.
std::vector<ImpactTime> settlings(const Scene& scene, const History& history);

/// Root of the mean square angular velocity of all blocks of `engine` over the last tenth of its time, rad/s;
/// nothing where `exact` is not at rest all that time. Precondition: the same times; `exact` knows its
/// patterns.
std::optional<double> residual_motion(const History& exact, const History& engine);

}  // namespace rockstack
