#pragma once

#include "tests/analytic/proof/step.hpp"

namespace rockstack::proof {

// Infinitely many impacts of one interface k in a finite time, as one step of a proof. After an impact it
// leaves at the speed u. A box holds relative angles and rates of the other open interfaces within aⱼ and bⱼ
// of now, |φₖ| ≤ ρ, |φ̇ₖ| ≤ V, and times up to T from now. If anywhere in it, for either side σ,
//
//   (i)   −σφ̈ₖ is in [a̲, ā], a̲ > 0: a flight comes back;
//   (ii)  closed interfaces keep both margins > 0, open ones their sides, and no block topples;
//   (iii) an impact throws k alone to its other side, with η of its closing speed;
//
// and, with q = η r, r in [√(a̲/ā), √(ā/a̲)] the ratio of the speeds at both ends of a flight, 1 of one side
// and 2 of the other,
//
//   (iv)  q₁ q₂ < 1;
//   (v)   T* = 2u (1/a₁ + q₁/a₂) / (1 − q₁ q₂) < T, and what changes in T* stays strictly inside the box,
//
// then impacts of k accumulate at T* from now, where φₖ = φ̇ₖ = 0. For the others let ζ = φ̇ₒ + C φ̇ₖ, with C =
// Mₒₒ⁻¹ Mₒₖ at the present angles, of the side on which k is. Momenta Mₒₒ φ̇ₒ + Mₒₖ φ̇ₖ go on through impacts
// of k, so that ζ jumps at each by what C has changed by, at most D, times speeds before and after; and ∫φ̇ₖ
// dt = 0 over a flight, so that angles change by ∫ζ dt alone.

/// Half sizes of the box.
struct Box {
  Ball duration, speed, reach;      ///< T, V, ρ
  std::vector<Ball> angles, rates;  ///< aⱼ, bⱼ of other open interfaces; else 0
};

struct Accumulation {
  Motion after;
  Ball duration;                  ///< T*, s
  Box box;                        ///< in which the lemma holds
  std::vector<Decision> impacts;  ///< in it, from the present side and from the other one
};

/// The accumulation of an interface that has just left an impact. @throws Undecided where the lemma does not
/// hold; `left` is the rest of the ground's piece, s.
Accumulation accumulate(const Stack& stack, bool paper, const Motion& motion, std::size_t interface,
                        const GroundPiece& piece, const Ball& offset, const Ball& left);

}  // namespace rockstack::proof
