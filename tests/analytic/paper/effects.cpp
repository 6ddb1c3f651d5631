#include "tests/analytic/paper/effects.hpp"

#include <cmath>
#include <limits>

#include "tests/analytic/paper/first_principles.hpp"
#include "tests/analytic/paper/impact_pattern_1.hpp"
#include "tests/analytic/paper/impact_pattern_2.hpp"
#include "tests/analytic/paper/impact_patterns_3_4.hpp"
#include "tests/analytic/paper/linear.hpp"
#include "tests/analytic/paper/motion.hpp"
#include "tests/analytic/paper/transition.hpp"

namespace rockstack::paper {
namespace {

using Printable = double (*)(const Geometry&, const Motion&, Reading);

constexpr double gravity = 9.81;

Block uniform(double width, double height) {
  Block block{width / 2, height / 2, 2500 * width * height, 0};
  block.inertia = rectangle_inertia(block.mass, block.half_width, block.half_height);
  return block;
}

struct Accelerations {
  double base, top;
};

/// Solves two equations of motion, which are linear in θ̈1 and θ̈2, by evaluating them.
template <class Base, class Top>
Accelerations solve(Motion s, Base base, Top top) {
  const auto at = [&](auto equation, double a1, double a2) {
    s.a1 = a1;
    s.a2 = a2;
    return equation(s);
  };
  const double p = at(base, 0, 0);
  const double q = at(top, 0, 0);
  const double b1 = at(base, 1, 0) - p;
  const double b2 = at(base, 0, 1) - p;
  const double t1 = at(top, 1, 0) - q;
  const double t2 = at(top, 0, 1) - q;
  const double determinant = b1 * t2 - b2 * t1;
  return {(b2 * q - t2 * p) / determinant, (t1 * p - b1 * q) / determinant};
}

Motion still(const Angles& u, double ground) {
  Motion s;
  s.angle = u;
  s.xg = ground;
  s.g = gravity;
  return s;
}

double base_acceleration_by_8(Reading r) {
  const Geometry q = example();
  return solve(
             still({0.05, 0.1}, -0.3 * gravity), [&](const Motion& s) { return eq8(q, s, r); },
             [&](const Motion& s) { return eq9(q, s, Reading::corrected); })
      .base;
}

double top_acceleration_by_13(Reading r) {
  const Geometry q = example();
  return solve(
             still({0.05, -0.05}, 0.3 * gravity), [&](const Motion& s) { return eq12(q, s); },
             [&](const Motion& s) { return eq13(q, s, r); })
      .top;
}

double top_acceleration_by_linear(Reading of22, Reading of23) {
  const Geometry q = example();
  return solve(
             still({0.05, -0.05}, 0), [&](const Motion& s) { return eq22(q, s, of22); },
             [&](const Motion& s) { return eq23(q, s, of23); })
      .top;
}

/// The ground acceleration, in g, that lifts the base under a top block released at rest at 0.1 rad. By Eq.
/// (18) both sides of the inequality are linear in it.
double lifting_acceleration(Printable inequality, double S, double direction, Reading r) {
  const Geometry q = example();
  const auto margin = [&](double level) {
    Motion s = still({0, S * 0.1}, direction * level * gravity);
    s.a2 = -eq18(q, s) / q.IO2;
    return inequality(q, s, r);
  };
  return margin(0) / (margin(0) - margin(1));
}

double energy_ratio(const Sides& before, const Sides& after, const Angles& u, const Velocities& minus,
                    const Velocities& plus) {
  const Geometry q = example();
  return kinetic_energy(assemble(q, after, {u, plus})) / kinetic_energy(assemble(q, before, {u, minus}));
}

double base_kept_by_56(Reading r) {
  const Geometry q = example();
  return eqs52_and_53(q, eqs56_to_60(q, {0, 0.1}, r)).A;
}

double base_kept_by_99(Reading r) {
  const Geometry q = example();
  Es e = eqs99_to_104(q, {0, -0.1}, Reading::corrected);
  e.E1 = eq99(q, {0, -0.1}, r);
  return eqs93_and_94(q, e).A;
}

double energy_by_104(Reading r) {
  const Geometry q = example();
  const Angles u{0, -0.1};
  const Velocities minus{-1, 1};
  Es e = eqs99_to_104(q, u, Reading::corrected);
  e.E6 = eq104(q, u, r);
  return energy_ratio({1, -1}, {-1, -1}, u, minus, apply(eqs93_and_94(q, e), minus));
}

/// θ̇1⁺ after blocks meet that already turn together at 1 rad/s.
double null_impact(Reading of107, Reading of122) {
  const Geometry q = example();
  const Angles u{0.05, 0.05};
  Es e = eqs117_to_122(q, u, Reading::corrected);
  e.E6 = eqs117_to_122(q, u, of122).E6;
  return apply(eqs111_and_112(q, e, top_after(q, u, of107)), {1, 1}).base;
}

Velocities first_impact(Reading of137, Reading of138) {
  const Geometry q = example();
  Cs c = eqs136_to_140(q, of137);
  c.C3 = eqs136_to_140(q, of138).C3;
  return apply(eqs132_and_133(q, c), {1, 1});
}

double energy_after_first_impact(Reading of137, Reading of138) {
  return energy_ratio({1, 1}, {-1, -1}, {}, {1, 1}, first_impact(of137, of138));
}

double base_started_by_top(Reading of155, Reading of156) {
  const Geometry q = example();
  Cs c = eqs155_to_159(q, of155);
  c.C2 = eqs155_to_159(q, of156).C2;
  return apply(eqs151_and_152(q, c), {0, 1}).base;
}

}  // namespace

Geometry example() {
  return make_geometry(uniform(1.25, 1.25), uniform(1, 2.5));
}

double time_to_opening(double release, Printable inequality, Reading reading) {
  const Geometry q = example();
  const double step = 1e-4;
  Motion s = still({release, release}, 0);
  const auto accelerate = [&] {
    s.a1 = s.a2 = 0;
    s.a1 = s.a2 = -eq15(q, s) / q.IO;
  };
  accelerate();
  // Velocity Verlet: its error, some step² per second, is far below a step.
  for (int i = 0; s.angle.u1 * release > 0; ++i) {
    if (inequality(q, s, reading) > 0) return i * step;
    const double half = s.velocity.base + s.a1 * step / 2;
    s.angle.u1 = s.angle.u2 = s.angle.u1 + half * step;
    accelerate();
    s.velocity.base = s.velocity.top = half + s.a1 * step / 2;
  }
  return std::numeric_limits<double>::infinity();
}

std::vector<Effect> effects() {
  constexpr Reading print = Reading::printed;
  constexpr Reading right = Reading::corrected;
  return {
      {"(8)", base_acceleration_by_8(print), base_acceleration_by_8(right)},
      {"(13)", top_acceleration_by_13(print), top_acceleration_by_13(right)},
      {"(22)", top_acceleration_by_linear(print, right), top_acceleration_by_linear(right, right)},
      {"(23)", top_acceleration_by_linear(right, print), top_acceleration_by_linear(right, right)},
      {"(32)", time_to_opening(0.15, eq32, print), time_to_opening(0.15, eq32, right)},
      {"(33)", time_to_opening(-0.15, eq33, print), time_to_opening(-0.15, eq33, right)},
      {"(35)", lifting_acceleration(eq35, 1, -1, print), lifting_acceleration(eq35, 1, -1, right)},
      {"(38)", lifting_acceleration(eq38, -1, -1, print), lifting_acceleration(eq38, -1, -1, right)},
      {"(56)", base_kept_by_56(print), base_kept_by_56(right)},
      {"(99)", base_kept_by_99(print), base_kept_by_99(right)},
      {"(104)", energy_by_104(print), energy_by_104(right)},
      {"(107)", null_impact(print, right), null_impact(right, right)},
      {"(122)", null_impact(right, print), null_impact(right, right)},
      {"(137)", first_impact(print, right).base, first_impact(right, right).base},
      {"(138)", first_impact(right, print).base, first_impact(right, right).base},
      {"(138), energy", energy_after_first_impact(right, print), energy_after_first_impact(right, right)},
      {"(137) and (138), energy", energy_after_first_impact(print, print),
       energy_after_first_impact(right, right)},
      {"(155)", base_started_by_top(print, right), base_started_by_top(right, right)},
      {"(156)", base_started_by_top(right, print), base_started_by_top(right, right)},
  };
}

}  // namespace rockstack::paper
