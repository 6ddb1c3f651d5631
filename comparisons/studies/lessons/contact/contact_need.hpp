#pragma once

#include <string>

#include "analytic/scene/scene.hpp"

namespace rockstack {

// Closed forms of a uniform block of height over width r, under Coulomb friction μ.

/// The least friction with which an impact from one corner to the other does not slip, 3 r/(1 + 4 r²).
double impact_friction(double r);

/// Angular velocity after that impact over that before: 1 − 1.5/(1 + r²) where it sticks, otherwise
/// (r² − 2 + 3 μ r)/(4 + r² − 3 μ r). Precondition: r² + 3 μ r > 2, or the block stays flat.
double impact_ratio(double r, double friction);

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
  double least_normal = 0;                          ///< N; negative: it would have to pull
  double force_friction = 0, impulse_friction = 0;  ///< infinite where nothing pushes
  double friction = 0;                              ///< that the scene has, at its smoothest interface
  // First times, infinite where it never comes to that, s.
  double first_pull = 0, first_force_slip = 0, first_impulse_slip = 0;
};

/// Solves the scene under `consistent`.
ContactNeed contact_need(Scene scene);

/// `consistent` where interfaces push and hold throughout, else `unilateral`.
Law law_for(const ContactNeed& need);

/// What comes first of what the law of pivots cannot do, in words, with its time; "nothing".
std::string first_failure(const ContactNeed& need);

}  // namespace rockstack
