#pragma once

#include "tests/analytic/paper/impact.hpp"

namespace rockstack::paper {

// Section 4.1: pattern 3a hits the ground, θ1 = θ2 = 0. The system turns as one before: only θ̇1⁻ occurs.

// To 1b.
Momentum eq127(const Geometry& q);                   ///< system about O1', before
Momentum eq128(const Geometry& q, Reading reading);  ///< system about O1', after
Momentum eq130(const Geometry& q, Reading reading);  ///< top about O2', before
Momentum eq131(const Geometry& q);                   ///< top about O2', after
double eq134(const Geometry& q, const Cs& c);        ///< A
double eq135(const Geometry& q, const Cs& c);        ///< B
Cs eqs136_to_140(const Geometry& q, Reading reading);
Solution eqs132_and_133(const Geometry& q, const Cs& c);

// To 3b.
Momentum eq142(const Geometry& q);               ///< system about O1', before
Momentum eq143(const Geometry& q);               ///< system about O1', after
double eq144(const Geometry& q, double before);  ///< θ̇1⁺ = θ̇2⁺, rad/s

// Section 4.2: the top block of pattern 4a falls back onto the base at rest, θ1 = θ2 = 0. Only θ̇2⁻ occurs.

// To 1b.
Momentum eq146(const Geometry& q);                   ///< system about O1', before
Momentum eq147(const Geometry& q);                   ///< system about O1', after
Momentum eq149(const Geometry& q);                   ///< top about O2', before
Momentum eq150(const Geometry& q, Reading reading);  ///< top about O2', after
double eq153(const Geometry& q, const Cs& c);        ///< A
double eq154(const Geometry& q, const Cs& c);        ///< B
/// C1 … C5; θ2, which Eq. (156) prints for θc2, is zero at the impact.
Cs eqs155_to_159(const Geometry& q, Reading reading);
Solution eqs151_and_152(const Geometry& q, const Cs& c);

// To 4b.
Momentum eq161(const Geometry& q);               ///< top about O2', before
Momentum eq162(const Geometry& q);               ///< top about O2', after
double eq163(const Geometry& q, double before);  ///< θ̇2⁺, rad/s

}  // namespace rockstack::paper
