#pragma once

#include "tests/analytic/paper/geometry.hpp"

namespace rockstack::paper {

/// Which of a block's two angular velocities a term carries: θ̇⁻ or θ̇⁺.
enum class When { before, after };

/// An angular momentum as the paper writes it, (base) θ̇1 + (top) θ̇2, kg·m² per metre of depth. The
/// superscripts are kept because some are misprinted.
struct Momentum {
  double base = 0, top = 0;
  When base_when = When::before, top_when = When::before;
};

/// A momentum with both superscripts minus.
Momentum before(double base, double top);
/// A momentum with both superscripts plus.
Momentum after(double base, double top);

/// Value of a momentum across an impact, clockwise positive.
double value(const Momentum& h, const Velocities& minus, const Velocities& plus);

/// The coefficients that the paper calls C1 … C5 in Eqs. (56)–(60), (136)–(140) and (155)–(159).
struct Cs {
  double C1, C2, C3, C4, C5;
};

/// The coefficients that the paper calls E1 … E7; Eqs. (113)–(122) have no seventh.
struct Es {
  double E1, E2, E3, E4, E5, E6, E7;
};

/// θ̇1⁺ = A θ̇1⁻ + B θ̇2⁻ and θ̇2⁺ = C θ̇1⁻ + D θ̇2⁻.
struct Solution {
  double A, B, C, D;
};

Velocities apply(const Solution& x, const Velocities& minus);

}  // namespace rockstack::paper
