#pragma once

#include "tests/analytic/paper/impact.hpp"

namespace rockstack::paper {

// Section 3.2: impacts of a system that rocks in pattern 1a. Angles are those at the impact: θ1 = 0 where the
// base meets the ground, θ2 = θ1 where the blocks meet.

/// Angular momentum of a body about a point: IG θ̇ + (m vG) d, with d the signed distance of m vG. kg·m²/s.
double eq44(double inertia, double rate, double linear_momentum, double distance);

// Base and ground, to 2b.
Momentum eq47(const Geometry& q, const Angles& u);  ///< system about O1', before
Momentum eq48(const Geometry& q, const Angles& u);  ///< system about O1', after
Momentum eq50(const Geometry& q, const Angles& u);  ///< top about O2, before
Momentum eq51(const Geometry& q, const Angles& u);  ///< top about O2, after
double eq54(const Geometry& q, const Cs& c);        ///< A
double eq55(const Geometry& q, const Cs& c);        ///< B
double eq56(const Geometry& q, const Angles& u, Reading reading);
double eq57(const Geometry& q, const Angles& u);
double eq58(const Geometry& q, const Angles& u);
double eq59(const Geometry& q, const Angles& u);
double eq60(const Geometry& q, const Angles& u);
Cs eqs56_to_60(const Geometry& q, const Angles& u, Reading reading);
Solution eqs52_and_53(const Geometry& q, const Cs& c);

// Between the blocks, to 2a.
Momentum eq62(const Geometry& q, const Angles& u);                   ///< system about O1, before
Momentum eq63(const Geometry& q, const Angles& u, Reading reading);  ///< system about O1, after
Momentum eq65(const Geometry& q, const Angles& u);                   ///< top about O2', before
Momentum eq66(const Geometry& q, const Angles& u, Reading reading);  ///< top about O2', after
double eq69(const Geometry& q, const Es& e);                         ///< A
double eq70(const Geometry& q, const Es& e);                         ///< B
double eq71(const Geometry& q, const Es& e);                         ///< C
double eq72(const Geometry& q, const Es& e);                         ///< D
Es eqs73_to_79(const Geometry& q, const Angles& u);
Solution eqs67_and_68(const Geometry& q, const Es& e);

// Between the blocks, to 3a.
Momentum eq81(const Geometry& q, const Angles& u);                              ///< system about O1, before
Momentum eq82(const Geometry& q);                                               ///< system about O1, after
double eq83(const Geometry& q);                                                 ///< IO, kg·m²
double eq84(const Geometry& q, double B1, double B2, const Velocities& minus);  ///< θ̇1⁺ = θ̇2⁺
double eq85(const Geometry& q);                                                 ///< B1
double eq86(const Geometry& q, const Angles& u);                                ///< B2

}  // namespace rockstack::paper
