#include "tests/analytic/paper/draw.hpp"

#include <cmath>

namespace rockstack::paper {
namespace {

double between(std::mt19937_64& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

Block random_block(std::mt19937_64& random, double half_width) {
  Block block;
  block.half_width = half_width;
  block.half_height = between(random, 0.2, 3);
  block.mass = between(random, 500, 4000) * 4 * block.half_width * block.half_height;
  block.inertia = between(random, 0.5, 1.5) * block.mass *
                  (block.half_width * block.half_width + block.half_height * block.half_height) / 3;
  return block;
}

}  // namespace

Draw draw(std::mt19937_64& random) {
  Draw d;
  const Block base = random_block(random, between(random, 0.2, 2));
  const Block top = random_block(random, between(random, 0.2, 1) * base.half_width);
  d.q = make_geometry(base, top);
  d.S = between(random, -1, 1) < 0 ? -1 : 1;
  d.lean = between(random, 0.01, 0.6);
  d.opening = between(random, 0.01, 0.6);
  d.motion.velocity = {between(random, -3, 3), between(random, -3, 3)};
  d.motion.a1 = between(random, -20, 20);
  d.motion.a2 = between(random, -20, 20);
  d.motion.xg = between(random, -10, 10);
  d.motion.yg = between(random, -10, 10);
  d.motion.g = between(random, 1, 15);
  d.minus = {between(random, -3, 3), between(random, -3, 3)};
  d.plus = {between(random, -3, 3), between(random, -3, 3)};
  return d;
}

Motion in_pattern_1(const Draw& d) {
  Motion s = d.motion;
  s.angle = {d.S * d.lean, d.S * (d.lean + d.opening)};
  return s;
}

Motion in_pattern_2(const Draw& d) {
  Motion s = d.motion;
  s.angle = {d.S * d.lean, d.S * (d.lean - d.opening)};
  return s;
}

Motion in_pattern_3(const Draw& d) {
  Motion s = d.motion;
  s.angle = {d.S * d.lean, d.S * d.lean};
  s.velocity.top = s.velocity.base;
  s.a2 = s.a1;
  return s;
}

Motion in_pattern_4(const Draw& d) {
  Motion s = d.motion;
  s.angle = {0, d.S * d.opening};
  s.velocity.base = 0;
  s.a1 = 0;
  return s;
}

Motion upright(Motion motion) {
  motion.angle = {};
  motion.velocity = {};
  return motion;
}

double moment_size(const Geometry& q, const Motion& s) {
  const double length = q.b1 + q.b2 + 2 * (q.h1 + q.h2);
  const double rates = s.velocity.base * s.velocity.base + s.velocity.top * s.velocity.top;
  const double inertial = length * (std::abs(s.a1) + std::abs(s.a2) + rates);
  return q.M * length * (inertial + std::abs(s.xg) + std::abs(s.yg) + s.g);
}

double inertia_size(const Geometry& q) {
  const double length = q.b1 + q.b2 + 2 * (q.h1 + q.h2);
  return q.M * length * length;
}

}  // namespace rockstack::paper
