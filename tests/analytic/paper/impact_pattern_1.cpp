#include "tests/analytic/paper/impact_pattern_1.hpp"

#include <cmath>

namespace rockstack::paper {
using std::cos;
using std::sin;
namespace {

double to_centre(const Geometry& q) {
  return std::sqrt(q.b1 * q.b1 + (2 * q.h1 + q.h2) * (2 * q.h1 + q.h2));
}

}  // namespace

double eq44(double inertia, double rate, double linear_momentum, double distance) {
  return inertia * rate + linear_momentum * distance;
}

Momentum eq47(const Geometry& q, const Angles& u) {
  return before(
      q.IO1 - 2 * q.m1 * q.b1 * q.b1 +
          q.m2 * q.l *
              (q.r2 * cos(u.u2 - q.uc2 + q.beta) + 2 * q.h1 * cos(q.beta) - (2 * q.b1 - q.xi) * sin(q.beta)),
      q.IO2 + q.m2 * q.r2 * (2 * q.h1 * cos(u.u2 - q.uc2) + (2 * q.b1 - q.xi) * sin(u.u2 - q.uc2)));
}

Momentum eq48(const Geometry& q, const Angles& u) {
  return after(q.IO1 + q.m2 * q.l_ *
                           (q.r2 * cos(u.u2 - q.uc2 - q.beta_) + 2 * q.h1 * cos(q.beta_) +
                            (2 * q.b1 - q.xi) * sin(q.beta_)),
               q.IO2 + q.m2 * q.r2 * (2 * q.h1 * cos(u.u2 - q.uc2) + (2 * q.b1 - q.xi) * sin(u.u2 - q.uc2)));
}

Momentum eq50(const Geometry& q, const Angles& u) {
  return before(q.m2 * q.r2 * q.l * cos(u.u2 - q.uc2 + q.beta), q.IO2);
}

Momentum eq51(const Geometry& q, const Angles& u) {
  return after(q.m2 * q.r2 * q.l_ * cos(u.u2 - q.uc2 - q.beta_), q.IO2);
}

double eq54(const Geometry& q, const Cs& c) {
  return (q.IO2 * c.C1 - c.C2 * c.C3) / (c.C4 * q.IO2 - c.C2 * c.C5);
}

double eq55(const Geometry& q, const Cs& c) {
  return (c.C5 * c.C1 - c.C4 * c.C3) / (c.C2 * c.C5 - c.C4 * q.IO2);
}

double eq56(const Geometry& q, const Angles& u, Reading reading) {
  // The print has no l.
  const double l = reading == Reading::printed ? 1.0 : q.l;
  return q.IO1 - 2 * q.m1 * q.b1 * q.b1 +
         q.m2 * l *
             (q.r2 * cos(u.u2 - q.uc2 + q.beta) + 2 * q.h1 * cos(q.beta) - (2 * q.b1 - q.xi) * sin(q.beta));
}

double eq57(const Geometry& q, const Angles& u) {
  return q.IO2 + q.m2 * q.r2 * (2 * q.h1 * cos(u.u2 - q.uc2) + (2 * q.b1 - q.xi) * sin(u.u2 - q.uc2));
}

double eq58(const Geometry& q, const Angles& u) {
  return q.m2 * q.r2 * q.l * cos(u.u2 - q.uc2 + q.beta);
}

double eq59(const Geometry& q, const Angles& u) {
  return q.IO1 + q.m2 * q.l_ *
                     (q.r2 * cos(u.u2 - q.uc2 - q.beta_) + 2 * q.h1 * cos(q.beta_) +
                      (2 * q.b1 - q.xi) * sin(q.beta_));
}

double eq60(const Geometry& q, const Angles& u) {
  return q.m2 * q.r2 * q.l_ * cos(u.u2 - q.uc2 - q.beta_);
}

Cs eqs56_to_60(const Geometry& q, const Angles& u, Reading reading) {
  return {eq56(q, u, reading), eq57(q, u), eq58(q, u), eq59(q, u), eq60(q, u)};
}

Solution eqs52_and_53(const Geometry& q, const Cs& c) {
  return {eq54(q, c), 0, eq55(q, c), 1};
}

Momentum eq62(const Geometry& q, const Angles& u) {
  return before(q.IO1 + q.m2 * q.l * to_centre(q) * cos(q.zeta - q.beta),
                q.IG2 + q.m2 * q.r2 * to_centre(q) * cos(u.u2 - u.u1 - q.uc2 + q.zeta));
}

Momentum eq63(const Geometry& q, const Angles& u, Reading reading) {
  // The print has θ̇1⁻ in a momentum after the impact.
  return {q.IO1 + q.m2 * q.l_ * to_centre(q) * cos(q.zeta - q.beta_),
          q.IG2 + q.m2 * q.r2 * to_centre(q) * cos(u.u2 - u.u1 + q.uc2 + q.zeta),
          reading == Reading::printed ? When::before : When::after, When::after};
}

Momentum eq65(const Geometry& q, const Angles& u) {
  return before(q.m2 * q.r2 * q.l * cos(u.u2 - u.u1 + q.uc2 + q.beta),
                q.IG2 + q.m2 * q.r2 * q.r2 * cos(2 * q.uc2));
}

Momentum eq66(const Geometry& q, const Angles& u, Reading reading) {
  // The print has θ̇1⁻ and θ̇2⁻ in a momentum after the impact.
  const When when = reading == Reading::printed ? When::before : When::after;
  return {q.m2 * q.r2 * q.l_ * cos(u.u2 - u.u1 + q.uc2 + q.beta_), q.IO2, when, when};
}

double eq69(const Geometry& q, const Es& e) {
  return (q.IO2 * e.E1 - e.E2 * e.E3) / (e.E4 * q.IO2 - e.E2 * e.E5);
}

double eq70(const Geometry& q, const Es& e) {
  return (q.IO2 * e.E6 - e.E2 * e.E7) / (e.E4 * q.IO2 - e.E2 * e.E5);
}

double eq71(const Geometry& q, const Es& e) {
  return (e.E5 * e.E1 - e.E4 * e.E3) / (e.E2 * e.E5 - e.E4 * q.IO2);
}

double eq72(const Geometry& q, const Es& e) {
  return (e.E5 * e.E6 - e.E4 * e.E7) / (e.E2 * e.E5 - e.E4 * q.IO2);
}

Es eqs73_to_79(const Geometry& q, const Angles& u) {
  return {q.IO1 + q.m2 * q.l * to_centre(q) * cos(q.zeta - q.beta),
          q.IG2 + q.m2 * q.r2 * to_centre(q) * cos(u.u2 - u.u1 + q.uc2 + q.zeta),
          q.m2 * q.r2 * q.l * cos(u.u2 - u.u1 + q.uc2 + q.beta),
          q.IO1 + q.m2 * q.l_ * to_centre(q) * cos(q.zeta - q.beta_),
          q.m2 * q.r2 * q.l_ * cos(u.u2 - u.u1 + q.uc2 + q.beta_),
          q.IG2 + q.m2 * q.r2 * to_centre(q) * cos(u.u2 - u.u1 - q.uc2 + q.zeta),
          q.IG2 + q.m2 * q.r2 * q.r2 * cos(2 * q.uc2)};
}

Solution eqs67_and_68(const Geometry& q, const Es& e) {
  return {eq69(q, e), eq70(q, e), eq71(q, e), eq72(q, e)};
}

Momentum eq81(const Geometry& q, const Angles& u) {
  return eq62(q, u);
}

Momentum eq82(const Geometry& q) {
  return after(eq83(q), 0);
}

double eq83(const Geometry& q) {
  return q.IO1 + q.IG2 + q.m2 * (q.b1 * q.b1 + (2 * q.h1 + q.h2) * (2 * q.h1 + q.h2));
}

double eq84(const Geometry& q, double B1, double B2, const Velocities& minus) {
  return B1 / eq83(q) * minus.base + B2 / eq83(q) * minus.top;
}

double eq85(const Geometry& q) {
  return q.IO1 + q.m2 * q.l * to_centre(q) * cos(q.zeta - q.beta);
}

double eq86(const Geometry& q, const Angles& u) {
  return q.IG2 + q.m2 * q.r2 * to_centre(q) * cos(u.u2 - u.u1 - q.uc2 + q.zeta);
}

}  // namespace rockstack::paper
