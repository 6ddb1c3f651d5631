#pragma once

#include "tests/analytic/paper/impact.hpp"

namespace rockstack::paper {

// Section 3.3: impacts of a system that rocks in pattern 2a. Angles are those at the impact: θ1 = 0 where the
// base meets the ground, θ2 = θ1 where the blocks meet.

// Base and ground, to 1b.
Momentum eq88(const Geometry& q, const Angles& u);                   ///< system about O1', before
Momentum eq89(const Geometry& q, const Angles& u);                   ///< system about O1', after
Momentum eq91(const Geometry& q, const Angles& u);                   ///< top about O2', before
Momentum eq92(const Geometry& q, const Angles& u, Reading reading);  ///< top about O2', after
double eq95(const Geometry& q, const Es& e);                         ///< A
double eq96(const Geometry& q, const Es& e);                         ///< B
double eq97(const Geometry& q, const Es& e);                         ///< C
double eq98(const Geometry& q, const Es& e);                         ///< D
double eq99(const Geometry& q, const Angles& u, Reading reading);
double eq104(const Geometry& q, const Angles& u, Reading reading);
/// E1 … E6, each in its own reading only where that is printed wrong: (99) and (104).
Es eqs99_to_104(const Geometry& q, const Angles& u, Reading reading);
Solution eqs93_and_94(const Geometry& q, const Es& e);

/// ζ of Section 3.3.2. The text does not define it. Corrected: the slope of the line from O1 to G2 against
/// the ground, counter-clockwise from the right, at the impact. Printed: ζ as Section 3.2.2 needs it.
double zeta(const Geometry& q, const Angles& u, Reading reading);

// Between the blocks, to 1a.
Momentum eq106(const Geometry& q, const Angles& u, Reading reading);  ///< system about O1, before
Momentum eq107(const Geometry& q, const Angles& u, Reading reading);  ///< system about O1, after
Momentum eq109(const Geometry& q, const Angles& u, Reading reading);  ///< top about O2, before
Momentum eq110(const Geometry& q, const Angles& u, Reading reading);  ///< top about O2, after
/// θ̇2's coefficient in Eq. (107), on which Eqs. (113)–(116) rest.
double top_after(const Geometry& q, const Angles& u, Reading reading);
double eq113(const Geometry& q, const Es& e, double coefficient);  ///< A
double eq114(const Geometry& q, const Es& e, double coefficient);  ///< B
double eq115(const Geometry& q, const Es& e, double coefficient);  ///< C
double eq116(const Geometry& q, const Es& e, double coefficient);  ///< D
/// E1 … E6; E7 is not used.
Es eqs117_to_122(const Geometry& q, const Angles& u, Reading reading);
Solution eqs111_and_112(const Geometry& q, const Es& e, double coefficient);

// Between the blocks, to 3a.
Momentum eq124(const Geometry& q, const Angles& u, Reading reading);  ///< system about O1, before
Momentum eq125(const Geometry& q);                                    ///< system about O1, after

}  // namespace rockstack::paper
