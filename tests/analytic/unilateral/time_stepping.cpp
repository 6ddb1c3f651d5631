#include "tests/analytic/unilateral/time_stepping.hpp"

#include <algorithm>
#include <cmath>

namespace rockstack::testing {
namespace {

struct Vec {
  double x, y;
};
double dot(const Vec& a, const Vec& b) {
  return a.x * b.x + a.y * b.y;
}
double cross(const Vec& a, const Vec& b) {
  return a.x * b.y - a.y * b.x;
}
Vec combined(double first, const Vec& a, double second, const Vec& b) {
  return {first * a.x + second * b.x, first * a.y + second * b.y};
}

/// A block that turns counterclockwise by −angle.
struct Body {
  double mass, inertia;
  Vec at, velocity;
  double turn, spin;

  Vec along() const { return {std::cos(turn), std::sin(turn)}; }
  Vec up() const { return {-std::sin(turn), std::cos(turn)}; }
  Vec point(double x, double y) const {
    return {at.x + x * along().x + y * up().x, at.y + x * along().y + y * up().y};
  }
};

/// Where two bodies touch; the lower one may be the ground.
struct Touching {
  Body* upper;
  Body* lower;  ///< null: the ground
  Vec where, normal, tangent;
  double friction;
  int pair = 0;  ///< of a pair of corners: its side, −1 or 1; normal and tangent are those of the lower face
  double push = 0, rub = 0;  ///< impulses, N·s
  double bounce = 0;         ///< velocity across the face that is left at least, m/s
  double given = 0;          ///< by Poisson's law: normal impulse that expansion gives back, N·s

  Vec relative_velocity() const {
    const auto of = [&](const Body& body) {
      const Vec arm{where.x - body.at.x, where.y - body.at.y};
      return Vec{body.velocity.x - body.spin * arm.y, body.velocity.y + body.spin * arm.x};
    };
    const Vec above = of(*upper);
    const Vec below = lower ? of(*lower) : Vec{0, 0};
    return {above.x - below.x, above.y - below.y};
  }
  /// What an impulse along `cause` changes of the velocity along `effect`.
  double mobility(const Vec& effect, const Vec& cause) const {
    double sum = 0;
    for (const Body* body : {upper, lower}) {
      if (!body) continue;
      const Vec arm{where.x - body->at.x, where.y - body->at.y};
      sum += dot(effect, cause) / body->mass + cross(arm, effect) * cross(arm, cause) / body->inertia;
    }
    return sum;
  }
  void apply(const Vec& direction, double impulse) const {
    const auto to = [&](Body& body, double signed_impulse) {
      body.velocity.x += signed_impulse * direction.x / body.mass;
      body.velocity.y += signed_impulse * direction.y / body.mass;
      body.spin +=
          signed_impulse * cross({where.x - body.at.x, where.y - body.at.y}, direction) / body.inertia;
    };
    to(*upper, impulse);
    if (lower) to(*lower, -impulse);
  }
  /// How much the impulses change.
  double relax() {
    const double push_before = push;
    const double rub_before = rub;
    if (pair != 0) {
      apply(normal, -push);
      apply(tangent, -rub);
      const Vec impulse = pair_impulse(relative_velocity());
      push = dot(impulse, normal);
      rub = dot(impulse, tangent);
      apply(normal, push);
      apply(tangent, rub);
    } else {
      push = std::max(0.0, push + (bounce - dot(relative_velocity(), normal)) / mobility(normal, normal));
      apply(normal, push - push_before);
      const double limit = friction * (given + push);
      rub = std::clamp(rub - dot(relative_velocity(), tangent) / mobility(tangent, tangent), -limit, limit);
      apply(tangent, rub - rub_before);
    }
    return std::abs(push - push_before) + std::abs(rub - rub_before);
  }

  /// Coulomb's law on one face, for a velocity without impulse: the impulse, and the way it slides, 0 where
  /// it sticks or parts.
  struct OnFace {
    Vec impulse;
    int slip;
  };
  OnFace on_face(const Vec& velocity, const Vec& across, const Vec& along) const {
    const double approach = -dot(velocity, across);
    if (approach <= 0) return {{0, 0}, 0};
    const double nn = mobility(across, across);
    const double nt = mobility(across, along);
    const double tt = mobility(along, along);
    const double drift = -dot(velocity, along);
    const double stuck_push = (approach * tt - drift * nt) / (nn * tt - nt * nt);
    const double stuck_rub = (drift * nn - approach * nt) / (nn * tt - nt * nt);
    if (std::abs(stuck_rub) <= friction * stuck_push)
      return {combined(stuck_push, across, stuck_rub, along), 0};
    const int slip = stuck_rub > 0 ? -1 : 1;
    const double slid_push = approach / (nn - friction * slip * nt);
    return {combined(slid_push, across, -friction * slip * slid_push, along), slip};
  }

