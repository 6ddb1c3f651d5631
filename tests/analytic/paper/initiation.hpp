#pragma once

#include "tests/analytic/paper/geometry.hpp"

namespace rockstack::paper {

// Section 2.2: how a stack at rest starts to rock. Each inequality as its left side minus its right side,
// m²/s²; it holds where that is positive.

double eq1(const Geometry& q, const Motion& s);  ///< rest to 3a
double eq2(const Geometry& q);                   ///< height of the common centre of mass, m
double eq3(const Geometry& q, const Motion& s);  ///< rest to 3b
double eq4(const Geometry& q, const Motion& s);  ///< rest to 4a
double eq5(const Geometry& q, const Motion& s);  ///< rest to 4b

}  // namespace rockstack::paper
