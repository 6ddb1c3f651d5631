#pragma once

#include "analytic/scene/history.hpp"
#include "analytic/scene/input/json.hpp"
#include "analytic/scene/kinematics.hpp"
#include "analytic/scene/scene.hpp"

namespace rockstack {

/// What one interface has seen under a law that leaves pivots, from samples and events.
struct InterfaceSummary {
  double final_slip = 0;    ///< from the first sample to the last without flight, to the right positive, m
  double largest_slip = 0;  ///< absolute, likewise, m
  double highest_lift = 0;  ///< largest finite gap, m
  int slips = 0;            ///< events after which it slides and did not before
  int lift_offs = 0;        ///< events after which it is apart and was not before
};

/// One an interface, from the ground up; none under laws of pivots.
std::vector<InterfaceSummary> contact_summary(const History& history);

/// Whether its last event leaves all contacts closed, and nothing slides. On springs a stack moves on where
/// all its corners push.
bool ends_at_rest(const Scene& scene, const History& history);

/// An array of objects with the names above.
Json contact_json(const History& history);

/// What each interface has to bear, of a history that was solved with SolveOptions::validity: least normal
/// force (N) and impulse (N·s), largest ratio of tangential to normal, and when. Ratios that are infinite are
/// null.
Json validity_json(const History& history);

/// Demand of all interfaces, its own time left out: the least normal force or impulse, the most friction,
/// first times.
Demand worst_of(const std::vector<Demand>& demands);

/// One line for each interface and way in which real blocks would leave the model: it would have to pull, or
/// needs more friction than the scene has; and for what else makes an answer one of several: events in doubt,
/// openings to either side, impacts or modes that laws do not decide, springs that give way too far. Empty
/// where the model holds throughout.
std::vector<std::string> validity_warnings(const Scene& scene, const History& history);

/// What each interface carries from the block below to the block above at every sample, row by row; open
/// interfaces have no centre: there it is the pivot. Precondition: the history has patterns.
std::vector<Reaction> reactions_of(const Scene& scene, const History& history);

/// What an impact does, x and y a block: velocities of centres just before and after, m/s, and what each
/// interface gives to the block above, N·s.
struct Blow {
  Points<double> before, after, impulses;
};

/// Precondition: the event has the states on both its sides; `stack` is that of its scene.
Blow blow_of(const Stack<double>& stack, const Event& event);

/// Spring and dashpot of a block's corner.
struct CornerSpring {
  double stiffness = 0;  ///< N/m
  double damping = 0;    ///< N·s/m
};

/// ζ = c/(2√(km)) of a block that lands on that corner by itself: 1/m = 1/mass + (half width)²/inertia.
double damping_ratio(const CornerSpring& spring, const Block& block);

/// What is left of the speed with which one damped corner lands, as it leaves again: its force is cut at
/// zero and weight left out. From 1 for ζ = 0 down to 0; e⁻² for ζ = 1.
double restitution_of(double damping_ratio);

/// The scene on rigid contacts with Coulomb's friction, a coefficient for each interface: law `unilateral`.
Scene with_rigid_contacts(Scene scene, const std::vector<double>& friction);

/// Scene on springs at all corners, not loaded at the start, as engines place blocks: law `compliant`.
Scene with_springs(Scene scene, const std::vector<double>& friction, const CornerSpring& spring);

/// By how much that spring and dashpot have to be less, at the same relaxation time c/k, for the exact motion
/// to take about `most` steps; at least 1. Steps are 8 over the fastest rate of √tr M⁻¹K and tr M⁻¹C.
double spring_factor(const Scene& scene, const CornerSpring& spring, double most);

}  // namespace rockstack
