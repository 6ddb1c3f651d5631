#include "tests/analytic/paper/geometry.hpp"

#include <cmath>

namespace rockstack::paper {

Geometry make_geometry(const Block& base, const Block& top) {
  Geometry q{};
  q.m1 = base.mass, q.b1 = base.half_width, q.h1 = base.half_height, q.IG1 = base.inertia;
  q.m2 = top.mass, q.b2 = top.half_width, q.h2 = top.half_height, q.IG2 = top.inertia;
  q.r1 = std::hypot(q.b1, q.h1);
  q.r2 = std::hypot(q.b2, q.h2);
  q.uc1 = std::atan2(q.b1, q.h1);
  q.uc2 = std::atan2(q.b2, q.h2);
  q.IO1 = q.IG1 + q.m1 * q.r1 * q.r1;
  q.IO2 = q.IG2 + q.m2 * q.r2 * q.r2;
  q.xi = q.b1 - q.b2;
  q.xi_ = 2 * q.b1 - q.xi;
  q.l = std::hypot(q.xi, 2 * q.h1);
  q.l_ = std::hypot(q.xi_, 2 * q.h1);
  q.beta = std::atan2(q.xi, 2 * q.h1);
  q.beta_ = std::atan2(q.xi_, 2 * q.h1);
  q.d = std::sqrt((2 * q.h1 + q.h2) * (2 * q.h1 + q.h2) + q.b1 * q.b1);
  q.nu = std::atan((2 * q.h1 + q.h2) / q.b1);
  q.zeta = std::atan(q.b1 / (2 * q.h1 + q.h2));
  q.M = q.m1 + q.m2;
  q.h = (q.m1 * q.h1 + q.m2 * (2 * q.h1 + q.h2)) / (q.m1 + q.m2);
  q.R = std::hypot(q.b1, q.h);
  q.uc = std::atan2(q.b1, q.h);
  q.IO = q.IO1 + q.IG2 + q.m2 * (q.b1 * q.b1 + (2 * q.h1 + q.h2) * (2 * q.h1 + q.h2));
  return q;
}

double signum(double angle) {
  return static_cast<double>((angle > 0) - (angle < 0));
}

}  // namespace rockstack::paper
