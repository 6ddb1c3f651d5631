#pragma once

#include "analytic/mechanics/impact.hpp"

namespace rockstack {

/// The energies of an impact, J.
struct ImpactEnergies {
  double before = 0;  ///< kinetic
  double after = 0;
  double jump = 0;  ///< kinetic energy of the change of velocity

  double share_lost() const { return 1 - after / before; }
};

/// Precondition: the event is an impact of that scene.
ImpactEnergies impact_energies(const Scene& scene, const Event& impact);

/// The state just before an impact, with its gaps closed.
Impact<double> impact_of(const Event& event);

// Two blocks that turn as one body and land on the ground: pattern 3a becomes 1b. Spanos et al. 2001,
// Eqs. (126)–(140). The print has the base's inertias where the top block's belong, in Eqs. (137) and (138).

/// Which of the two misprints to keep.
struct Misprints {
  bool eq137 = false, eq138 = false;
};

/// Angular velocities after the landing over that before; and kinetic energy after over before.
struct Landing {
  double base = 0, top = 0, energy = 0;
};

/// Precondition: two blocks, the upper one not wider.
Landing land(const Scene& scene, const Misprints& misprints);

/// The two blocks welded into one: their mass, common centre and inertia, on the base's width.
Block welded(const Scene& scene);

// Closed forms of a uniform block of height over width r, under Coulomb friction μ.

/// The least friction with which an impact from one corner to the other does not slip, 3 r/(1 + 4 r²).
double impact_friction(double r);

/// Angular velocity after that impact over that before: 1 − 1.5/(1 + r²) where it sticks, otherwise
/// (r² − 2 + 3 μ r)/(4 + r² − 3 μ r). Precondition: r² + 3 μ r > 2, or the block stays flat.
double impact_ratio(double r, double friction = largest_friction);

/// Impacts until an amplitude's energy has come down to a share, at a ratio of velocities q: q²ⁿ ≤ share.
double impacts_to_share(double share, double ratio);

/// A corner that slides to the right under a block that leans that way, as Painlevé's (Genot and Brogliato
/// 1999, European Journal of Mechanics A 18, 653–677): a normal force N ≥ 0 and Coulomb's friction μN give it
/// the acceleration free + slope N off the ground.
struct SlidingCorner {
  double free = 0;  ///< of the corner without force: ω² y − g, m/s², with y the height of the centre over it
  double slope = 0;  ///< 1/kg; negative where friction turns the corner into the ground
  /// The normal forces of motions that obey: 0 where the corner leaves, and the N that holds it, N.
  std::vector<double> forces() const;
};

/// Corner of the scene's single block at its initial angle, above 0, and velocity.
SlidingCorner sliding_corner(const Scene& scene);

/// The friction from which on the slope is negative, (I/m + x²)/(|x| y), where x and y lead from the corner
/// to the centre; (4 + r²)/(3 r) of a uniform upright block.
double jamming_friction(const Block& block, double angle);

/// Angular velocity of that block once an impulse at its corner has stopped the slip: moments about the
/// corner stay, ω + v y/(I/m + x² + y²), rad/s.
double rate_once_stuck(const Scene& scene);

/// A flat block on ground that one sine of vertical acceleration, amplitude A and period T, throws up. SI
/// units.
struct Throw {
  double lift_off = 0;       ///< where the ground falls with gravity: sin(2πt/T) = −g/A
  double lift_off_rate = 0;  ///< of the ground then, upwards
  double lift_off_rise = 0;  ///< of the ground until then
  double highest = 0;        ///< gap over the ground, which has stopped by then
  double landing = 0;        ///< where the parabola comes down to the ground
  double landing_rate = 0;   ///< downwards
};

/// @throws std::domain_error where the block does not lift off, or is not at its highest after the pulse.
Throw thrown_by_sine(double amplitude, double period, double gravity);

/// A block that slides from a speed v while it is thrown: friction acts with N, whose integral up to the end
/// of the landing is m g t whatever the ground did, as the block is at rest up and down before and after. SI
/// units.
struct Slide {
  double after_landing = 0;  ///< speed v − μ g t
  double stop = 0;           ///< time v/(μ g), as if it had never flown
  double distance = 0;
};

/// Precondition: it still slides after the landing.
Slide slide_through(const Throw& thrown, double speed, double friction, double gravity);

/// What a motion under law `consistent` asks of the worst of its interfaces.
struct ContactNeed {
  Demand force, impulse;  ///< worst_of() those of the motion, N, and of its impacts, N·s
  double friction = 0;    ///< that the scene has, at its smoothest interface

  /// Infinite where nothing would ever have to pull, s.
  double first_pull() const { return std::min(force.first_pull_time, impulse.first_pull_time); }
};

/// Solves the scene under `consistent`.
ContactNeed contact_need(Scene scene);

/// `consistent` where interfaces push and hold throughout, else `unilateral`.
Law law_for(const ContactNeed& need);

/// What comes first of what the law of pivots cannot do, in words, with its time; "nothing".
std::string first_failure(const ContactNeed& need);

}  // namespace rockstack
