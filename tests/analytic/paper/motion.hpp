#pragma once

#include "tests/analytic/paper/geometry.hpp"

namespace rockstack::paper {

// Section 2.3, first half: the full equations of motion. Each equation as its left side minus its right side,
// N·m per metre of depth; it holds where that is zero. γ1 and γ2 in rad.

double eq6(const Geometry& q, const double (&centre_speed)[2],
           const Velocities& velocity);                                     ///< kinetic energy, J
double eq7(const Geometry& q, const double (&centre_height)[2], double g);  ///< potential energy, J

double eq8(const Geometry& q, const Motion& s, Reading reading);   ///< pattern 1, base
double eq9(const Geometry& q, const Motion& s, Reading reading);   ///< pattern 1, top
double eq10(const Geometry& q, const Angles& u);                   ///< γ1
double eq12(const Geometry& q, const Motion& s);                   ///< pattern 2, base
double eq13(const Geometry& q, const Motion& s, Reading reading);  ///< pattern 2, top
double eq14(const Geometry& q, const Angles& u);                   ///< γ2
double eq15(const Geometry& q, const Motion& s);                   ///< pattern 3
double eq18(const Geometry& q, const Motion& s);                   ///< pattern 4

}  // namespace rockstack::paper
