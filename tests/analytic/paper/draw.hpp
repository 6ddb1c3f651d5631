#pragma once

#include <random>

#include "tests/analytic/paper/geometry.hpp"

namespace rockstack::paper {

/// A random pair of blocks and everything that an equation can be a function of.
struct Draw {
  Geometry q;
  double S = 1;                  ///< 1 for the paper's subcase a, −1 for b
  double lean = 0, opening = 0;  ///< how far the base leans, how far the top opens; rad, > 0
  Motion motion;                 ///< its angles are set by the functions below
  Velocities minus, plus;        ///< unrelated velocities before and after an impact, rad/s
};

/// Widths 0.4–4 m with the upper block the narrower, heights 0.4–6 m, densities 500–4000 kg/m³, inertias
/// 0.5–1.5 times the rectangle's, angles 0.01–0.6 rad, rates to 3 rad/s, ground to 10 m/s² in each direction.
Draw draw(std::mt19937_64& random);

/// Calls a test with so many draws from a seed.
template <class Test>
void repeat_on_draws(unsigned seed, int count, const Test& test) {
  std::mt19937_64 random(seed);
  for (int i = 0; i < count; ++i) test(draw(random));
}

// The drawn motion with the angles of a pattern; 3 with equal rates and accelerations, 4 with the base at
// rest.
Motion in_pattern_1(const Draw& d);
Motion in_pattern_2(const Draw& d);
Motion in_pattern_3(const Draw& d);
Motion in_pattern_4(const Draw& d);

/// Motion with its geometry upright and without rates.
Motion upright(Motion motion);

/// Size of the moments in a motion of these blocks, N·m: no term of an equation of motion is larger than a
/// few of it.
double moment_size(const Geometry& q, const Motion& motion);

/// Size of the coefficients of angular momentum, kg·m²: none is larger than it.
double inertia_size(const Geometry& q);

}  // namespace rockstack::paper
