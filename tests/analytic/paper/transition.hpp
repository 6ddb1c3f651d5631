#pragma once

#include "tests/analytic/paper/geometry.hpp"

namespace rockstack::paper {

// Section 2.4: an interface opens without an impact. Each inequality as its left side minus its right side;
// it holds where that is positive. Eqs. (29)–(34) in m/s² with θ1 the angle of both blocks; Eqs. (35)–(40) in
// N·m per metre of depth, the base at rest.

double eq29(const Geometry& q, const Motion& s);                   ///< 3a to 1a
double eq30(const Geometry& q);                                    ///< d, m
double eq32(const Geometry& q, const Motion& s, Reading reading);  ///< 3a to 2a
double eq33(const Geometry& q, const Motion& s, Reading reading);  ///< 3b to 1b
double eq34(const Geometry& q, const Motion& s, Reading reading);  ///< 3b to 2b
double eq35(const Geometry& q, const Motion& s, Reading reading);  ///< 4a to 1a
double eq37(const Geometry& q, const Motion& s, Reading reading);  ///< 4b to 1b
double eq38(const Geometry& q, const Motion& s, Reading reading);  ///< 4b to 2a
double eq40(const Geometry& q, const Motion& s, Reading reading);  ///< 4a to 2b

}  // namespace rockstack::paper
