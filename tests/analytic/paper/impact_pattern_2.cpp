#include "tests/analytic/paper/impact_pattern_2.hpp"

#include <cmath>
#include <numbers>

namespace rockstack::paper {
using std::cos;
using std::sin;
namespace {

double to_centre(const Geometry& q) {
  return std::sqrt(q.b1 * q.b1 + (2 * q.h1 + q.h2) * (2 * q.h1 + q.h2));
}

}  // namespace

Momentum eq88(const Geometry& q, const Angles& u) {
  return before(
      q.IO1 - 2 * q.m1 * q.b1 * q.b1 +
          q.m2 * q.l_ * (q.r2 * cos(u.u2 + q.uc2 + q.beta_) + 2 * q.h1 * cos(q.beta_) - q.xi * sin(q.beta_)),
      q.IO2 + q.m2 * q.r2 * (2 * q.h1 * cos(u.u2 + q.uc2) + q.xi * sin(u.u2 + q.uc2)));
}

Momentum eq89(const Geometry& q, const Angles& u) {
  return after(
      q.IO1 + q.m2 * q.l * (q.r2 * cos(u.u2 + q.uc2 - q.beta) + 2 * q.h1 * cos(q.beta) + q.xi * sin(q.beta)),
      q.IO2 + q.m2 * q.r2 * (2 * q.h1 * cos(u.u2 + q.uc2) + q.xi * sin(u.u2 + q.uc2)));
}

Momentum eq91(const Geometry& q, const Angles& u) {
  return before(q.m2 * q.r2 * q.l_ * cos(u.u2 + q.uc2 + q.beta_), q.IO2);
}

Momentum eq92(const Geometry& q, const Angles& u, Reading reading) {
  // The print has θ̇1⁻ and θ̇2⁻ in a momentum after the impact.
  const When when = reading == Reading::printed ? When::before : When::after;
  return {q.m2 * q.r2 * q.l * cos(u.u2 + q.uc2 - q.beta), q.IO2, when, when};
}

double eq95(const Geometry& q, const Es& e) {
  return (q.IO2 * e.E1 - e.E2 * e.E3) / (e.E4 * q.IO2 - e.E2 * e.E5);
}

double eq96(const Geometry& q, const Es& e) {
  return (q.IO2 * e.E6 - e.E2 * q.IO2) / (e.E4 * q.IO2 - e.E2 * e.E5);
}

double eq97(const Geometry& q, const Es& e) {
  return (e.E5 * e.E1 - e.E4 * e.E3) / (e.E2 * e.E5 - e.E4 * q.IO2);
}

double eq98(const Geometry& q, const Es& e) {
  return (e.E5 * e.E6 - e.E4 * q.IO2) / (e.E2 * e.E5 - e.E4 * q.IO2);
}

double eq99(const Geometry& q, const Angles& u, Reading reading) {
  // The print has the top block's mass in the second term.
  const double mass = reading == Reading::printed ? q.m2 : q.m1;
  return q.IO1 - 2 * mass * q.b1 * q.b1 +
         q.m2 * q.l_ * (q.r2 * cos(u.u2 + q.uc2 + q.beta_) + 2 * q.h1 * cos(q.beta_) - q.xi * sin(q.beta_));
}

double eq104(const Geometry& q, const Angles& u, Reading reading) {
  // The print closes the bracket before the sine.
  if (reading == Reading::printed)
    return q.IO2 + q.m2 * q.r2 * (2 * q.h1 * cos(u.u2 + q.uc2) + q.xi) * sin(u.u2 + q.uc2);
  return q.IO2 + q.m2 * q.r2 * (2 * q.h1 * cos(u.u2 + q.uc2) + q.xi * sin(u.u2 + q.uc2));
}

Es eqs99_to_104(const Geometry& q, const Angles& u, Reading reading) {
  return {
      eq99(q, u, reading),
      q.IO2 + q.m2 * q.r2 * (2 * q.h1 * cos(u.u2 + q.uc2) + q.xi * sin(u.u2 + q.uc2)),
      q.m2 * q.r2 * q.l_ * cos(u.u2 + q.uc2 + q.beta_),
      q.IO1 + q.m2 * q.l * (q.r2 * cos(u.u2 + q.uc2 - q.beta) + 2 * q.h1 * cos(q.beta) + q.xi * sin(q.beta)),
      q.m2 * q.r2 * q.l * cos(u.u2 + q.uc2 - q.beta),
      eq104(q, u, reading),
      0};
}

Solution eqs93_and_94(const Geometry& q, const Es& e) {
  return {eq95(q, e), eq96(q, e), eq97(q, e), eq98(q, e)};
}

double zeta(const Geometry& q, const Angles& u, Reading reading) {
  return reading == Reading::printed ? q.zeta : std::numbers::pi - q.nu - u.u1;
}

Momentum eq106(const Geometry& q, const Angles& u, Reading reading) {
  const double z = zeta(q, u, reading);
  return before(q.IO1 + q.m2 * q.l_ * to_centre(q) * sin(u.u1 + z - q.beta_),
                q.IG2 + q.m2 * q.r2 * to_centre(q) * sin(u.u2 + q.uc2 + z));
}

Momentum eq107(const Geometry& q, const Angles& u, Reading reading) {
  // Besides the coefficient of θ̇2, the print has θ̇1⁻ in a momentum after the impact.
  const double z = zeta(q, u, Reading::corrected);
  return {q.IO1 + q.m2 * q.l * to_centre(q) * sin(u.u1 + z - q.beta), top_after(q, u, reading),
          reading == Reading::printed ? When::before : When::after, When::after};
}

Momentum eq109(const Geometry& q, const Angles& u, Reading reading) {
  const double angle = reading == Reading::printed ? u.u1 + u.u2 - q.uc2 - q.beta_ : 2 * q.uc2;
  return before(q.m2 * q.r2 * q.l_ * cos(u.u1 - u.u2 + q.uc2 - q.beta_),
                q.IG2 + q.m2 * q.r2 * q.r2 * cos(angle));
}

Momentum eq110(const Geometry& q, const Angles& u, Reading reading) {
  // The print has θ̇1⁻ and θ̇2⁻ in a momentum after the impact.
  const When when = reading == Reading::printed ? When::before : When::after;
  return {q.m2 * q.r2 * q.l * cos(u.u1 - u.u2 + q.uc2 - q.beta), q.IO2, when, when};
}

double top_after(const Geometry& q, const Angles& u, Reading reading) {
  // The print has the moment of inertia about O2, where the momentum about O1 is meant.
  if (reading == Reading::printed) return q.IO2;
  return q.IG2 + q.m2 * q.r2 * to_centre(q) * sin(u.u2 - q.uc2 + zeta(q, u, Reading::corrected));
}

double eq113(const Geometry& q, const Es& e, double X) {
  return (q.IO2 * e.E1 - X * e.E2) / (e.E3 * q.IO2 - X * e.E4);
}

double eq114(const Geometry& q, const Es& e, double X) {
  return (q.IO2 * e.E5 - X * e.E6) / (e.E3 * q.IO2 - X * e.E4);
}

double eq115(const Geometry& q, const Es& e, double X) {
  return (e.E4 * e.E1 - e.E3 * e.E2) / (X * e.E4 - e.E3 * q.IO2);
}

double eq116(const Geometry& q, const Es& e, double X) {
  return (e.E4 * e.E5 - e.E3 * e.E6) / (X * e.E4 - e.E3 * q.IO2);
}

Es eqs117_to_122(const Geometry& q, const Angles& u, Reading reading) {
  const double z = zeta(q, u, reading);
  const double angle = reading == Reading::printed ? u.u1 + u.u2 - q.uc2 - q.beta_ : 2 * q.uc2;
  return {q.IO1 + q.m2 * q.l_ * to_centre(q) * sin(u.u1 + z - q.beta_),
          q.m2 * q.r2 * q.l_ * cos(u.u1 - u.u2 + q.uc2 - q.beta_),
          q.IO1 + q.m2 * q.l * to_centre(q) * sin(u.u1 + z - q.beta),
          q.m2 * q.r2 * q.l * cos(u.u1 - u.u2 + q.uc2 - q.beta),
          q.IG2 + q.m2 * q.r2 * to_centre(q) * sin(u.u2 + q.uc2 + z),
          q.IG2 + q.m2 * q.r2 * q.r2 * cos(angle),
          0};
}

Solution eqs111_and_112(const Geometry& q, const Es& e, double X) {
  return {eq113(q, e, X), eq114(q, e, X), eq115(q, e, X), eq116(q, e, X)};
}

Momentum eq124(const Geometry& q, const Angles& u, Reading reading) {
  return eq106(q, u, reading);
}

Momentum eq125(const Geometry& q) {
  return after(q.IO, 0);
}

}  // namespace rockstack::paper
