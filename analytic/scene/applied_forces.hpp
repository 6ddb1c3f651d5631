#pragma once

#include "analytic/scene/kinematics.hpp"

namespace rockstack {

// Forces at points of blocks besides contact and weight: mechanics, series of steps and free bodies take them
// from here.

/// Where a push acts, and which way.
template <class Real>
struct PushPoint {
  int block;              ///< from 0
  Point<Real> arm;        ///< from the block's centre of mass, in its frame, m
  Point<Real> direction;  ///< on the ground's axes
};

template <class Real>
std::vector<PushPoint<Real>> push_points(const Scene& scene) {
  std::vector<PushPoint<Real>> points;
  points.reserve(scene.pushes.size());
  for (const Push& push : scene.pushes) {
    const Block& block = scene.blocks[static_cast<std::size_t>(push.point.block) - 1];
    const Real up = Real(push.point.y) - (Real(block.half_height) + Real(block.offset_y));
    using std::cos, std::sin;
    points.push_back({push.point.block - 1,
                      {Real(push.point.x) - Real(block.offset_x), up},
                      {cos(Real(push.direction)), sin(Real(push.direction))}});
  }
  return points;
}

/// What acts on a stack at an instant: the ground's acceleration (ẍg, ÿg), m/s², and the sizes of pushes, N;
/// or what changes velocities at once: steps of the ground's velocity, m/s, and impulses, N·s.
template <class Real>
struct Loading {
  Point<Real> ground;
  std::size_t pushes = 0;
  std::array<Real, max_pushes> sizes;  ///< of so many pushes

  template <class Derived>
  Loading(const Eigen::MatrixBase<Derived>& acceleration) : ground(acceleration) {}
  Loading(const Real& x, const Real& y) : ground(x, y) {}
};

/// The loading of a scene at a time, in s, with gravity along its ground as an acceleration the other way.
template <class Real = double>
Loading<Real> loading_at(const Scene& scene, double time) {
  Loading<Real> loading{Real(acceleration(scene.horizontal, time) - gravity_of(scene).along),
                        Real(acceleration(scene.vertical, time))};
  for (const Push& push : scene.pushes)
    loading.sizes[loading.pushes++] = Real(acceleration(push.force, time));
  return loading;
}

/// Calls f with the block of each push, its force on the ground's axes, and its clockwise moment about the
/// centre of mass; `turn` maps a block's own vector to where the block stands.
template <class Real, class Turn, class F>
void each_push(const std::vector<PushPoint<Real>>& points, const Loading<Real>& loading, const Turn& turn,
               const F& f) {
  for (std::size_t i = 0; i < loading.pushes; ++i) {
    const PushPoint<Real>& point = points[i];
    const Point<Real> force = loading.sizes[i] * point.direction;
    f(point.block, force, quarter_turned<Real>(turn(point.block, point.arm)).dot(force));
  }
}

}  // namespace rockstack
