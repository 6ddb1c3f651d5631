#include "tests/analytic/paper/linear.hpp"

#include <cmath>

namespace rockstack::paper {
using std::cos;
using std::sin;

double eq19(const Geometry& q, const Motion& s) {
  const double S = signum(s.angle.u1);
  const double left = (q.IO1 + q.m2 * q.l * q.l) * s.a1 + q.m2 * q.l * q.r2 * cos(eq21(q, s.angle)) * s.a2 +
                      S * q.m1 * s.g * q.r1 * sin(q.uc1) + S * q.m2 * s.g * q.l * sin(q.beta);
  const double right = -(q.m1 * q.r1 * cos(q.uc1) + q.m2 * q.l * cos(q.beta)) * s.xg -
                       S * (q.m1 * q.r1 * sin(q.uc1) + q.m2 * q.l * sin(q.beta)) * s.yg;
  return left - right;
}

double eq20(const Geometry& q, const Motion& s) {
  const double S = signum(s.angle.u2);
  const double left =
      q.m2 * q.l * q.r2 * cos(eq21(q, s.angle)) * s.a1 + q.IO2 * s.a2 + S * q.m2 * s.g * q.r2 * sin(q.uc2);
  return left + q.m2 * q.r2 * (s.yg * S * sin(q.uc2) + s.xg * cos(q.uc2));
}

double eq21(const Geometry& q, const Angles& u) {
  return signum(u.u1) * (q.uc2 - q.beta);
}

double eq22(const Geometry& q, const Motion& s, Reading reading) {
  const double S = signum(s.angle.u1);
  const double gamma = reading == Reading::printed ? eq21(q, s.angle) : eq24(q, s.angle, Reading::corrected);
  const double left = (q.IO1 + q.m2 * q.l_ * q.l_) * s.a1 + q.m2 * q.l_ * q.r2 * cos(gamma) * s.a2 +
                      S * q.m1 * s.g * q.r1 * sin(q.uc1) + S * q.m2 * s.g * q.l_ * sin(q.beta_);
  const double right = -(q.m1 * q.r1 * cos(q.uc1) + q.m2 * q.l_ * cos(q.beta_)) * s.xg -
                       S * (q.m1 * q.r1 * sin(q.uc1) + q.m2 * q.l_ * sin(q.beta_)) * s.yg;
  return left - right;
}

double eq23(const Geometry& q, const Motion& s, Reading reading) {
  const double S = signum(s.angle.u1);
  // The print has the signs of gravity and of both ground accelerations turned.
  const double sign = reading == Reading::printed ? 1.0 : -1.0;
  const double left = q.m2 * q.l_ * q.r2 * cos(eq24(q, s.angle, Reading::corrected)) * s.a1 + q.IO2 * s.a2 +
                      sign * S * q.m2 * s.g * q.r2 * sin(q.uc2);
  return left + sign * q.m2 * q.r2 * (s.yg * S * sin(q.uc2) - s.xg * cos(q.uc2));
}

double eq24(const Geometry& q, const Angles& u, Reading reading) {
  const double sign = reading == Reading::printed ? 1.0 : -1.0;
  return sign * signum(u.u1) * (q.uc2 + q.beta_);
}

double eq25(const Geometry& q, const Motion& s) {
  const double S = signum(s.angle.u1);
  return q.IO * s.a1 + S * q.M * s.g * q.R * sin(q.uc) +
         q.M * q.R * (s.xg * cos(q.uc) + s.yg * S * sin(q.uc));
}

double eq28(const Geometry& q, const Motion& s) {
  const double S = signum(s.angle.u2);
  return q.IO2 * s.a2 + S * q.m2 * s.g * q.r2 * sin(q.uc2) +
         q.m2 * q.r2 * (s.xg * cos(q.uc2) + s.yg * S * sin(q.uc2));
}

}  // namespace rockstack::paper
