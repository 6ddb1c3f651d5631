#pragma once

#include "engines/conformance/check.hpp"

namespace rockstack {

/// The constants of Housner 1963, of slender_block() unless given.
struct Housner {
  double slenderness = std::atan(0.2);                                ///< rad
  double frequency = std::sqrt(3 * 9.81 / (4 * std::hypot(0.2, 1)));  ///< p, 1/s

  /// Angular velocity at which a block released at `angle` meets the ground, rad/s.
  double speed_at_ground(double angle) const {
    return frequency * std::sqrt(2 * (std::cos(slenderness - angle) - std::cos(slenderness)));
  }
};

/// Time from release at `start` > 0, rad, to the ground: the energy integral of the full equation, s.
double quarter_period(const Housner& block, double start);

/// Time of the lowest block's first change of the angle's sign, linear between samples; not a number where
/// none comes. Precondition: the angle is not zero at the start.
double first_ground_impact(const History& history);

/// How far a constant push of `share` of gravity turns a block from rest in a time, rad: Housner's equation
/// to first order in the angle, θ̈ = start + growth θ. The next order is θ/2 of it.
double pushed_angle(const Housner& block, double share, double time);

}  // namespace rockstack
