#include "tests/analytic/paper/impact_patterns_3_4.hpp"

#include <cmath>

namespace rockstack::paper {
using std::cos;
using std::sin;

Momentum eq127(const Geometry& q) {
  return before(q.IO - 2 * q.M * q.b1 * q.b1, 0);
}

Momentum eq128(const Geometry& q, Reading reading) {
  // The print has the base's inertia in the top block's term.
  const double inertia = reading == Reading::printed ? q.IG1 : q.IG2;
  return after(q.IO1 + q.m2 * q.l * ((2 * q.h1 + q.h2) * cos(q.beta) + q.b1 * sin(q.beta)),
               inertia + q.m2 * q.r2 * (q.b1 * sin(q.uc2) + (2 * q.h1 + q.h2) * cos(q.uc2)));
}

Momentum eq130(const Geometry& q, Reading reading) {
  // The print has the base's inertia, and β for β' in the cosine.
  if (reading == Reading::printed)
    return before(q.IO1 + q.m2 * q.l_ * (q.h2 * cos(q.beta) - q.b2 * sin(q.beta_)), 0);
  return before(q.IO2 + q.m2 * q.l_ * (q.h2 * cos(q.beta_) - q.b2 * sin(q.beta_)), 0);
}

Momentum eq131(const Geometry& q) {
  return after(q.m2 * q.l * (q.h2 * cos(q.beta) + q.b2 * sin(q.beta)), q.IO2);
}

double eq134(const Geometry& q, const Cs& c) {
  return (q.IO2 * c.C1 - c.C2 * c.C3) / (c.C4 * q.IO2 - c.C2 * c.C5);
}

double eq135(const Geometry& q, const Cs& c) {
  return (c.C5 * c.C1 - c.C4 * c.C3) / (c.C2 * c.C5 - c.C4 * q.IO2);
}

Cs eqs136_to_140(const Geometry& q, Reading reading) {
  // The print has the base's inertia in C2 and in C3.
  const bool printed = reading == Reading::printed;
  return {q.IO - 2 * q.M * q.b1 * q.b1,
          (printed ? q.IG1 : q.IG2) + q.m2 * q.r2 * (q.b1 * sin(q.uc2) + (2 * q.h1 + q.h2) * cos(q.uc2)),
          (printed ? q.IO1 : q.IO2) + q.m2 * q.l_ * (q.h2 * cos(q.beta_) - q.b2 * sin(q.beta_)),
          q.IO1 + q.m2 * q.l * ((2 * q.h1 + q.h2) * cos(q.beta) + q.b1 * sin(q.beta)),
          q.m2 * q.l * (q.h2 * cos(q.beta) + q.b2 * sin(q.beta))};
}

Solution eqs132_and_133(const Geometry& q, const Cs& c) {
  return {eq134(q, c), 0, eq135(q, c), 0};
}

Momentum eq142(const Geometry& q) {
  return eq127(q);
}

Momentum eq143(const Geometry& q) {
  return after(q.IO, 0);
}

double eq144(const Geometry& q, double before) {
  return (q.IO - 2 * q.M * q.b1 * q.b1) / q.IO * before;
}

Momentum eq146(const Geometry& q) {
  return before(0, q.IG2 + q.m2 * q.r2 * ((2 * q.h1 + q.h2) * cos(q.uc2) - q.b1 * sin(q.uc2)));
}

Momentum eq147(const Geometry& q) {
  return after(q.IO1 + q.m2 * q.l * ((2 * q.h1 + q.h2) * cos(q.beta) + q.b1 * sin(q.beta)),
               q.IG2 + q.m2 * q.r2 * ((2 * q.h1 + q.h2) * cos(q.uc2) + q.b1 * sin(q.uc2)));
}

Momentum eq149(const Geometry& q) {
  return before(0, q.IO2 - 2 * q.m2 * q.b2 * q.b2);
}

Momentum eq150(const Geometry& q, Reading reading) {
  // The print has θ1, which is zero at the impact, for θ̇1.
  const double rate = reading == Reading::printed ? 0.0 : 1.0;
  return after(rate * q.m2 * q.l * (q.h2 * cos(q.beta) + q.b2 * sin(q.beta)), q.IO2);
}

double eq153(const Geometry& q, const Cs& c) {
  return eq134(q, c);
}

double eq154(const Geometry& q, const Cs& c) {
  return eq135(q, c);
}

Cs eqs155_to_159(const Geometry& q, Reading reading) {
  // The print has b1 alone in C1 and, in C2, θ2 for θc2.
  const bool printed = reading == Reading::printed;
  return {q.IG2 + q.m2 * q.r2 * ((2 * q.h1 + q.h2) * cos(q.uc2) - q.b1 * (printed ? 1.0 : sin(q.uc2))),
          q.IG2 + q.m2 * q.r2 * ((2 * q.h1 + q.h2) * cos(q.uc2) + q.b1 * (printed ? 0.0 : sin(q.uc2))),
          q.IO2 - 2 * q.m2 * q.b2 * q.b2,
          q.IO1 + q.m2 * q.l * ((2 * q.h1 + q.h2) * cos(q.beta) + q.b1 * sin(q.beta)),
          q.m2 * q.l * (q.h2 * cos(q.beta) + q.b2 * sin(q.beta))};
}

Solution eqs151_and_152(const Geometry& q, const Cs& c) {
  return {0, eq153(q, c), 0, eq154(q, c)};
}

Momentum eq161(const Geometry& q) {
  return eq149(q);
}

Momentum eq162(const Geometry& q) {
  return after(0, q.IO2);
}

double eq163(const Geometry& q, double before) {
  return (q.IO2 - 2 * q.m2 * q.b2 * q.b2) / q.IO2 * before;
}

}  // namespace rockstack::paper
