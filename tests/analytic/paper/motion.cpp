#include "tests/analytic/paper/motion.hpp"

#include <cmath>

namespace rockstack::paper {
using std::cos;
using std::sin;

double eq6(const Geometry& q, const double (&v)[2], const Velocities& w) {
  return 0.5 *
         ((q.m1 * v[0] * v[0] + q.IG1 * w.base * w.base) + (q.m2 * v[1] * v[1] + q.IG2 * w.top * w.top));
}

double eq7(const Geometry& q, const double (&height)[2], double g) {
  return q.m1 * height[0] * g + q.m2 * height[1] * g;
}

double eq8(const Geometry& q, const Motion& s, Reading reading) {
  const auto [u1, u2] = s.angle;
  const double S = signum(u1);
  const double gamma = eq10(q, s.angle);
  // The print has θc1 where the ground acts on the top block's pivot, which lies at β.
  const double at_pivot = reading == Reading::printed ? q.uc1 : q.beta;
  const double left = (q.IO1 + q.m2 * q.l * q.l) * s.a1 + q.m2 * q.l * q.r2 * cos(gamma) * s.a2 +
                      q.m2 * q.l * q.r2 * sin(gamma) * s.velocity.top * s.velocity.top -
                      q.m1 * s.g * q.r1 * sin(u1 - S * q.uc1) - q.m2 * s.g * q.l * sin(u1 - S * q.beta);
  const double right = -(q.m1 * q.r1 * cos(u1 - S * q.uc1) + q.m2 * q.l * cos(u1 - S * at_pivot)) * s.xg +
                       (q.m1 * q.r1 * sin(u1 - S * q.uc1) + q.m2 * q.l * sin(u1 - S * at_pivot)) * s.yg;
  return left - right;
}

double eq9(const Geometry& q, const Motion& s, Reading reading) {
  const auto [u1, u2] = s.angle;
  const double S = signum(u1);
  const double gamma = eq10(q, s.angle);
  // The print has no θ̈1 in the first term.
  const double a1 = reading == Reading::printed ? 1.0 : s.a1;
  const double left = q.m2 * q.l * q.r2 * cos(gamma) * a1 + q.IO2 * s.a2 -
                      q.m2 * q.l * q.r2 * sin(gamma) * s.velocity.base * s.velocity.base -
                      q.m2 * s.g * q.r2 * sin(u2 - S * q.uc2);
  return left - q.m2 * q.r2 * (s.yg * sin(u2 - S * q.uc2) - s.xg * cos(u2 - S * q.uc2));
}

double eq10(const Geometry& q, const Angles& u) {
  return u.u1 - u.u2 + signum(u.u1) * (q.uc2 - q.beta);
}

double eq12(const Geometry& q, const Motion& s) {
  const auto [u1, u2] = s.angle;
  const double S = signum(u1);
  const double gamma = eq14(q, s.angle);
  const double left = (q.IO1 + q.m2 * q.l_ * q.l_) * s.a1 + q.m2 * q.l_ * q.r2 * cos(gamma) * s.a2 +
                      q.m2 * q.l_ * q.r2 * sin(gamma) * s.velocity.top * s.velocity.top -
                      q.m1 * s.g * q.r1 * sin(u1 - S * q.uc1) - q.m2 * s.g * q.l_ * sin(u1 - S * q.beta_);
  const double right = -(q.m1 * q.r1 * cos(u1 - S * q.uc1) + q.m2 * q.l_ * cos(u1 - S * q.beta_)) * s.xg +
                       (q.m1 * q.r1 * sin(u1 - S * q.uc1) + q.m2 * q.l_ * sin(u1 - S * q.beta_)) * s.yg;
  return left - right;
}

double eq13(const Geometry& q, const Motion& s, Reading reading) {
  const auto [u1, u2] = s.angle;
  const double S = signum(u1);
  const double gamma = eq14(q, s.angle);
  const double left = q.m2 * q.l_ * q.r2 * cos(gamma) * s.a1 + q.IO2 * s.a2 -
                      q.m2 * q.l_ * q.r2 * sin(gamma) * s.velocity.base * s.velocity.base -
                      q.m2 * s.g * q.r2 * sin(u2 + S * q.uc2);
  // The print has the horizontal ground acceleration with both signs turned.
  const double horizontal = reading == Reading::printed ? cos(u2 - S * q.uc2) : -cos(u2 + S * q.uc2);
  return left - q.m2 * q.r2 * (s.yg * sin(u2 + S * q.uc2) + s.xg * horizontal);
}

double eq14(const Geometry& q, const Angles& u) {
  return u.u1 - u.u2 - signum(u.u1) * (q.uc2 + q.beta_);
}

double eq15(const Geometry& q, const Motion& s) {
  const double lean = s.angle.u1 - signum(s.angle.u1) * q.uc;
  return q.IO * s.a1 - q.M * s.g * q.R * sin(lean) + q.M * q.R * (s.xg * cos(lean) - s.yg * sin(lean));
}

double eq18(const Geometry& q, const Motion& s) {
  const double lean = s.angle.u2 - signum(s.angle.u2) * q.uc2;
  return q.IO2 * s.a2 - q.m2 * s.g * q.r2 * sin(lean) + q.m2 * q.r2 * (s.xg * cos(lean) - s.yg * sin(lean));
}

}  // namespace rockstack::paper
