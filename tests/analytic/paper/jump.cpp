#include "tests/analytic/paper/jump.hpp"

#include <cmath>

namespace rockstack::paper {
namespace {

Assembly moving(const Jump& jump, const Draw& d, When when, const Velocities& rates) {
  return assemble(d.q, when == When::before ? jump.before : jump.after, {jump.angles(d), rates});
}

/// Where Cramer's rule divides by a small determinant, its rounding grows by this.
double amplification(const Jump& jump, const Draw& d) {
  if (jump.leaving != Freedom::both)
    return inertia_size(d.q) / (jump.leaving == Freedom::joined ? d.q.IO : d.q.IO2);
  const double system = momentum(jump, d, When::after, About::system, {1, 0});
  const double system_top = momentum(jump, d, When::after, About::system, {0, 1});
  const double top = momentum(jump, d, When::after, About::top, {1, 0});
  const double determinant = system * d.q.IO2 - system_top * top;
  return inertia_size(d.q) * inertia_size(d.q) / std::abs(determinant);
}

}  // namespace

Angles base_hits_from_1(const Draw& d) {
  return {0, d.opening};
}
Angles base_hits_from_2(const Draw& d) {
  return {0, -d.opening};
}
Angles blocks_meet(const Draw& d) {
  return {d.lean, d.lean};
}
Angles flat(const Draw&) {
  return {};
}

Velocities coming(const Jump& jump, const Draw& d) {
  if (jump.coming == Coming::joined) return {d.minus.base, d.minus.base};
  if (jump.coming == Coming::top_only) return {0, d.minus.top};
  return d.minus;
}

double momentum(const Jump& jump, const Draw& d, When when, About about, const Velocities& rates) {
  const Assembly blocks = moving(jump, d, when, rates);
  if (about == About::system) return angular_momentum(blocks, ground_corner(d.q, jump.after.base));
  return angular_momentum(blocks.top, jump.after.top > 0 ? blocks.top_right : blocks.top_left);
}

double momentum_error(const Jump& jump, const Draw& d, const Momentum& printed, When when, About about) {
  Velocities plus = d.plus;
  if (jump.leaving == Freedom::joined) plus.top = plus.base;
  if (jump.leaving == Freedom::top_only) plus.base = 0;
  const Velocities minus = coming(jump, d);
  const double expected = momentum(jump, d, when, about, when == When::before ? minus : plus);
  return std::abs(value(printed, minus, plus) - expected) / inertia_size(d.q);
}

double coefficient_error(const Jump& jump, const Draw& d, double printed, When when, About about,
                         const Velocities& unit) {
  return std::abs(printed - momentum(jump, d, when, about, unit)) / inertia_size(d.q);
}

double conservation_error(const Jump& jump, const Draw& d, About about) {
  const Velocities minus = coming(jump, d);
  const Assembly before = moving(jump, d, When::before, minus);
  const Velocities plus = nearest_in_energy(d.q, before, jump.after, jump.angles(d), jump.leaving);
  const double change =
      momentum(jump, d, When::after, about, plus) - momentum(jump, d, When::before, about, minus);
  return std::abs(change) / (inertia_size(d.q) * amplification(jump, d));
}

Errors velocity_errors(const Jump& jump, const Draw& d, const Velocities& minus, const Velocities& printed) {
  const Assembly before = moving(jump, d, When::before, minus);
  const Velocities plus = nearest_in_energy(d.q, before, jump.after, jump.angles(d), jump.leaving);
  const double size = amplification(jump, d);
  return {std::abs(printed.base - plus.base) / size, std::abs(printed.top - plus.top) / size};
}

}  // namespace rockstack::paper
