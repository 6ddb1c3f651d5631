#pragma once

#include "tests/analytic/paper/geometry.hpp"

namespace rockstack::paper {

// Section 2.3, second half: the equations for small angles, with the geometry frozen upright: no term in θ or
// θ̇² is left. Each equation as its left side minus its right side, N·m per metre of depth. Of the angles only
// the signs are used.

double eq19(const Geometry& q, const Motion& s);                   ///< pattern 1, base
double eq20(const Geometry& q, const Motion& s);                   ///< pattern 1, top
double eq21(const Geometry& q, const Angles& u);                   ///< γ1L, rad
double eq22(const Geometry& q, const Motion& s, Reading reading);  ///< pattern 2, base
double eq23(const Geometry& q, const Motion& s, Reading reading);  ///< pattern 2, top
double eq24(const Geometry& q, const Angles& u, Reading reading);  ///< γ2L, rad
double eq25(const Geometry& q, const Motion& s);                   ///< pattern 3
double eq28(const Geometry& q, const Motion& s);                   ///< pattern 4

}  // namespace rockstack::paper