  /// Impulse on a pair of corners, for a velocity without impulse: inward it slides along the lower face,
  /// outward the upper one.
  Vec pair_impulse(const Vec& velocity) const {
    const OnFace lower_face = on_face(velocity, normal, tangent);
    const bool parts = lower_face.impulse.x == 0 && lower_face.impulse.y == 0;
    if (parts || lower_face.slip == -pair) return lower_face.impulse;
    const bool outward = lower_face.slip != 0 || -pair * dot(lower_face.impulse, upper->along()) >
                                                     friction * dot(lower_face.impulse, upper->up());
    return outward ? on_face(velocity, upper->up(), upper->along()).impulse : lower_face.impulse;
  }
};

/// A corner of the upper block over the lower one's top, or of the lower one under the upper one's bottom, or
/// both corners at one place. `reach` is how far apart, m, counts as touching.
void add_corners(const Scene& scene, std::vector<Body>& bodies, std::size_t k, double friction, double reach,
                 std::vector<Touching>& touching) {
  const Block& block = scene.blocks[k];
  Body& upper = bodies[k];
  Body* lower = k > 0 ? &bodies[k - 1] : nullptr;
  for (const int side : {-1, 1}) {
    const Vec corner = upper.point(side * block.half_width, -block.half_height);
    if (!lower) {
      if (corner.y <= reach) touching.push_back({&upper, nullptr, corner, {0, 1}, {1, 0}, friction});
      continue;
    }
    const Block& base = scene.blocks[k - 1];
    const Vec other = lower->point(side * base.half_width, base.half_height);
    const Vec drift{corner.x - other.x, corner.y - other.y};
    // Blocks that turn drift apart by some ω²b dt²/2 in a step, which in time would make a pair one corner's
    // contact. So pairs come together anew, until a slip takes them further.
    if (std::hypot(drift.x, drift.y) <= reach) {
      for (std::size_t above = k; above < bodies.size(); ++above)
        bodies[above].at = {bodies[above].at.x - drift.x, bodies[above].at.y - drift.y};
      touching.push_back({&upper, lower, corner, lower->up(), lower->along(), friction, side});
      continue;
    }
    const Vec on_base{corner.x - lower->at.x, corner.y - lower->at.y};
    if (dot(on_base, lower->up()) <= base.half_height + reach &&
        std::abs(dot(on_base, lower->along())) <= base.half_width)
      touching.push_back({&upper, lower, corner, lower->up(), lower->along(), friction});
    const Vec on_block{other.x - upper.at.x, other.y - upper.at.y};
    if (dot(on_block, upper.up()) + reach >= -block.half_height &&
        std::abs(dot(on_block, upper.along())) <= block.half_width)
      touching.push_back({&upper, lower, other, upper.up(), upper.along(), friction});
  }
}

}  // namespace

Bodies<> time_stepped(const Scene& scene, double step, double stop) {
  Scene start = scene;
  start.duration = 1e-9 * scene.duration;
  const Bodies<> first = bodies_at(solve_unilateral(start, {.sample_times = {0}}), 0);
  std::vector<Body> bodies;
  for (std::size_t k = 0; k < scene.blocks.size(); ++k) {
    const Block& block = scene.blocks[k];
    bodies.push_back({block.mass,
                      block.inertia,
                      {first.pose[k].x, first.pose[k].y},
                      {first.velocity[k].x, first.velocity[k].y},
                      -first.pose[k].angle,
                      -first.velocity[k].angle});
  }
  const auto move = [&](double time) {
    for (Body& body : bodies) {
      body.at.x += time * body.velocity.x;
      body.at.y += time * body.velocity.y;
      body.turn += time * body.spin;
    }
  };
  const auto steps = static_cast<int>(std::lround(scene.duration / step));
  const double length = scene.duration / steps;
  // Twice a step's fall, so that what steps leave out does not decide whether a corner touches.
  const double reach = scene.gravity * length * length;
  std::vector<Touching> touching;
  for (int i = 0; i < steps; ++i) {
    move(length / 2);
    const double middle = (i + 0.5) * length;
    touching.clear();
    for (std::size_t k = 0; k < bodies.size(); ++k)
      add_corners(scene, bodies, k, scene.friction[k], reach, touching);
    const bool expands = scene.restitution_law == RestitutionLaw::poisson;
    for (Touching& point : touching)
      if (!expands)
        point.bounce = scene.point_restitution * std::max(0.0, -dot(point.relative_velocity(), point.normal));
    for (Body& body : bodies) {
      body.velocity.x -= length * acceleration(scene.horizontal, middle);
      body.velocity.y -= length * (scene.gravity + acceleration(scene.vertical, middle));
    }
    double scale = 0;
    for (const Body& body : bodies) scale += body.mass * scene.gravity * length;
    const auto relax = [&] {
      for (int sweep = 0; sweep < 1000; ++sweep) {
        double change = 0;
        for (Touching& point : touching) change += point.relax();
        if (change <= stop * scale) break;
      }
    };
    relax();
    if (expands) {
      for (Touching& point : touching) {
        if (point.pair != 0) continue;
        point.given = scene.point_restitution * point.push;
        point.push = point.rub = 0;
        point.apply(point.normal, point.given);
      }
      relax();
    }
    move(length / 2);
  }
  Bodies<> last;
  for (const Body& body : bodies) {
    last.pose.push_back({body.at.x, body.at.y, -body.turn});
    last.velocity.push_back({body.velocity.x, body.velocity.y, -body.spin});
  }
  return last;
}

}  // namespace rockstack::testing
