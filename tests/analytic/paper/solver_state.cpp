#include "tests/analytic/paper/solver_state.hpp"

namespace rockstack::paper {

Model<double> model_of(const Geometry& q, double gravity, Equations equations) {
  Scene scene;
  scene.gravity = gravity;
  scene.equations = equations;
  scene.blocks = {{q.b1, q.h1, q.m1, q.IG1}, {q.b2, q.h2, q.m2, q.IG2}};
  return make_model<double>(scene);
}

Model<double> model_of(const Geometry& q, const Motion& s, Equations equations) {
  return model_of(q, s.g, equations);
}

Pattern pattern_with(double base, double top) {
  Pattern pattern = closed_pattern(2);
  pattern[0] = contact_of(static_cast<int>(base));
  pattern[1] = contact_of(static_cast<int>(top));
  return pattern;
}

State<double> state_of(const Pattern& pattern, const Motion& s) {
  Vector<double> angles(2);
  Vector<double> rates(2);
  angles << s.angle.u1, s.angle.u2;
  rates << s.velocity.base, s.velocity.top;
  return {pattern, relative(angles), relative(rates)};
}

}  // namespace rockstack::paper
