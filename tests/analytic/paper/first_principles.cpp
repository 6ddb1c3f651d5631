#include "tests/analytic/paper/first_principles.hpp"

#include <array>
#include <cmath>

namespace rockstack::paper {
namespace {

Vec turned(Vec v, double angle) {
  return {v.x * std::cos(angle) + v.y * std::sin(angle), v.y * std::cos(angle) - v.x * std::sin(angle)};
}

/// Velocity at the end of an arm that turns clockwise at unit rate.
Vec swept(Vec arm) {
  return {arm.y, -arm.x};
}

Vec acceleration(Vec arm, double rate, double spin) {
  return spin * swept(arm) - rate * rate * arm;
}

double dot(Vec a, Vec b) {
  return a.x * b.x + a.y * b.y;
}

struct PointMass {
  double mass;
  Vec place, velocity;
};

std::array<PointMass, 2> as_points(const Body& body) {
  const Vec offset{std::sqrt(body.inertia / body.mass), 0};
  const auto at = [&](Vec arm) {
    return PointMass{body.mass / 2, body.centre + arm, body.velocity + body.rate * swept(arm)};
  };
  return {at(offset), at(-1.0 * offset)};
}

/// Inertia force on a body, turned round, and its weight, in the frame of the ground.
Vec needed_force(const Body& body, const Motion& motion) {
  return body.mass * (body.acceleration + Vec{motion.xg, motion.yg + motion.g});
}

/// Inner product of two motions in the metric of kinetic energy.
double paired(const Body& a, const Body& b) {
  return a.mass * dot(a.velocity, b.velocity) + a.inertia * a.rate * b.rate;
}

double paired(const Assembly& a, const Assembly& b) {
  return paired(a.base, b.base) + paired(a.top, b.top);
}

}  // namespace

Vec operator+(Vec a, Vec b) {
  return {a.x + b.x, a.y + b.y};
}
Vec operator-(Vec a, Vec b) {
  return {a.x - b.x, a.y - b.y};
}
Vec operator*(double k, Vec a) {
  return {k * a.x, k * a.y};
}

double moment(Vec arm, Vec force) {
  return arm.y * force.x - arm.x * force.y;
}

Vec ground_corner(const Geometry& q, int side) {
  return {side * q.b1, 0};
}

Assembly assemble(const Geometry& q, const Sides& sides, const Motion& motion) {
  const auto [u1, u2] = motion.angle;
  const auto [w1, w2] = motion.velocity;
  Assembly blocks;
  blocks.base_pivot = ground_corner(q, sides.base);
  const Vec arm1 = turned({-sides.base * q.b1, q.h1}, u1);
  const Vec link = turned({sides.top * q.b2 - sides.base * q.b1, 2 * q.h1}, u1);
  const Vec arm2 = turned({-sides.top * q.b2, q.h2}, u2);
  blocks.top_pivot = blocks.base_pivot + link;
  blocks.top_right = blocks.top_pivot + turned({(1 - sides.top) * q.b2, 0}, u2);
  blocks.top_left = blocks.top_pivot + turned({(-1 - sides.top) * q.b2, 0}, u2);
  blocks.base = {
      q.m1, q.IG1,    blocks.base_pivot + arm1, w1 * swept(arm1), acceleration(arm1, w1, motion.a1),
      w1,   motion.a1};
  blocks.top = {q.m2,
                q.IG2,
                blocks.top_pivot + arm2,
                w1 * swept(link) + w2 * swept(arm2),
                acceleration(link, w1, motion.a1) + acceleration(arm2, w2, motion.a2),
                w2,
                motion.a2};
  return blocks;
}

double angular_momentum(const Body& body, Vec about) {
  double sum = 0;
  for (const PointMass& p : as_points(body)) sum += moment(p.place - about, p.mass * p.velocity);
  return sum;
}

double angular_momentum(const Assembly& blocks, Vec about) {
  return angular_momentum(blocks.base, about) + angular_momentum(blocks.top, about);
}

double kinetic_energy(const Body& body) {
  double sum = 0;
  for (const PointMass& p : as_points(body)) sum += p.mass * dot(p.velocity, p.velocity) / 2;
  return sum;
}

double kinetic_energy(const Assembly& blocks) {
  return kinetic_energy(blocks.base) + kinetic_energy(blocks.top);
}

double moment_on_top(const Assembly& blocks, const Motion& motion, Vec about) {
  return blocks.top.inertia * blocks.top.spin +
         moment(blocks.top.centre - about, needed_force(blocks.top, motion));
}

double moment_on_base(const Assembly& blocks, const Motion& motion) {
  return blocks.base.inertia * blocks.base.spin +
         moment(blocks.base.centre - blocks.base_pivot, needed_force(blocks.base, motion)) +
         moment(blocks.top_pivot - blocks.base_pivot, needed_force(blocks.top, motion));
}

double moment_on_both(const Assembly& blocks, const Motion& motion) {
  return blocks.base.inertia * blocks.base.spin +
         moment(blocks.base.centre - blocks.base_pivot, needed_force(blocks.base, motion)) +
         moment_on_top(blocks, motion, blocks.base_pivot);
}

Velocities nearest_in_energy(const Geometry& q, const Assembly& before, const Sides& sides,
                             const Angles& angles, Freedom freedom) {
  const auto moving = [&](Velocities rates) { return assemble(q, sides, {angles, rates}); };
  if (freedom != Freedom::both) {
    const Assembly way = moving({freedom == Freedom::joined ? 1.0 : 0.0, 1});
    const double rate = paired(way, before) / paired(way, way);
    return {freedom == Freedom::joined ? rate : 0, rate};
  }
  const Assembly first = moving({1, 0});
  const Assembly second = moving({0, 1});
  const double m11 = paired(first, first);
  const double m12 = paired(first, second);
  const double m22 = paired(second, second);
  const double p1 = paired(first, before);
  const double p2 = paired(second, before);
  const double determinant = m11 * m22 - m12 * m12;
  return {(m22 * p1 - m12 * p2) / determinant, (m11 * p2 - m12 * p1) / determinant};
}

}  // namespace rockstack::paper
