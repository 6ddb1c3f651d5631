#include <cmath>
#include <numbers>

#include "tests/analytic/paper/checks.hpp"
#include "tests/analytic/paper/first_principles.hpp"
#include "tests/analytic/paper/initiation.hpp"
#include "tests/analytic/paper/linear.hpp"
#include "tests/analytic/paper/motion.hpp"

namespace rockstack::paper {
namespace {

int side(double S) {
  return S > 0 ? 1 : -1;
}

double relative_to(double size, double difference) {
  return std::abs(difference) / size;
}

/// Difference of two directions, in half turns.
double direction(double difference) {
  return std::abs(std::remainder(difference, 2 * std::numbers::pi)) / std::numbers::pi;
}

double from_vertical(Vec v) {
  return std::atan2(v.x, v.y);
}

/// The angle from the top block's radius to the line between the pivots, which γ1 and γ2 stand for.
double link_angle(const Assembly& blocks) {
  return from_vertical(blocks.top_pivot - blocks.base_pivot) -
         from_vertical(blocks.top.centre - blocks.top_pivot);
}

/// An equation for one of the blocks, against that block's moment about its pivot.
double on_base(const Draw& d, const Motion& geometry, const Motion& s, const Sides& sides, double equation) {
  return relative_to(moment_size(d.q, s), equation - moment_on_base(assemble(d.q, sides, geometry), s));
}

double on_top(const Draw& d, const Motion& geometry, const Motion& s, const Sides& sides, double equation) {
  const Assembly blocks = assemble(d.q, sides, geometry);
  return relative_to(moment_size(d.q, s), equation - moment_on_top(blocks, s, blocks.top_pivot));
}

double on_both(const Draw& d, const Motion& geometry, const Motion& s, const Sides& sides, double equation) {
  return relative_to(moment_size(d.q, s), equation - moment_on_both(assemble(d.q, sides, geometry), s));
}

Sides same(const Draw& d) {
  return {side(d.S), side(d.S)};
}
Sides opposed(const Draw& d) {
  return {side(d.S), -side(d.S)};
}

/// The blocks at rest on moving ground.
Motion at_rest(const Draw& d) {
  Motion s = upright(d.motion);
  s.a1 = s.a2 = 0;
  return s;
}

}  // namespace

void add_initiation(std::map<int, Check>& all) {
  // A block starts to turn about an end when its moment about it, clockwise about the right end, is positive.
  all[1] = [](const Draw& d, Reading) {
    const Motion s = at_rest(d);
    return on_both(d, s, s, {1, 1}, -d.q.M * eq1(d.q, s));
  };
  all[2] = [](const Draw& d, Reading) {
    const Assembly blocks = assemble(d.q, {1, 1}, {});
    const double height = (d.q.m1 * blocks.base.centre.y + d.q.m2 * blocks.top.centre.y) / (d.q.m1 + d.q.m2);
    return relative_to(height, eq2(d.q) - height);
  };
  all[3] = [](const Draw& d, Reading) {
    const Motion s = at_rest(d);
    return on_both(d, s, s, {-1, -1}, d.q.M * eq3(d.q, s));
  };
  all[4] = [](const Draw& d, Reading) {
    const Motion s = at_rest(d);
    return on_top(d, s, s, {1, 1}, -d.q.m2 * eq4(d.q, s));
  };
  all[5] = [](const Draw& d, Reading) {
    const Motion s = at_rest(d);
    return on_top(d, s, s, {-1, -1}, d.q.m2 * eq5(d.q, s));
  };
}

void add_motion(std::map<int, Check>& all) {
  all[6] = [](const Draw& d, Reading) {
    const Motion s = in_pattern_1(d);
    const Assembly blocks = assemble(d.q, same(d), s);
    const Vec v1 = blocks.base.velocity;
    const Vec v2 = blocks.top.velocity;
    const double energy = kinetic_energy(blocks);
    return relative_to(energy,
                       eq6(d.q, {std::hypot(v1.x, v1.y), std::hypot(v2.x, v2.y)}, s.velocity) - energy);
  };
  all[7] = [](const Draw& d, Reading) {
    // V over the weight is the height of the common centre of mass.
    const Motion s = in_pattern_1(d);
    const Assembly blocks = assemble(d.q, same(d), s);
    const Vec centre = (1 / d.q.M) * (d.q.m1 * blocks.base.centre + d.q.m2 * blocks.top.centre);
    const double energy = d.q.M * s.g * centre.y;
    return relative_to(energy, eq7(d.q, {blocks.base.centre.y, blocks.top.centre.y}, s.g) - energy);
  };
  all[8] = [](const Draw& d, Reading r) {
    const Motion s = in_pattern_1(d);
    return on_base(d, s, s, same(d), eq8(d.q, s, r));
  };
  all[9] = [](const Draw& d, Reading r) {
    const Motion s = in_pattern_1(d);
    return on_top(d, s, s, same(d), eq9(d.q, s, r));
  };
  all[10] = [](const Draw& d, Reading) {
    const Motion s = in_pattern_1(d);
    return direction(eq10(d.q, s.angle) - link_angle(assemble(d.q, same(d), s)));
  };
  all[12] = [](const Draw& d, Reading) {
    const Motion s = in_pattern_2(d);
    return on_base(d, s, s, opposed(d), eq12(d.q, s));
  };
  all[13] = [](const Draw& d, Reading r) {
    const Motion s = in_pattern_2(d);
    return on_top(d, s, s, opposed(d), eq13(d.q, s, r));
  };
  all[14] = [](const Draw& d, Reading) {
    const Motion s = in_pattern_2(d);
    return direction(eq14(d.q, s.angle) - link_angle(assemble(d.q, opposed(d), s)));
  };
  all[15] = [](const Draw& d, Reading) {
    const Motion s = in_pattern_3(d);
    return on_both(d, s, s, same(d), eq15(d.q, s));
  };
  all[18] = [](const Draw& d, Reading) {
    const Motion s = in_pattern_4(d);
    return on_top(d, s, s, same(d), eq18(d.q, s));
  };
}

void add_linear(std::map<int, Check>& all) {
  all[19] = [](const Draw& d, Reading) {
    const Motion s = in_pattern_1(d);
    return on_base(d, upright(s), s, same(d), eq19(d.q, s));
  };
  all[20] = [](const Draw& d, Reading) {
    const Motion s = in_pattern_1(d);
    return on_top(d, upright(s), s, same(d), eq20(d.q, s));
  };
  all[21] = [](const Draw& d, Reading) {
    const Motion s = in_pattern_1(d);
    return direction(eq21(d.q, s.angle) - link_angle(assemble(d.q, same(d), upright(s))));
  };
  all[22] = [](const Draw& d, Reading r) {
    const Motion s = in_pattern_2(d);
    return on_base(d, upright(s), s, opposed(d), eq22(d.q, s, r));
  };
  all[23] = [](const Draw& d, Reading r) {
    const Motion s = in_pattern_2(d);
    return on_top(d, upright(s), s, opposed(d), eq23(d.q, s, r));
  };
  all[24] = [](const Draw& d, Reading r) {
    const Motion s = in_pattern_2(d);
    return direction(eq24(d.q, s.angle, r) - link_angle(assemble(d.q, opposed(d), upright(s))));
  };
  all[25] = [](const Draw& d, Reading) {
    const Motion s = in_pattern_3(d);
    return on_both(d, upright(s), s, same(d), eq25(d.q, s));
  };
  all[28] = [](const Draw& d, Reading) {
    const Motion s = in_pattern_4(d);
    return on_top(d, upright(s), s, same(d), eq28(d.q, s));
  };
}

}  // namespace rockstack::paper
