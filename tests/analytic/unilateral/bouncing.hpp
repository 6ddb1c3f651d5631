#pragma once

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/analytic/unilateral/scenes.hpp"
#include "tests/analytic/unilateral/time_stepping.hpp"

namespace rockstack::testing {

/// A scene whose points bounce, with the same friction at all interfaces.
inline Scene bouncing(Scene scene, double restitution, double friction) {
  scene = with_friction(std::move(scene), friction);
  scene.point_restitution = restitution;
  return scene;
}

/// A block of 1 m × 0.5 m that falls.
inline Scene dropped(double restitution, double height, double duration, double friction = 0.5) {
  Scene scene = bouncing(single(0.5, 0.25, duration), restitution, friction);
  scene.initial.gaps = {height};
  return scene;
}

/// A stack of blocks of unlike widths that starts above the ground and turns, with coefficients drawn.
inline Scene random_bounces(std::uint64_t seed, bool rubs) {
  Draw draw(seed);
  const auto blocks = 1 + static_cast<std::size_t>(draw.below(3));
  std::vector<Block> stack;
  for (std::size_t k = 0; k < blocks; ++k)
    stack.push_back(block(draw.between(0.6, 1.4), draw.between(0.3, 1.2)));
  Scene scene = bouncing(released(stack, std::vector<double>(blocks, 0), 1), 0, 0);
  scene.initial.gaps.assign(blocks, 0);
  scene.point_restitution = draw.between(0, 0.9);
  for (std::size_t k = 0; k < blocks; ++k) {
    if (rubs) scene.friction[k] = draw.between(0.05, 1);
    scene.initial.angles[k] = draw.between(-0.1, 0.1);
    scene.initial.velocities[k] = draw.between(-0.5, 0.5);
    scene.initial.gaps[k] = draw.between(0.05, 0.3);
  }
  return scene;
}

/// Whether an event gains kinetic energy, beyond rounding.
inline bool gains(const Scene& scene, const Event& event) {
  const double before = energy(scene, bodies_before(event));
  return energy(scene, bodies_after(event)) > before + 1e-10 * std::abs(before);
}

/// Ends a motion where Moreau's time steps with the same laws do, within what steps of first order leave. How
/// many impacts it has.
inline std::size_t expect_as_stepped(const Scene& scene, const History& exact, double step) {
  const Bodies<> stepped = time_stepped(scene, step), last = bodies_at_end(exact);
  for (std::size_t k = 0; k < scene.blocks.size(); ++k) {
    EXPECT_NEAR(last.pose[k].x, stepped.pose[k].x, 100 * step);
    EXPECT_NEAR(last.pose[k].y, stepped.pose[k].y, 100 * step);
    EXPECT_NEAR(last.pose[k].angle, stepped.pose[k].angle, 300 * step);
  }
  return static_cast<std::size_t>(std::ranges::count(exact.events, EventKind::impact, &Event::kind));
}

/// The lower corner of a block that leans and meets the ground, at (x, y) from its centre: what impulses
/// leave is linear in them.
class LowCorner {
 public:
  LowCorner(const Block& block, double angle) : block_(block) {
    const double side = angle > 0 ? 1 : -1;
    x_ = block.half_width * side * std::cos(angle) - block.half_height * std::sin(angle);
    y_ = -block.half_height * std::cos(angle) - block.half_width * side * std::sin(angle);
    uu_ = 1 / block.mass + y_ * y_ / block.inertia;
    vv_ = 1 / block.mass + x_ * x_ / block.inertia;
    uv_ = -x_ * y_ / block.inertia;
  }

  struct Impulse {
    double normal, along;
  };

  /// Velocity of the corner, along the ground and up; angles are clockwise positive.
  double along(const Pose<>& rate) const { return rate.x + y_ * rate.angle; }
  double up(const Pose<>& rate) const { return rate.y - x_ * rate.angle; }

  Pose<> after(const Pose<>& before, const Impulse& impulse) const {
    return {before.x + impulse.along / block_.mass, before.y + impulse.normal / block_.mass,
            before.angle + (y_ * impulse.along - x_ * impulse.normal) / block_.inertia};
  }

  /// By Newton's and Coulomb's laws v + vv N + uv T = −e v, and u + uv N + uu T = 0 where it sticks; the one
  /// case of three holds that obeys.
  Impulse newton(const Pose<>& before, double e, double friction) const {
    const double u = along(before), v = up(before), determinant = vv_ * uu_ - uv_ * uv_;
    const Impulse sticks{(-(1 + e) * v * uu_ + u * uv_) / determinant,
                         (-u * vv_ + (1 + e) * v * uv_) / determinant};
    if (std::abs(sticks.along) <= friction * sticks.normal) return sticks;
    const double sign = sticks.along > 0 ? 1 : -1;
    const double normal = -(1 + e) * v / (vv_ + sign * friction * uv_);
    return {normal, sign * friction * normal};
  }

  /// By Poisson's: what ends the approach, N, and then e N, each with Coulomb's friction of its own.
  Impulse poisson(const Pose<>& before, double e, double friction) const {
    const Impulse first = newton(before, 0, friction);
    const double back = e * first.normal;
    const double stops = -(along(after(before, first)) + uv_ * back) / uu_;
    return {first.normal + back, first.along + std::clamp(stops, -friction * back, friction * back)};
  }

 private:
  Block block_;
  double x_, y_, uu_, vv_, uv_;
};

}  // namespace rockstack::testing
