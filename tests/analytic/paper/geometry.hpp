#pragma once

#include "analytic/scene/scene.hpp"

namespace rockstack::paper {

/// How an equation of Spanos, Roussis & Politis 2001 is read: as it stands in print, or with its misprint put
/// right. For an equation that the print leaves ambiguous, `printed` is the reading that has to be turned
/// down.
enum class Reading { printed, corrected };

/// The constants of two stacked blocks under the paper's names (Section 2.1, Fig. 1). Angles in rad, SI
/// units. Precondition: the upper block is not the wider one.
struct Geometry {
  double m1, m2, b1, b2, h1, h2, IG1, IG2;
  double r1, r2;       ///< from a lower corner of a block to its centre
  double uc1, uc2;     ///< θc: between a block's side and that radius
  double IO1, IO2;     ///< about a lower corner of the block
  double xi, xi_;      ///< ξ, ξ', Eqs. (36), (39): across from O1 to O2 and to O2'
  double l, l_;        ///< from O1 to O2 and to O2'
  double beta, beta_;  ///< β, β': between the base's right side and those lines
  double d, nu;        ///< Eqs. (30), (31): from O1 to G2 of the closed stack, and that line's slope
  double zeta;         ///< ζ of Section 3.2.2: between the base's right side and the line from O1 to G2
  double M, h;         ///< Eq. (2): total mass, height of the common centre
  double R, uc, IO;    ///< Eq. (83): the closed stack as one block
};

Geometry make_geometry(const Block& base, const Block& top);

/// Eq. (11): 1, 0 or −1.
double signum(double angle);

struct Angles {
  double u1 = 0, u2 = 0;  ///< θ1, θ2, rad
};

struct Velocities {
  double base = 0, top = 0;  ///< rad/s
};

/// What Eqs. (8)–(40) are functions of, besides the constants.
struct Motion {
  Angles angle;
  Velocities velocity;
  double a1 = 0, a2 = 0;         ///< θ̈1, θ̈2, rad/s²
  double xg = 0, yg = 0, g = 0;  ///< ẍg, ÿg, gravity, m/s²
};

}  // namespace rockstack::paper
