#include "tests/analytic/paper/impact.hpp"

namespace rockstack::paper {

Momentum before(double base, double top) {
  return {base, top, When::before, When::before};
}

Momentum after(double base, double top) {
  return {base, top, When::after, When::after};
}

double value(const Momentum& h, const Velocities& minus, const Velocities& plus) {
  return h.base * (h.base_when == When::before ? minus.base : plus.base) +
         h.top * (h.top_when == When::before ? minus.top : plus.top);
}

Velocities apply(const Solution& x, const Velocities& minus) {
  return {x.A * minus.base + x.B * minus.top, x.C * minus.base + x.D * minus.top};
}

}  // namespace rockstack::paper
