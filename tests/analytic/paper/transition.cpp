#include "tests/analytic/paper/transition.hpp"

#include <cmath>

namespace rockstack::paper {
using std::cos;
using std::sin;
namespace {

double squared(double x) {
  return x * x;
}

}  // namespace

double eq29(const Geometry& q, const Motion& s) {
  const double u1 = s.angle.u1;
  const double w = s.velocity.base;
  return -cos(q.uc2 - u1) * s.xg - sin(q.uc2 - u1) * s.yg -
         (s.g * sin(q.uc2 - u1) + q.d * cos(q.uc2 + q.nu) * w * w +
          (q.d * sin(q.uc2 + q.nu) + q.IG2 / (q.m2 * q.r2)) * s.a1);
}

double eq30(const Geometry& q) {
  return std::sqrt(squared(2 * q.h1 + q.h2) + squared(q.b1));
}

double eq32(const Geometry& q, const Motion& s, Reading reading) {
  const double u1 = s.angle.u1;
  const double w = s.velocity.base;
  const double k = q.IG2 / (q.m2 * q.r2);
  if (reading == Reading::printed)
    return cos(q.uc2 - u1) * s.xg - sin(q.uc2 - u1) * s.yg -
           (s.g * sin(q.uc2 + u1) + q.d * cos(2 * u1 + q.uc2 + q.nu) * w * w +
            (q.d * sin(2 * u1 + q.uc2 + q.nu) + k) * s.a1);
  return cos(q.uc2 + u1) * s.xg - sin(q.uc2 + u1) * s.yg -
         (s.g * sin(q.uc2 + u1) - q.d * cos(q.nu - q.uc2) * w * w - (q.d * sin(q.nu - q.uc2) + k) * s.a1);
}

double eq33(const Geometry& q, const Motion& s, Reading reading) {
  const double u1 = s.angle.u1;
  const double w = s.velocity.base;
  const double k = q.IG2 / (q.m2 * q.r2);
  const double ground = cos(q.uc2 + u1) * s.xg - sin(q.uc2 + u1) * s.yg;
  if (reading == Reading::printed)
    return ground -
           (s.g * sin(q.uc2 + u1) + q.d * sin(q.nu - q.uc2) * w * w - (q.d * cos(q.nu - q.uc2) - k) * s.a1);
  return ground -
         (s.g * sin(q.uc2 + u1) + q.d * cos(q.nu + q.uc2) * w * w - (q.d * sin(q.nu + q.uc2) + k) * s.a1);
}

double eq34(const Geometry& q, const Motion& s, Reading reading) {
  const double u1 = s.angle.u1;
  const double w = s.velocity.base;
  const double k = q.IG2 / (q.m2 * q.r2);
  const double ground = -cos(q.uc2 - u1) * s.xg - sin(q.uc2 - u1) * s.yg;
  if (reading == Reading::printed)
    return ground -
           (s.g * sin(q.uc2 - u1) - q.d * sin(q.nu + q.uc2) * w * w + (q.d * cos(q.nu + q.uc2) - k) * s.a1);
  return ground -
         (s.g * sin(q.uc2 - u1) - q.d * cos(q.nu - q.uc2) * w * w + (q.d * sin(q.nu - q.uc2) + k) * s.a1);
}

// In Eqs. (35)–(40) the print leaves out the top block's own weight, m2 ξ g or m2 ξ' g.

double eq35(const Geometry& q, const Motion& s, Reading reading) {
  const double lean = q.uc2 - s.angle.u2;
  const double weight = reading == Reading::printed ? q.m1 * q.b1 * s.g : (q.m1 * q.b1 + q.m2 * q.xi) * s.g;
  return -(q.m1 + 2 * q.m2) * q.h1 * s.xg - (q.m1 * q.b1 + q.m2 * q.xi) * s.yg -
         (q.m2 * q.r2 * (q.xi * sin(lean) + 2 * q.h1 * cos(lean)) * s.a2 +
          q.m2 * q.r2 * (2 * q.h1 * sin(lean) - q.xi * cos(lean)) * squared(s.velocity.top) + weight);
}

double eq37(const Geometry& q, const Motion& s, Reading reading) {
  const double lean = q.uc2 + s.angle.u2;
  const double weight = reading == Reading::printed ? q.m1 * q.b1 * s.g : (q.m1 * q.b1 + q.m2 * q.xi) * s.g;
  return (q.m1 + 2 * q.m2) * q.h1 * s.xg - (q.m1 * q.b1 + q.m2 * q.xi) * s.yg -
         (-q.m2 * q.r2 * (q.xi * sin(lean) + 2 * q.h1 * cos(lean)) * s.a2 +
          q.m2 * q.r2 * (2 * q.h1 * sin(lean) - q.xi * cos(lean)) * squared(s.velocity.top) + weight);
}

double eq38(const Geometry& q, const Motion& s, Reading reading) {
  const double lean = q.uc2 + s.angle.u2;
  const double weight = reading == Reading::printed ? q.m1 * q.b1 * s.g : (q.m1 * q.b1 + q.m2 * q.xi_) * s.g;
  return -(q.m1 + 2 * q.m2) * q.h1 * s.xg - (q.m1 * q.b1 + q.m2 * q.xi_) * s.yg -
         (-q.m2 * q.r2 * (q.xi_ * sin(lean) - 2 * q.h1 * cos(lean)) * s.a2 -
          q.m2 * q.r2 * (2 * q.h1 * sin(lean) + q.xi_ * cos(lean)) * squared(s.velocity.top) + weight);
}

double eq40(const Geometry& q, const Motion& s, Reading reading) {
  const double lean = q.uc2 - s.angle.u2;
  const double weight = reading == Reading::printed ? q.m1 * q.b1 * s.g : (q.m1 * q.b1 + q.m2 * q.xi_) * s.g;
  return (q.m1 + 2 * q.m2) * q.h1 * s.xg - (q.m1 * q.b1 + q.m2 * q.xi_) * s.yg -
         (q.m2 * q.r2 * (q.xi_ * sin(lean) - 2 * q.h1 * cos(lean)) * s.a2 -
          q.m2 * q.r2 * (2 * q.h1 * sin(lean) + q.xi_ * cos(lean)) * squared(s.velocity.top) + weight);
}

}  // namespace rockstack::paper
